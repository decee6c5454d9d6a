#include "app/cli/port_option.hpp"

#include <fmt/format.h>

#include "app/cli/arguments.hpp"
#include "support/edits.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

void add_port_option(CLI::App& command, std::string& name,
                     std::initializer_list<const char*> excluded) {
  auto* option = command
                     .add_option("--rule", name,
                                 "expected rule of a program, such as doom, instead of general "
                                 "rules; `check --help` lists them")
                     ->check(not_empty());
  for (const char* other : excluded) option->excludes(command.get_option(other));
}

check::Rules port_rules_named(const std::string& name, const cases::Variant& variant) {
  std::string known;
  std::vector<std::string> names;
  for (const check::PortRule& rule : check::port_rules()) {
    if (!rule.is_for(variant)) continue;
    if (rule.name == name) return check::rules_of(rule, variant.format);
    known += fmt::format("{}{}", known.empty() ? "" : ", ", rule.name);
    names.emplace_back(rule.name);
  }
  const std::string of =
      fmt::format("{} in {}", cases::name_of(variant.operation), cases::name_of(variant.format));
  throw support::UsageError(
      known.empty() ? fmt::format("--rule {}: no program has a rule for {}; leave it out",
                                  support::quoted(name), of)
                    : fmt::format("--rule {}: for {} choose one of {}{}", support::quoted(name), of,
                                  known, support::suggestion(name, names)));
}

std::string port_text(const check::PortRule& rule) {
  return fmt::format("the rule {} ({})", rule.name, rule.routine);
}

}  // namespace fixproof::cli

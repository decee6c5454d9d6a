/// @file
/// Rules by the names that options take.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "judge/check/rules.hpp"
#include "support/edits.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

/// Returns the rule of `rules` with this name, or `any` for the name `any`.
/// @param more a name that the caller takes, for the error
/// @throws UsageError naming the option and the rules
template <class Rule>
Rule rule_named(std::string_view option, std::string_view name, std::span<const Rule> rules,
                std::optional<Rule> any = std::nullopt, std::string_view more = "") {
  std::string all;
  std::vector<std::string> names;
  for (const Rule rule : rules) {
    if (check::name_of(rule) == name) return rule;
    all += fmt::format("{}, ", check::name_of(rule));
    names.emplace_back(check::name_of(rule));
  }
  if (any && name == "any") return *any;
  if (any) all += "any, ";
  if (!more.empty()) all += fmt::format("{}, ", more);
  if (!more.empty()) names.emplace_back(more);
  all.resize(all.size() - 2);
  throw support::UsageError(fmt::format("{} {}: choose one of {}{}", option, support::quoted(name),
                                        all, support::suggestion(name, names)));
}

}  // namespace fixproof::cli

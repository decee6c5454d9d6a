#include "app/cli/option_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

namespace fixproof::cli {

namespace {

std::vector<const CLI::Option*> by_name(const std::set<CLI::Option*>& options) {
  std::vector<const CLI::Option*> sorted(options.begin(), options.end());
  std::sort(sorted.begin(), sorted.end(), [](const CLI::Option* a, const CLI::Option* b) {
    return a->get_name() < b->get_name();
  });
  return sorted;
}

/// Returns `text` with the names after `label`, which end it or the line, in alphabetical order.
std::string with_sorted(const std::string& text, const std::string& label,
                        const std::set<CLI::Option*>& options) {
  if (options.empty()) return text;
  std::string given = label;
  for (const CLI::Option* option : options) given += " " + option->get_name();
  std::string sorted = label;
  for (const CLI::Option* option : by_name(options)) sorted += " " + option->get_name();
  const std::size_t begin = text.find(given);
  return begin == std::string::npos ? text : std::string(text).replace(begin, given.size(), sorted);
}

}  // namespace

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  const std::string text = CLI::Formatter::make_option_opts(option);
  return with_sorted(with_sorted(text, " Needs:", option->get_needs()),
                     " Excludes:", option->get_excludes());
}

std::string exclusion_in(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands()) {
    for (const CLI::Option* option : command->get_options()) {
      if (option->count() == 0) continue;
      for (const CLI::Option* other : by_name(option->get_excludes())) {
        if (other->count() == 0) continue;
        return fmt::format("{} excludes {}", option->get_name(), other->get_name());
      }
    }
  }
  return "two of the options exclude each other";
}

void put_under(CLI::App& command, const char* heading, std::initializer_list<const char*> names) {
  for (const char* name : names) command.get_option(name)->group(heading);
}

}  // namespace fixproof::cli

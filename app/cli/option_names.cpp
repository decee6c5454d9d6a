#include "app/cli/option_names.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <set>
#include <sstream>
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

/// The width of the terminal, or COLUMNS; 0 without either, so that programs get whole lines.
std::size_t help_width() {
  if (const char* const columns = std::getenv("COLUMNS")) {
    std::size_t width = 0;
    std::from_chars(columns, columns + std::strlen(columns), width);
    return width;
  }
  winsize window{};
  return ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 ? window.ws_col : 0;
}

/// Returns `text` in lines that fit beside a column. Without room for a few words, one line.
std::string wrapped(const std::string& text, std::size_t width, std::size_t column) {
  constexpr std::size_t least = 20;
  if (width < column + least) return text;
  std::string lines;
  std::size_t used = 0;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (used > 0 && column + used + 1 + word.size() > width) {
      lines += '\n';
      used = 0;
    }
    lines += (used > 0 ? " " : "") + word;
    used += (used > 0 ? 1 : 0) + word.size();
  }
  return lines;
}

}  // namespace

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  const std::string text = CLI::Formatter::make_option_opts(option);
  return with_sorted(with_sorted(text, " Needs:", option->get_needs()),
                     " Excludes:", option->get_excludes());
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  return wrapped(CLI::Formatter::make_option_desc(option), help_width(), get_column_width());
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  const std::size_t column = get_column_width();
  std::string text = wrapped(command->get_description(), help_width(), column);
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
    text.insert(at + 1, column, ' ');
  }
  return fmt::format("{:<{}}{}\n", "  " + command->get_name(), column, text);
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

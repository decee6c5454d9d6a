/// @file
/// Takes text apart.
#pragma once

#include <string_view>
#include <vector>

namespace fixproof::support {

/// Returns the text without the spaces at its ends.
inline std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Returns the parts of a list, trimmed; none if the list has only spaces.
inline std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  if (trimmed(text).empty()) return parts;
  for (std::size_t at = 0; at != std::string_view::npos;) {
    at = text.find(separator);
    parts.push_back(trimmed(text.substr(0, at)));
    if (at != std::string_view::npos) text.remove_prefix(at + 1);
  }
  return parts;
}

}  // namespace fixproof::support

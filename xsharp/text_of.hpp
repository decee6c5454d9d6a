/// @file
/// Builds messages from words and numbers.
#pragma once

#include <array>
#include <charconv>
#include <sstream>
#include <string>

namespace xsharp::detail {

/// Concatenates the words; numbers have up to six digits.
template <class... Words>
std::string text_of(const Words&... words) {
  std::ostringstream text;
  (text << ... << words);
  return text.str();
}

/// The shortest text that is read back as the same number.
inline std::string digits_of(double value) {
  std::array<char, 32> digits{};
  auto* const end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

}  // namespace xsharp::detail

/// @file
/// Messages from words and numbers.
#pragma once

#include <sstream>
#include <string>

namespace xsharp::detail {

/// The words in one text; numbers with up to six digits.
template <class... Words>
std::string text_of(const Words&... words) {
  std::ostringstream text;
  (text << ... << words);
  return text.str();
}

}  // namespace xsharp::detail

/// @file
/// What a stream's flags, precision and locale make of a number.
#pragma once

#include <cstddef>
#include <ios>
#include <iterator>
#include <limits>
#include <ostream>
#include <string>

#include "fixed/detail/number_text.hpp"

// The <ostream> of libstdc++ declares std::numpunct, and all of <locale> takes long to compile.
#if !defined(__GLIBCXX__)
#include <locale>
#endif

namespace fixproof::detail {

/// Inserts the separators of a std::numpunct::grouping() into a text of digits.
inline void group_digits(std::string& digits, const std::string& grouping, char separator) {
  std::size_t end = digits.size();
  for (std::size_t i = 0; i < grouping.size();) {
    const char group = grouping[i];
    if (group <= 0 || group == (std::numeric_limits<char>::max)()) return;
    const std::size_t length = static_cast<unsigned char>(group);
    if (end <= length) return;
    end -= length;
    digits.insert(end, 1, separator);
    if (i + 1 < grouping.size()) ++i;  // the last size repeats
  }
}

/// The style that the stream's flags ask for.
inline text_style style_of(const std::ios_base& stream) {
  const auto flags = stream.flags();
  const auto form = flags & std::ios_base::floatfield;
  text_style style;
  if (form == std::ios_base::fixed) style.type = 'f';
  const bool upper = (flags & std::ios_base::uppercase) != 0;
  if (form == std::ios_base::scientific) style.type = upper ? 'E' : 'e';
  // std::hexfloat sets both.
  if (form == (std::ios_base::fixed | std::ios_base::scientific)) style.type = upper ? 'A' : 'a';
  if ((flags & std::ios_base::showpos) != 0) style.plus = '+';
  style.alternate = (flags & std::ios_base::showpoint) != 0;
  // As in printf, a negative precision counts as none.
  if (stream.precision() >= 0) style.precision = static_cast<std::size_t>(stream.precision());
  return style;
}

/// The number as the stream writes it, with the padding that std::internal puts into it.
template <int FractionBits, class Stream, class Raw>
std::string stream_text(const Stream& stream, Raw raw) {
  const auto number = number_text::of<FractionBits>(raw, style_of(stream));
  const auto& punctuation = std::use_facet<std::numpunct<char>>(stream.getloc());
  std::string whole(number.whole_begin(), number.whole_end());
  group_digits(whole, punctuation.grouping(), punctuation.thousands_sep());
  std::string text;
  number.write_head(std::back_inserter(text));
  // A sign comes before the padding, and so does 0x where there is no sign.
  const std::size_t head = text.size() > 2 ? 1 : text.size();
  text += whole;
  number.write_rest(std::back_inserter(text), punctuation.decimal_point());
  const auto adjust = stream.flags() & std::ios_base::adjustfield;
  if (adjust == std::ios_base::internal && stream.width() > 0) {
    const auto width = static_cast<std::size_t>(stream.width());
    if (text.size() < width) text.insert(head, width - text.size(), stream.fill());
  }
  return text;
}

}  // namespace fixproof::detail

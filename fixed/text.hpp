/// @file
/// Exact decimal text, with the interface of `<charconv>`, and stream operators.
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>

#include "fixed/detail/decimal.hpp"
#include "fixed/detail/decimal_reader.hpp"
#include "fixed/detail/stream_text.hpp"
#include "fixed/number.hpp"

namespace fixproof {

/// A buffer size that is enough for to_chars() of any number of the type.
template <class Number>
inline constexpr std::size_t max_chars =
    detail::max_decimal_chars<typename Number::raw_type, Number::fraction_bits>;

/// Writes the exact value in its shortest form: "-0.5", "3", "0.0000152587890625".
/// @return the end of the text, or {last, errc::value_too_large} with nothing written if it does
/// not fit
///
///     std::array<char, max_chars<q16_16>> text{};
///     const auto written = to_chars(text.data(), text.data() + text.size(), q16_16(-0.5));
///     const std::string_view half(text.data(), written.ptr);  // "-0.5"
template <class Raw, int Point, policy Rules>
constexpr std::to_chars_result to_chars(char* first, char* last,
                                        number<Raw, Point, Rules> value) noexcept {
  std::array<char, detail::max_decimal_chars<Raw, Point>> text{};
  const char* begin = text.data();
  const char* end = detail::write_decimal<Point>(text.data(), value.raw());
  if (last - first < end - begin) return {last, std::errc::value_too_large};
  while (begin != end) *first++ = *begin++;
  return {first, std::errc{}};
}

/// Reads the longest prefix that is a decimal number, such as "-1.5", "3", "+.5", "3." or "2E-3",
/// and rounds it once by policy::multiply. That is the prefix which std::from_chars reads as a
/// double, and a leading `+`; infinities and NaNs are not read. Digits and exponent may be of any
/// length: the time is proportional to the length of the text, and the value of the exponent does
/// not matter.
/// @return the end of the prefix; errc::invalid_argument, with `first`, if there is none;
/// errc::result_out_of_range if the rounded value is out of range, under every policy. On an error
/// the value is unchanged.
///
///     static_assert([] {
///       constexpr std::string_view text = "0.1 and more";
///       q16_16 x;
///       return from_chars(text.data(), text.data() + text.size(), x).ptr == text.data() + 3 &&
///              x.raw() == 6554;
///     }());
template <class Raw, int Point, policy Rules>
constexpr std::from_chars_result from_chars(const char* first, const char* last,
                                            number<Raw, Point, Rules>& value) noexcept {
  std::optional<Raw> raw;
  const char* end = detail::read_decimal<Rules.multiply, Point>(first, last, raw);
  if (end == first) return {first, std::errc::invalid_argument};
  if (!raw) return {end, std::errc::result_out_of_range};
  value = number<Raw, Point, Rules>::from_raw(*raw);
  return {end, std::errc{}};
}

/// The exact value, as to_chars() writes it.
template <class Raw, int Point, policy Rules>
std::string to_string(number<Raw, Point, Rules> value) {
  std::array<char, detail::max_decimal_chars<Raw, Point>> text{};
  return {text.data(), detail::write_decimal<Point>(text.data(), value.raw())};
}

/// Writes the number in a field of width(), as for built-in numbers.
///
/// Without std::fixed and std::scientific the text is the exact value. They round it to precision()
/// digits after the point, to nearest and ties to even. std::hexfloat writes the exact value as for
/// a double: "-0x1.8p+0". showpos, showpoint, uppercase, left, right
/// and internal have their usual meaning. The stream's locale gives the decimal point and the
/// grouping of the digits before it.
///
///     std::ostringstream out;
///     out << std::fixed << std::setprecision(2) << q16_16(2.625) << ' ' << q16_16(-0.125);
///     const bool nearest_or_even = out.str() == "2.62 -0.12";
template <class Traits, class Raw, int Point, policy Rules>
std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out,
                                             number<Raw, Point, Rules> value) {
  const std::string text = detail::stream_text<Point>(out, value.raw());
  return out << std::basic_string_view<char, Traits>(text.data(), text.size());
}

/// Skips white space and reads what from_chars() reads, with the decimal point of the stream's
/// locale in place of '.'. On an error it sets failbit and leaves the value unchanged. An `e` and
/// the sign of an exponent must be followed by a digit: "1e" and "1e+" fail.
template <class Traits, class Raw, int Point, policy Rules>
std::basic_istream<char, Traits>& operator>>(std::basic_istream<char, Traits>& in,
                                             number<Raw, Point, Rules>& value) {
  const typename std::basic_istream<char, Traits>::sentry ready(in);
  if (!ready) return in;
  detail::decimal_reader<Raw, Point> reader(
      std::use_facet<std::numpunct<char>>(in.getloc()).decimal_point());
  for (auto next = in.peek(); !Traits::eq_int_type(next, Traits::eof()); next = in.peek()) {
    if (!reader.take(Traits::to_char_type(next))) break;
    in.get();
  }
  const auto raw = reader.complete() ? reader.template value<Rules.multiply>() : std::nullopt;
  if (raw) {
    value = number<Raw, Point, Rules>::from_raw(*raw);
  } else {
    in.setstate(std::ios_base::failbit);
  }
  return in;
}

}  // namespace fixproof

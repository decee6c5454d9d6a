/// \file
/// Exact decimal text, with the interface of `<charconv>`, and stream operators.
#pragma once

#include <algorithm>
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
#include "fixed/number.hpp"

namespace fixproof {

/// A buffer size that is enough for to_chars() of any number of the type.
template <class Number>
inline constexpr std::size_t max_chars =
    detail::max_decimal_chars<typename Number::raw_type, Number::fraction_bits>;

/// Writes the exact value in its shortest form: "-0.5", "3", "0.0000152587890625".
/// \return the end of the text, or {last, errc::value_too_large} with nothing written if it does
/// not fit
///
///     std::array<char, max_chars<q16_16>> text{};
///     const auto written = to_chars(text.data(), text.data() + text.size(), q16_16(-0.5));
///     const std::string_view half(text.data(), written.ptr);  // "-0.5"
template <class Raw, int F, policy P>
constexpr std::to_chars_result to_chars(char* first, char* last, number<Raw, F, P> value) noexcept {
  std::array<char, detail::max_decimal_chars<Raw, F>> text{};
  const char* begin = text.data();
  const char* end = detail::write_decimal<F>(text.data(), value.raw());
  if (last - first < end - begin) return {last, std::errc::value_too_large};
  return {std::copy(begin, end, first), std::errc{}};
}

/// Reads the longest prefix of the form `[sign]digits[.digits]`, of any length, and rounds it once
/// by policy::multiply.
/// \return the end of the prefix; errc::invalid_argument, with `first`, if there is none;
/// errc::result_out_of_range if the rounded value is out of range, under every policy. On an error
/// the value is unchanged.
///
///     static_assert([] {
///       constexpr std::string_view text = "0.1 and more";
///       q16_16 x;
///       return from_chars(text.data(), text.data() + text.size(), x).ptr == text.data() + 3 &&
///              x.raw() == 6554;
///     }());
template <class Raw, int F, policy P>
constexpr std::from_chars_result from_chars(const char* first, const char* last,
                                            number<Raw, F, P>& value) noexcept {
  detail::decimal_reader<Raw, F> reader;
  const char* end = first;
  while (end != last && reader.take(*end)) ++end;
  if (reader.ends_in_point()) --end;
  if (!reader.complete() && !reader.ends_in_point()) return {first, std::errc::invalid_argument};
  const auto raw = reader.template value<P.multiply>();
  if (!raw) return {end, std::errc::result_out_of_range};
  value = number<Raw, F, P>::from_raw(*raw);
  return {end, std::errc{}};
}

/// The exact value, as to_chars() writes it.
template <class Raw, int F, policy P>
std::string to_string(number<Raw, F, P> value) {
  std::array<char, detail::max_decimal_chars<Raw, F>> text{};
  return {text.data(), detail::write_decimal<F>(text.data(), value.raw())};
}

/// Writes the exact value. Only width, fill, left and right affect the output.
template <class Traits, class Raw, int F, policy P>
std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out,
                                             number<Raw, F, P> value) {
  std::array<char, detail::max_decimal_chars<Raw, F>> text{};
  const char* end = detail::write_decimal<F>(text.data(), value.raw());
  return out << std::basic_string_view<char, Traits>(text.data(),
                                                     static_cast<std::size_t>(end - text.data()));
}

/// Skips white space and reads what from_chars() reads. On an error it sets failbit and leaves the
/// value unchanged. A point must be followed by a digit: "1." fails.
template <class Traits, class Raw, int F, policy P>
std::basic_istream<char, Traits>& operator>>(std::basic_istream<char, Traits>& in,
                                             number<Raw, F, P>& value) {
  const typename std::basic_istream<char, Traits>::sentry ready(in);
  if (!ready) return in;
  detail::decimal_reader<Raw, F> reader;
  for (auto next = in.peek(); !Traits::eq_int_type(next, Traits::eof()); next = in.peek()) {
    if (!reader.take(Traits::to_char_type(next))) break;
    in.get();
  }
  const auto raw = reader.complete() ? reader.template value<P.multiply>() : std::nullopt;
  if (raw) {
    value = number<Raw, F, P>::from_raw(*raw);
  } else {
    in.setstate(std::ios_base::failbit);
  }
  return in;
}

}  // namespace fixproof

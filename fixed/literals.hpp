/// @file
/// Literals: 1.5_q16_16. A literal that is not a value of the type does not compile;
/// 0.1_q16_16_rounded is the value nearest to 0.1, ties to even.
///
///     using namespace fixproof::literals;
///     static_assert(1.5_q16_16 == q16_16(1.5) && -0.25_q2_30 == q2_30(-0.25));
///     static_assert((0.1_q16_16_rounded).raw() == 6554);  // 6553.6
///     static_assert(1'000_q24_8 == 1000);
///
/// q16_16, q8_8 and every format of fixed/formats.hpp have both.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "fixed/detail/decimal.hpp"
#include "fixed/detail/decimal_reader.hpp"
#include "fixed/formats.hpp"
#include "fixed/number.hpp"

namespace fixproof::detail {

/// The characters of a literal without digit separators.
template <char... Chars>
inline constexpr auto literal_text = [] {
  struct text {
    std::array<char, sizeof...(Chars)> chars{};
    std::size_t length = 0;
  };
  text result;
  for (const char c : {Chars...}) {
    if (c != '\'') result.chars[result.length++] = c;
  }
  return result;
}();

/// Whether a literal has only digits and at most one point.
template <char... Chars>
consteval bool is_decimal() {
  int points = 0;
  for (std::size_t i = 0; i < literal_text<Chars...>.length; ++i) {
    const char c = literal_text<Chars...>.chars[i];
    points += c == '.' ? 1 : 0;
    if (c != '.' && (c < '0' || c > '9')) return false;
  }
  return points <= 1;
}

/// A decimal literal rounded by rule Rounding, or nothing if it is out of range.
template <class Number, rounding Rounding, char... Chars>
consteval auto read_literal() {
  constexpr auto text = literal_text<Chars...>;
  decimal_reader<typename Number::raw_type, Number::fraction_bits> reader;
  for (std::size_t i = 0; i < text.length; ++i) reader.take(text.chars[i]);
  return reader.template value<Rounding>();
}

/// Whether the exact text of `raw` is that of the literal, without zeros at its ends.
template <class Number, char... Chars>
consteval bool is_exact(typename Number::raw_type raw) {
  std::array<char, max_decimal_chars<typename Number::raw_type, Number::fraction_bits>> exact{};
  const char* const end = write_decimal<Number::fraction_bits>(exact.data(), raw);
  constexpr auto text = literal_text<Chars...>;
  std::size_t last = text.length;
  bool has_point = false;
  for (std::size_t i = 0; i < text.length; ++i) has_point = has_point || text.chars[i] == '.';
  while (has_point && text.chars[last - 1] == '0') --last;
  if (has_point && text.chars[last - 1] == '.') --last;
  const char* at = exact.data();
  if (*at == '0') ++at;
  std::size_t first = 0;
  while (first < last && text.chars[first] == '0') ++first;
  for (; first < last && at != end; ++first, ++at) {
    if (text.chars[first] != *at) return false;
  }
  return first == last && at == end;
}

template <class Number, bool Rounds, char... Chars>
consteval Number literal() {
  constexpr bool decimal = is_decimal<Chars...>();
  static_assert(decimal, "a literal of a fixproof::number has only digits and a point");
  if constexpr (decimal) {
    constexpr auto raw = read_literal < Number, Rounds ? rounding::half_even : rounding::floor,
                   Chars... > ();
    static_assert(
        raw.has_value(),
        "this literal is out of the range of its type; use a format with more bits before "
        "the point");
    if constexpr (raw.has_value()) {
      static_assert(Rounds || is_exact<Number, Chars...>(*raw),
                    "this literal is not a value of its type; append _rounded to round it, as in "
                    "0.1_q16_16_rounded");
      return Number::from_raw(*raw);
    }
  }
  return Number();
}

}  // namespace fixproof::detail

/// The literals; see fixed/literals.hpp.
namespace fixproof::literals {

/// @cond
// NOLINTBEGIN(cppcoreguidelines-macro-usage,bugprone-macro-parentheses): defines two operators
#define FIXED_LITERAL(type)                                    \
  template <char... Chars>                                     \
  consteval type operator""_##type() {                         \
    return fixproof::detail::literal<type, false, Chars...>(); \
  }                                                            \
  template <char... Chars>                                     \
  consteval type operator""_##type##_rounded() {               \
    return fixproof::detail::literal<type, true, Chars...>();  \
  }
// NOLINTEND(cppcoreguidelines-macro-usage,bugprone-macro-parentheses)
FIXED_LITERAL(q16_16)
FIXED_LITERAL(q8_8)
FIXED_LITERAL(q8_0)
FIXED_LITERAL(q4_4)
FIXED_LITERAL(q1_7)
FIXED_LITERAL(u4_4)
FIXED_LITERAL(u0_8)
FIXED_LITERAL(q12_4)
FIXED_LITERAL(q4_12)
FIXED_LITERAL(q2_14)
FIXED_LITERAL(q1_15)
FIXED_LITERAL(u8_8)
FIXED_LITERAL(u1_15)
FIXED_LITERAL(u0_16)
FIXED_LITERAL(q32_0)
FIXED_LITERAL(q26_6)
FIXED_LITERAL(q24_8)
FIXED_LITERAL(q20_12)
FIXED_LITERAL(q8_24)
FIXED_LITERAL(q4_28)
FIXED_LITERAL(q2_30)
FIXED_LITERAL(q1_31)
FIXED_LITERAL(u24_8)
FIXED_LITERAL(u16_16)
FIXED_LITERAL(u8_24)
FIXED_LITERAL(u1_31)
FIXED_LITERAL(u0_32)
FIXED_LITERAL(q48_16)
FIXED_LITERAL(q40_24)
FIXED_LITERAL(q32_32)
FIXED_LITERAL(q16_48)
FIXED_LITERAL(q2_62)
FIXED_LITERAL(q1_63)
FIXED_LITERAL(u48_16)
FIXED_LITERAL(u32_32)
FIXED_LITERAL(u0_64)
#undef FIXED_LITERAL
/// @endcond

}  // namespace fixproof::literals

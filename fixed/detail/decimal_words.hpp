/// @file
/// Reads decimal text of usual length in words of 64 bits. decimal_reader reads all other text.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "fixed/detail/gpu.hpp"
#include "fixed/detail/inlining.hpp"
#include "fixed/detail/overflow.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/detail/wide_integer.hpp"

namespace fixproof::detail {

constexpr bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

constexpr unsigned digit_of(char c) noexcept { return static_cast<unsigned>(c - '0'); }

/// Whether a text is not empty and begins with a digit.
constexpr bool begins_with_digit(const char* at, const char* last) noexcept {
  return at != last && is_digit(*at);
}

/// 10^0 to 10^19, all that fit a word.
FIXED_CONSTANT auto powers_of_ten = [] {
  std::array<std::uint64_t, 20> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = powers[i - 1] * 10;
  return powers;
}();

/// 10^i. @pre 0 <= i < 20
constexpr std::uint64_t power_of_ten(std::int64_t i) noexcept {
  return powers_of_ten[static_cast<std::size_t>(i)];
}

/// Eight characters, the first in the lowest byte. A digit becomes its value, and any other
/// character at least 10.
constexpr std::uint64_t eight_digits(const char* at) noexcept {
  std::uint64_t chars = 0;
#if defined(__GNUC__) || defined(__clang__)  // <cstring> is not there without an operating system
  if (std::endian::native == std::endian::little && !std::is_constant_evaluated()) {
    __builtin_memcpy(&chars, at, 8);
  } else
#endif
  {
    for (int i = 8; i-- > 0;) chars = chars << 8 | static_cast<unsigned char>(at[i]);
  }
  return chars ^ 0x3030303030303030;
}

/// Whether all eight are digits: a value from 10 on has bit 7 itself, or if 0x76 is added.
constexpr bool are_digits(std::uint64_t eight) noexcept {
  return ((eight | (eight + 0x7676767676767676)) & 0x8080808080808080) == 0;
}

/// Appends the digits at the beginning of a text to `value`, modulo 2^64.
/// @return the end of the digits
constexpr const char* read_digits(const char* at, const char* last, std::uint64_t& value) noexcept {
  // A copy, because clang++ keeps `value` in memory.
  std::uint64_t read = value;
  for (; at != last && is_digit(*at); ++at) read = read * 10 + digit_of(*at);
  value = read;
  return at;
}

/// The same, eight digits at a time.
constexpr const char* read_long(const char* at, const char* last, std::uint64_t& value) noexcept {
  for (; last - at >= 8; at += 8) {
    std::uint64_t eight = eight_digits(at);
    if (!are_digits(eight)) break;
    // Neighbours become pairs, pairs become fours, and these the whole.
    eight = (eight * 10 + (eight >> 8)) & 0x00ff00ff00ff00ff;
    eight = (eight * 100 + (eight >> 16)) & 0x0000ffff0000ffff;
    value = value * 100'000'000 + ((eight * 10'000 + (eight >> 32)) & 0xffffffff);
  }
  return read_digits(at, last, value);
}

/// Skips digits. @return whether one of them is not zero
constexpr bool skip_digits(const char*& at, const char* last) noexcept {
  std::uint64_t all = 0;
  for (; last - at >= 8; at += 8) {
    const std::uint64_t eight = eight_digits(at);
    if (!are_digits(eight)) break;
    all |= eight;
  }
  for (; at != last && is_digit(*at); ++at) all |= digit_of(*at);
  return all != 0;
}

/// A magnitude rounded by rule Rounding, or nothing if it is out of range.
/// @param rest what the magnitude leaves, in units of 1 / one
/// @param more whether the number is further from zero, by less than a unit
template <rounding Rounding, class Raw, class Wide>
constexpr std::optional<Raw> rounded_text(Wide magnitude, std::uint64_t rest, std::uint64_t one,
                                          bool more, bool negative) noexcept {
  rest = 2 * rest + (more ? 1 : 0);
  magnitude = magnitude + Wide{grows<Rounding>(rest, 2 * one, negative, is_odd(magnitude))};
  if (negative) magnitude = -magnitude;
  if (!fits<Raw>(magnitude)) return std::nullopt;
  return static_cast<Raw>(magnitude);
}

/// The digits of a number, without its sign.
struct decimal_words {
  std::uint64_t whole = 0;     ///< the digits before the point
  std::uint64_t fraction = 0;  ///< the first 18 digits after the point
  bool more = false;           ///< whether a later digit is not zero
};

/// Rounds by rule Rounding.
/// @param value empty before; the number, or nothing if it is out of range
/// @return whether the digits decide the rounding. From 60 fraction bits on, they rarely do.
template <rounding Rounding, int FractionBits, class Raw>
constexpr bool round_words(const decimal_words& text, bool negative,
                           std::optional<Raw>& value) noexcept {
  constexpr std::uint64_t one = power_of_ten(18);
  constexpr int whole_bits = bits_of<Raw> - FractionBits;
  // floor(2^123 / 10^18), which has 64 bits: the quotient is `steps` or one more.
  constexpr std::uint64_t inverse = 0x9392ee8e921d5d07;
  std::uint64_t steps = multiply_high(text.fraction << 4, inverse) >> (63 - FractionBits);
  std::uint64_t rest = (text.fraction << FractionBits) - steps * one;
  const bool one_more = rest >= one;
  steps += one_more ? 1 : 0;
  rest -= one_more ? one : 0;
  if constexpr (FractionBits > 17) {
    // A tie has FractionBits + 1 digits after the point. From 18 fraction bits on, they are more
    // than the 18 of the fraction, so digits beyond those can decide.
    const std::uint64_t end = rest + (std::uint64_t{1} << FractionBits);
    if (text.more && (end > one || (rest < one / 2 && end > one / 2))) return false;
  }
  if (whole_bits < 64 && text.whole >> (whole_bits & 63) != 0) return true;
  using wide = signed_t<larger(64, bits_of<Raw> + 2)>;
  const wide magnitude = (static_cast<wide>(text.whole) << FractionBits) + static_cast<wide>(steps);
  value = rounded_text<Rounding, Raw>(magnitude, rest, one, text.more, negative);
  return true;
}

/// Reads an exponent and rounds the number by rule Rounding.
/// @param mark   the mark of the exponent; it ends the number if no digit follows
/// @param all    the digits of the number, at most 18, as an integer
/// @param places the digits after the point
/// @return the end, or nullptr if words do not suffice
template <rounding Rounding, int FractionBits, class Raw>
constexpr const char* read_exponent(const char* mark, const char* last, bool negative,
                                    std::uint64_t all, std::int64_t places,
                                    std::optional<Raw>& value) noexcept {
  const char* begin = mark + 1;
  const bool is_down = begin != last && *begin == '-';
  // Signs of exponents are hard to predict, so one addition skips either.
  if (begin != last) begin += static_cast<int>(is_down) | static_cast<int>(*begin == '+');
  std::uint64_t exponent = 0;
  const char* const end = read_digits(begin, last, exponent);
  if (end - begin > 9) return nullptr;
  places += is_down ? static_cast<std::int64_t>(exponent) : -static_cast<std::int64_t>(exponent);
  decimal_words text;
  if (places < 0) {
    if (places < -19) return nullptr;
    const two_words product = multiply_words(all, power_of_ten(-places));
    if (product.high != 0) return nullptr;
    text.whole = product.low;
  } else if (places <= 18) {
    text.whole = all / power_of_ten(places);
    text.fraction = all % power_of_ten(places) * power_of_ten(18 - places);
  } else {
    const std::uint64_t unit = power_of_ten(places <= 36 ? places - 18 : 18);
    text.fraction = all / unit;
    text.more = all % unit != 0;
  }
  if (!round_words<Rounding, FractionBits>(text, negative, value)) return nullptr;
  return end == begin ? mark : end;
}

/// Reads the longest number at the beginning of a text, rounded by rule Rounding.
/// @param value empty before; the number, or nothing if it is out of range
/// @return the end of the number, `first` if there is none, or nullptr if words do not suffice
template <rounding Rounding, int FractionBits, class Raw>
FIXED_ALWAYS_INLINE constexpr const char* read_words(const char* first, const char* last,
                                                     std::optional<Raw>& value) noexcept {
  const char* at = first;
  const bool negative = at != last && *at == '-';
  if (negative || (at != last && *at == '+')) ++at;
  const char* const whole = at;
  decimal_words text;
  at = read_digits(at, last, text.whole);
  const auto whole_digits = at - whole;
  std::ptrdiff_t places = 0;
  std::uint64_t fraction = 0;
  if (at != last && *at == '.' && (whole_digits != 0 || begins_with_digit(at + 1, last))) {
    const char* const begin = ++at;
    at = read_long(at, last - at > 18 ? at + 18 : last, fraction);
    places = at - begin;
    if (places == 18) text.more = skip_digits(at, last);
  }
  if (at == whole) return first;
  if constexpr (FractionBits < 60) {
    if (whole_digits > 19) return nullptr;
    if (at != last && (*at == 'e' || *at == 'E')) {
      if (whole_digits + places > 18 || text.more) return nullptr;
      const std::uint64_t all = text.whole * power_of_ten(places) + fraction;
      return read_exponent<Rounding, FractionBits>(at, last, negative, all, places, value);
    }
    text.fraction = fraction * power_of_ten(18 - places);
    if (round_words<Rounding, FractionBits>(text, negative, value)) return at;
  }
  return nullptr;
}

}  // namespace fixproof::detail

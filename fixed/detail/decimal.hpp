/// \file
/// Conversion between stored integers and decimal text, exact in both directions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "fixed/detail/overflow.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"

namespace fixproof::detail {

/// The longest decimal text: sign, whole part, point, and one fraction digit per fraction bit.
template <int FractionBits>
inline constexpr std::size_t max_decimal_chars = 1 + (FractionBits == 16 ? 5 : 3) +
                                                 1 + FractionBits;

/// Writes the exact value in its shortest form: "-0.5", "3", "0.0000152587890625".
/// \param out a buffer of max_decimal_chars
/// \return the end of the text
template <int FractionBits>
constexpr char* write_decimal(char* out, raw_t<FractionBits> raw) noexcept {
  constexpr std::uint32_t one = std::uint32_t{1} << FractionBits;
  auto magnitude = static_cast<std::uint32_t>(raw);
  if (raw < 0) {
    *out++ = '-';
    magnitude = 0 - magnitude;
  }
  const auto digit = [&out](std::uint32_t value) { *out++ = static_cast<char>('0' + value); };
  const std::uint32_t whole = magnitude / one;
  std::uint32_t power = 1;
  while (whole / power >= 10) power *= 10;
  for (; power != 0; power /= 10) digit(whole / power % 10);
  std::uint32_t fraction = magnitude % one;
  if (fraction != 0) *out++ = '.';
  for (; fraction != 0; fraction = fraction * 10 % one) digit(fraction * 10 / one);
  return out;
}

/// Reads `[sign]digits[.digits]` one character at a time, in constant memory, and rounds it once.
///
/// A tie is an odd multiple of 2^-17 at the finest and has at most 17 fraction digits. Keeping 17
/// digits exactly, and whether any later digit is nonzero, therefore decides every rounding.
class decimal_reader {
 public:
  /// Consumes the next character if it can continue the text.
  constexpr bool take(char c) noexcept {
    const bool is_digit = c >= '0' && c <= '9';
    switch (state_) {
      case state::start:
        if (c == '-' || c == '+') {
          negative_ = c == '-';
          state_ = state::sign;
          return true;
        }
        [[fallthrough]];
      case state::sign:
        state_ = is_digit ? state::whole : state_;
        break;
      case state::whole:
        if (c == '.') {
          state_ = state::point;
          return true;
        }
        break;
      case state::point:
        state_ = is_digit ? state::fraction : state_;
        break;
      case state::fraction:
        break;
    }
    if (is_digit) add(static_cast<unsigned>(c - '0'));
    return is_digit;
  }

  /// Whether the characters consumed are a number. "1." is not.
  [[nodiscard]] constexpr bool complete() const noexcept {
    return state_ == state::whole || state_ == state::fraction;
  }

  /// Whether the characters consumed are a number and a point.
  [[nodiscard]] constexpr bool ends_in_point() const noexcept { return state_ == state::point; }

  /// The number rounded by rule R, or nothing if the rounded value is out of range.
  template <int FractionBits, rounding R>
  constexpr std::optional<raw_t<FractionBits>> value() const noexcept {
    // 10^17 / 2^FractionBits: units of the last kept digit per ulp. The extra factor of two makes
    // room for the sticky bit of the later digits.
    constexpr std::int64_t unit = 2 * (power_of_ten(kept) >> FractionBits);
    std::int64_t parts = fraction_;
    for (int digits = kept_; digits < kept; ++digits) parts *= 10;
    parts = 2 * parts + (more_ ? 1 : 0);
    std::int64_t whole = whole_ << FractionBits;
    if (negative_) {
      parts = -parts;
      whole = -whole;
    }
    const std::int64_t result = whole + floor_divide(parts + bias<R>(parts < 0, unit), unit);
    if (!fits<raw_t<FractionBits>>(result)) return std::nullopt;
    return static_cast<raw_t<FractionBits>>(result);
  }

 private:
  enum class state { start, sign, whole, point, fraction };

  static constexpr int kept = 17;

  static constexpr std::int64_t power_of_ten(int exponent) noexcept {
    std::int64_t power = 1;
    while (exponent-- > 0) power *= 10;
    return power;
  }

  constexpr void add(unsigned digit) noexcept {
    if (state_ == state::whole) {
      // Clamps: beyond every range, the exact whole part does not matter.
      constexpr std::int64_t beyond = std::int64_t{1} << 32;
      whole_ = whole_ * 10 + digit;
      if (whole_ > beyond) whole_ = beyond;
    } else if (kept_ < kept) {
      fraction_ = fraction_ * 10 + digit;
      ++kept_;
    } else {
      more_ = more_ || digit != 0;
    }
  }

  state state_ = state::start;
  bool negative_ = false;
  bool more_ = false;
  int kept_ = 0;
  std::int64_t whole_ = 0;
  std::int64_t fraction_ = 0;
};

}  // namespace fixproof::detail

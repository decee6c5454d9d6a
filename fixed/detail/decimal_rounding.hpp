/// \file
/// Rounds the decimal digits of a number to a stored integer.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "fixed/detail/decimal.hpp"
#include "fixed/detail/overflow.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/detail/wide_integer.hpp"

namespace fixproof::detail {

/// The digits of a number that decide its rounding.
///
/// A tie is an odd multiple of 2^-(FractionBits + 1) at the finest and has at most FractionBits + 1
/// fraction digits. Those digits, and whether any later digit is nonzero, therefore decide every
/// rounding. A number in range has at most whole_digits digits before the point.
template <class Raw, int FractionBits>
struct decimal_parts {
  /// 10^whole_digits is beyond the range.
  static constexpr int whole_digits = decimal_digits(larger(bits_of<Raw> - FractionBits, 0)) + 1;
  /// 10^17 is a multiple of the power of two of every format whose reader calculates in 64 bits.
  static constexpr int fraction_digits = larger(FractionBits + 1, 17);

  /// Holds 10^(whole_digits + 1).
  using whole_t = signed_t<larger(64, bits_of<Raw> - FractionBits + 8)>;
  /// Holds 4 * 10^fraction_digits.
  using fraction_t = signed_t<larger(64, (fraction_digits * 33220 + 9999) / 10000 + 3)>;
  /// Holds 10^whole_digits * 2^FractionBits.
  using wide = signed_t<larger(64, bits_of<Raw> + 6)>;

  template <class Int>
  static constexpr Int times_power_of_ten(Int x, int exponent) noexcept {
    while (exponent-- > 0) x = x * Int{10};
    return x;
  }

  bool negative = false;
  /// Whether a digit after those of the fraction is not zero.
  bool more = false;
  /// The digits of the fraction so far.
  int read = 0;
  whole_t whole{0};
  fraction_t fraction{0};

  constexpr void add_whole(unsigned digit) noexcept {
    // Clamps: beyond every range, the exact whole part does not matter.
    constexpr whole_t beyond = times_power_of_ten(whole_t{1}, whole_digits);
    whole = whole * whole_t{10} + whole_t{digit};
    if (beyond < whole) whole = beyond;
  }

  constexpr void add_fraction(unsigned digit) noexcept {
    if (read < fraction_digits) {
      fraction = fraction * fraction_t{10} + fraction_t{digit};
      ++read;
    } else {
      more = more || digit != 0;
    }
  }

  /// The number rounded by rule R, or nothing if the rounded value is out of range.
  template <rounding R>
  [[nodiscard]] constexpr std::optional<Raw> rounded() const noexcept {
    // In units of half of 10^-fraction_digits, to make room for the sticky bit of later digits.
    constexpr fraction_t one = times_power_of_ten(fraction_t{1}, fraction_digits) << 1;
    fraction_t parts = scaled() + fraction_t{more};
    wide magnitude{whole};
    if constexpr (is_short) {
      constexpr fraction_t ulp = one >> FractionBits;
      magnitude = magnitude << FractionBits;
      const wide steps{rounded_ratio<R>(negative ? -parts : parts, ulp)};
      return in_range((negative ? -magnitude : magnitude) + steps);
    } else {
      // One bit of the quotient at a time, toward zero.
      for (int bit = 0; bit < FractionBits; ++bit) {
        parts = parts << 1;
        const bool set = !(parts < one);
        if (set) parts = parts - one;
        magnitude = (magnitude << 1) + wide{set};
      }
      const bool exact = parts == fraction_t{0};
      const fraction_t rest = one - parts;
      const auto order = parts < rest   ? std::strong_ordering::less
                         : rest < parts ? std::strong_ordering::greater
                                        : std::strong_ordering::equal;
      // The magnitude grows where the number itself would not be rounded up.
      bool grows = rounds_up<R>(order, exact, false, is_odd(magnitude));
      if (negative && !exact) {
        const auto from_below = 0 <=> order;
        grows = !rounds_up<R>(from_below, false, true, !is_odd(magnitude));
      }
      if (grows) magnitude = magnitude + wide{1};
      return in_range(negative ? -magnitude : magnitude);
    }
  }

 private:
  /// The fraction is rounded by itself: its last bit decides ties to even, so there must be one.
  static constexpr bool is_short = FractionBits > 0 && is_built_in<fraction_t> &&
                                   sizeof(fraction_t) == 8;

  /// The fraction in units of half of 10^-fraction_digits.
  [[nodiscard]] constexpr fraction_t scaled() const noexcept {
    if constexpr (is_short) {
      return fraction * double_powers[static_cast<std::size_t>(fraction_digits - read)];
    } else {
      return times_power_of_ten(fraction, fraction_digits - read) << 1;
    }
  }

  /// 2 * 10^i.
  static constexpr auto double_powers = [] {
    std::array<std::int64_t, 18> powers{2};
    for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = powers[i - 1] * 10;
    return powers;
  }();

  static constexpr std::optional<Raw> in_range(const wide& value) noexcept {
    if (!fits<Raw>(value)) return std::nullopt;
    return static_cast<Raw>(value);
  }
};

}  // namespace fixproof::detail

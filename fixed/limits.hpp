/// @file
/// std::numeric_limits and std::hash.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>  // std::hash

#include "fixed/detail/decimal.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/number.hpp"
#include "fixed/policy.hpp"

/// The limits of a number type. `min` is the smallest positive number, as for floating point, and
/// `epsilon` is the step to the next number.
template <class Raw, int FractionBits, fixproof::policy Rules>
class std::numeric_limits<fixproof::number<Raw, FractionBits, Rules>> {
  using number = fixproof::number<Raw, FractionBits, Rules>;
  using raw_limits = std::numeric_limits<Raw>;

  /// Binary digits before the point, without the sign; -1 if a half is out of range.
  static constexpr int whole_bits = raw_limits::digits - FractionBits;

  static constexpr std::float_round_style style() noexcept {
    using fixproof::detail::is_to_nearest;
    if (is_to_nearest<Rules.multiply> && is_to_nearest<Rules.divide>) return std::round_to_nearest;
    if (Rules.multiply != Rules.divide) return std::round_indeterminate;
    if (Rules.multiply == fixproof::rounding::ceiling) return std::round_toward_infinity;
    return Rules.multiply == fixproof::rounding::floor ? std::round_toward_neg_infinity
                                                       : std::round_toward_zero;
  }

  /// bits * log10(2) rounded down, and rounded up; 0 for no bits.
  static constexpr int log10_below(int bits) noexcept {
    return fixproof::detail::decimal_digits(bits > 0 ? bits : 0);
  }
  static constexpr int log10_above(int bits) noexcept {
    return log10_below(bits) + (bits > 0 ? 1 : 0);
  }

 public:
  /// @name Properties of the type
  /// \{

  /// Members as the standard names them.
  static constexpr bool is_specialized = true;
  static constexpr bool is_signed = raw_limits::is_signed;
  static constexpr bool is_integer = FractionBits == 0;
  static constexpr bool is_exact = true;
  static constexpr bool is_bounded = true;
  static constexpr bool is_iec559 = false;
  /// Whether sums and products wrap.
  static constexpr bool is_modulo =
      Rules.range == fixproof::overflow::wrap && Rules.product_range() == fixproof::overflow::wrap;
  /// Whether any operation throws.
  static constexpr bool traps =
      !number::never_throws || !number::multiply_never_throws || !number::divide_never_throws;
  static constexpr bool tinyness_before = false;

  static constexpr bool has_infinity = false;
  static constexpr bool has_quiet_NaN = false;
  static constexpr bool has_signaling_NaN = false;
  static constexpr std::float_denorm_style has_denorm = std::denorm_absent;
  static constexpr bool has_denorm_loss = false;
  /// \}

  /// The rounding of products and quotients; round_indeterminate if they differ.
  static constexpr std::float_round_style round_style = style();

  /// The base of the stored integer.
  static constexpr int radix = 2;
  /// Binary digits without the sign: 31 in 16.16, 15 in 8.8.
  static constexpr int digits = raw_limits::digits;
  /// Decimal digits that survive a round trip: 4 before the point and 4 after it in 16.16; 2 and 2
  /// in 8.8.
  static constexpr int digits10 = log10_below(whole_bits) + log10_below(FractionBits);
  /// Decimal digits that identify every number: 5 before the point and 5 after it in 16.16; 3 and 3
  /// in 8.8.
  static constexpr int max_digits10 = log10_above(whole_bits) + log10_above(FractionBits);
  /// 2^(min_exponent - 1) is the smallest power of two in range.
  static constexpr int min_exponent = 1 - FractionBits;
  /// 2^(max_exponent - 1) is the largest power of two in range.
  static constexpr int max_exponent = whole_bits;
  /// 10^min_exponent10 is the smallest power of ten in range: 0.0001 in 16.16, 0.01 in 8.8.
  static constexpr int min_exponent10 = -log10_below(FractionBits);
  /// 10^max_exponent10 is the largest power of ten in range: 10000 in 16.16, 100 in 8.8.
  static constexpr int max_exponent10 = whole_bits > 0 ? log10_below(whole_bits) : -1;

  /// The smallest positive number, one ulp.
  static constexpr number(min)() noexcept { return number::from_raw(1); }
  /// The highest number: 32767 + 65535/65536 in 16.16.
  static constexpr number(max)() noexcept { return number::from_raw((raw_limits::max)()); }
  /// The lowest number: -32768 in 16.16.
  static constexpr number lowest() noexcept { return number::from_raw((raw_limits::min)()); }
  /// The step to the next number, one ulp.
  static constexpr number epsilon() noexcept { return number::from_raw(1); }
  /// The rounding error in ulp: 1/2 if every operation rounds to nearest, else 1. The highest
  /// number if it is out of range, and 1 if there are no halves.
  static constexpr number round_error() noexcept {
    const int bit = fixproof::detail::larger(
        style() == std::round_to_nearest ? FractionBits - 1 : FractionBits, 0);
    return bit < raw_limits::digits ? number::from_raw(static_cast<Raw>(Raw{1} << bit)) : (max)();
  }
  /// Equal to min(): there are no denormal numbers.
  static constexpr number denorm_min() noexcept { return (min)(); }
  /// Always 0: there is no infinity.
  static constexpr number infinity() noexcept { return number(); }
  /// Always 0: there is no NaN.
  static constexpr number quiet_NaN() noexcept { return number(); }
  /// Always 0: there is no NaN.
  static constexpr number signaling_NaN() noexcept { return number(); }
};

/// The hash of the stored integer, so that equal numbers have equal hashes.
template <class Raw, int FractionBits, fixproof::policy Rules>
struct std::hash<fixproof::number<Raw, FractionBits, Rules>> {
  /// The hash of x.raw().
  std::size_t operator()(fixproof::number<Raw, FractionBits, Rules> x) const noexcept {
    return std::hash<Raw>{}(x.raw());
  }
};

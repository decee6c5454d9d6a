/// \file
/// Exponentials and logarithms of words of at most 32 bits, each the nearest integer of ulps.
///
/// A result is first computed in 64 bits with a bound of its error. If the bound allows two
/// integers, which happens about once in 2^(57 - FractionBits) operands, it is computed again with
/// an error below 2^-160. By Lindemann's theorem and the theorem of Gelfond and Schneider no
/// irrational result is a tie, and rational results are handled apart.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "fixed/detail/cosine.hpp"
#include "fixed/detail/function_kinds.hpp"
#include "fixed/detail/function_tables.hpp"
#include "fixed/detail/nearest.hpp"
#include "fixed/detail/precise_exponential.hpp"
#include "fixed/detail/rounding.hpp"

namespace fixproof::detail {

/// 2^(x / 2^64) in units of 2^-63, at most 15 units too low and never too high.
///
/// The table takes 5 bits of x. The Taylor series of the rest loses at most 2 units in each of
/// eight steps, counted in units of 2^-64, and its remainder is below 2^-68.
constexpr std::uint64_t power_of_two(std::uint64_t x) noexcept {
  const std::uint64_t rest = x << 5;
  std::uint64_t sum = power_coefficients.back();
  for (std::size_t n = power_coefficients.size() - 1; n-- > 0;) {
    sum = power_coefficients[n] + multiply_high(rest, sum);
  }
  const std::uint64_t power = powers_of_two[x >> 59];
  return power + multiply_high(power, multiply_high(rest, sum));
}

/// An exponent of 2: whole + fraction / 2^64.
struct binary_exponent {
  std::int64_t whole;
  std::uint64_t fraction;
};

/// The exponent of 2 of an exponential of x / 2^32. For base e the error is at most
/// |x| 2^-95 + 2^-64.
template <exponential_base Base>
constexpr binary_exponent exponent_of(std::int64_t x) noexcept {
  if constexpr (Base == exponential_base::two) {
    return {x >> 32, static_cast<std::uint64_t>(x) << 32};
  } else {
    const auto magnitude =
        x < 0 ? 0 - static_cast<std::uint64_t>(x) : static_cast<std::uint64_t>(x);
    const two_words product = multiply_words(magnitude, log2_e);
    const auto whole = static_cast<std::int64_t>(product.high >> 31);
    const std::uint64_t fraction = product.high << 33 | product.low >> 31;
    if (x >= 0) return {whole, fraction};
    return {fraction == 0 ? -whole : -whole - 1, 0 - fraction};
  }
}

/// 2^exponent in units of 2^-fraction_bits, to nearest, for an irrational result below 2^34 units.
/// \pre -2^15 < exponent < 2^15
constexpr std::int64_t nearest_precise_power(const real& exponent, int fraction_bits) noexcept {
  const int whole = static_cast<int>(static_cast<std::int64_t>(exponent >> real_bits));
  const real power = precise_power(exponent - (real{whole} << real_bits));
  return nearest_units(whole < 0 ? power >> -whole : power << whole, fraction_bits);
}

/// 2^(exponent) in units of 2^-fraction_bits, to nearest; 2^35 for every result that is not below
/// 2^34 units.
/// \param error of the exponent, in units of 2^-64, below 2^60
/// \param precise decides between two neighbours, of which it is given the lower one
template <class Precise>
constexpr std::int64_t nearest_power(const binary_exponent& exponent, std::int64_t error,
                                     int fraction_bits, const Precise& precise) noexcept {
  constexpr std::int64_t highest = 34;
  if (exponent.whole >= highest - fraction_bits) return std::int64_t{1} << (highest + 1);
  if (exponent.whole < -2 - fraction_bits) return 0;
  const int place = static_cast<int>(exponent.whole) + fraction_bits;
  // In units of 2^-61, power_of_two() is off by less than 5. An error of the exponent adds less
  // than log(2)/4 of it.
  const auto power = static_cast<std::int64_t>(power_of_two(exponent.fraction) >> 2);
  const nearest_ends ends = nearest_within(power, error / 4 + 6, 61 - place);
  return ends.agree() ? ends.low : precise(ends.low);
}

/// The exponential of x / 2^32 in units of 2^-fraction_bits, rounded to nearest, ties by rule R;
/// 2^35 for every result that is not below 2^34 units.
///
/// Only a power of two with a whole exponent is rational.
template <exponential_base Base, rounding R>
constexpr std::int64_t nearest_exponential(std::int64_t x, int fraction_bits) noexcept {
  const binary_exponent exponent = exponent_of<Base>(x);
  const std::int64_t place = exponent.whole + fraction_bits;
  if (place >= -2 && place < 34 &&
      (x == 0 || (Base == exponential_base::two && exponent.fraction == 0))) {
    return shift_right<R>(std::int64_t{1} << (place + 2), 2);
  }
  // |x| is below 24 * 2^32 unless the result is out of range.
  constexpr std::int64_t error = Base == exponential_base::two ? 0 : 49;
  return nearest_power(exponent, error, fraction_bits, [&](std::int64_t /*low*/) {
    real precise = real{x} << (real_bits - 32);
    if constexpr (Base == exponential_base::e) precise = product(precise, real_from(real_log2_e));
    return nearest_precise_power(precise, fraction_bits);
  });
}

/// The logarithm of 2 in a base.
struct logarithm_scale {
  std::int64_t whole;      ///< in units of 2^-57, to nearest
  std::uint64_t fraction;  ///< in units of 2^-64, rounded down
  real precise;
};

template <logarithm_base Base>
inline constexpr logarithm_scale scale_of = [] {
  const auto scale = [](const real& precise) -> logarithm_scale {
    return {static_cast<std::int64_t>(((precise >> (real_bits - 58)) + real{1}) >> 1),
            static_cast<std::uint64_t>(precise >> (real_bits - 64)), precise};
  };
  if constexpr (Base == logarithm_base::two) return scale(real_one);
  if constexpr (Base == logarithm_base::e) return scale(real_from(real_log_2));
  if constexpr (Base == logarithm_base::ten) return scale(real_from(real_log10_2));
}();

/// log2(m / 2^32) in units of 2^-64, for 2^32 <= m < 2^33. The error is below 5 units.
///
/// A reciprocal c of the leading six bits makes m c = 1 + r with 0 <= r < 2^-6 + 2^-32, without an
/// error. The Taylor series loses at most 3 units, its remainder is below 2^-68, and the logarithm
/// of c is to nearest.
constexpr std::uint64_t binary_logarithm(std::uint64_t m) noexcept {
  const std::size_t interval = m >> 26 & 63;
  // m c is 2^64 (1 + r), of which 2^64 is lost; 32 r in units of 2^-64
  const std::uint64_t rest = m * reciprocals[interval] << 5;
  std::uint64_t sum = logarithm_coefficients.back();
  for (std::size_t n = logarithm_coefficients.size() - 1; n-- > 0;) {
    sum = logarithm_coefficients[n] - multiply_high(rest, sum);
  }
  return logarithms[interval] + multiply_high(rest, sum);
}

/// A number from 1 to 2 times a power of two: m / 2^32 * 2^exponent.
struct scaled_word {
  std::uint64_t m;
  int exponent;
};

/// raw / 2^fraction_bits. \pre 0 < raw < 2^33
constexpr scaled_word scaled(std::uint64_t raw, int fraction_bits) noexcept {
  const int unused = std::countl_zero(raw) - 31;
  return {raw << unused, 32 - unused - fraction_bits};
}

/// The binary logarithm. Its error is below 2^-168.
constexpr real precise_logarithm(const scaled_word& x) noexcept {
  return (real{x.exponent} << real_bits) + precise_logarithm(x.m);
}

/// The logarithm of raw / 2^fraction_bits in units of 2^-fraction_bits, rounded to nearest. There
/// are no ties: a logarithm of a rational number is whole or irrational in these bases.
/// \pre 0 < raw < 2^33
template <logarithm_base Base>
constexpr std::int64_t nearest_logarithm(std::uint64_t raw, int fraction_bits) noexcept {
  const scaled_word x = scaled(raw, fraction_bits);
  const std::uint64_t fraction = binary_logarithm(x.m);
  std::int64_t value = x.exponent * scale_of<Base>.whole;
  if constexpr (Base == logarithm_base::two) {
    value += static_cast<std::int64_t>(fraction >> 7);
  } else {
    value += static_cast<std::int64_t>(multiply_high(fraction, scale_of<Base>.fraction) >> 7);
  }
  // In units of 2^-57, the whole exponent is off by at most 16.5, the rest by less than 2.
  constexpr std::int64_t error = 20;
  const nearest_ends ends = nearest_within(value, error, 57 - fraction_bits);
  if (ends.agree()) return ends.low;
  return nearest_units(product(precise_logarithm(x), scale_of<Base>.precise), fraction_bits);
}

}  // namespace fixproof::detail

/// @file
/// Powers and roots, computed in digits for words of at most 32 bits. Each is the nearest integer
/// of ulps, as in power.hpp, without a first try in words.
#pragma once

#include <cstdint>

#include "fixed/detail/digit_exponential.hpp"
#include "fixed/detail/digit_series.hpp"
#include "fixed/detail/power.hpp"
#include "fixed/detail/rounding.hpp"

namespace fixproof::detail::in_digits {

/// The highest r below 2^35 for which o^3, or o^2 raw, is at most `bound`, where o = 2r - 1; 0 if
/// there is none. The root is then nearest to r, or a tie that goes up.
///
/// o counts units of 2^-36, so that every product is exact. @param bound in units of 2^-108
constexpr std::int64_t nearest_root(std::uint64_t raw, const real& bound, bool is_cube) noexcept {
  constexpr int lowest = (real_bits - 108) / digit_bits;
  std::int64_t root = 0;
  for (std::int64_t bit = std::int64_t{1} << 34; bit > 0; bit >>= 1) {
    const real odd = scaled_integer(2 * (root + bit) - 1, real_bits - 36, lowest);
    real product = odd;
    product *= odd;
    product *= is_cube ? odd : scaled_integer(static_cast<std::int64_t>(raw), real_bits - 36);
    real room = bound;
    room -= product;
    if (!room.negative()) root += bit;
  }
  return root;
}

/// The cube root of raw / 2^fraction_bits. There are no ties.
constexpr std::int64_t cube_root_ulps(std::uint64_t raw, int fraction_bits) noexcept {
  return nearest_root(
      raw, scaled_integer(static_cast<std::int64_t>(raw), 2 * fraction_bits + 3 + real_bits - 108),
      true);
}

/// 1 / sqrt(raw / 2^fraction_bits). Only a half is a tie.
constexpr std::int64_t reciprocal_root_ulps(std::uint64_t raw, int fraction_bits,
                                            rounding ties) noexcept {
  const int exponent = 3 * fraction_bits + 2;
  if (exponent < 34 && raw == std::uint64_t{1} << exponent) return rounded_half(false, ties);
  return nearest_root(raw, scaled_integer(1, exponent + real_bits - 108), false);
}

/// floor(sqrt(n))
constexpr std::uint32_t whole_root(std::uint32_t n) noexcept {
  std::uint32_t root = 0;
  for (std::uint32_t bit = 1U << 15; bit > 0; bit >>= 1) {
    if ((root + bit) * (root + bit) <= n) root += bit;
  }
  return root;
}

/// x^y as an odd number of half ulps, or 0 if it is not a tie or is out of range, for x = raw /
/// 2^fraction_bits and y = exponent / 2^fraction_bits.
///
/// Let x be m 2^e with an odd m, and y be n / 2^k with an odd n. A power in whole half ulps needs k
/// whole square roots of m, an e that 2^k divides and, unless m is 1, n > 0. The power is then m^n
/// times a power of two, and m^n is odd. @pre 0 < raw < 2^32, exponent != 0
constexpr std::int64_t odd_half_ulps(std::uint64_t raw, std::int64_t exponent,
                                     int fraction_bits) noexcept {
  auto m = static_cast<std::uint32_t>(raw);
  std::int64_t e = -fraction_bits;
  for (; m % 2 == 0; m /= 2) ++e;
  for (int roots = fraction_bits; roots > 0; --roots) {
    if (exponent % 2 == 0) {
      exponent /= 2;
      continue;
    }
    const std::uint32_t root = whole_root(m);
    if (root * root != m || e % 2 != 0) return 0;
    m = root;
    e /= 2;
  }
  if (e * exponent != -1 - fraction_bits || (m > 1 && exponent < 0)) return 0;
  std::uint64_t power = 1;
  for (; m > 1 && exponent > 0; --exponent) {
    if (power >> 32 != 0) return 0;
    power *= m;
  }
  return power >> 34 != 0 ? 0 : static_cast<std::int64_t>(power);
}

constexpr std::int64_t power_ulps(std::uint64_t raw, std::int64_t exponent, int fraction_bits,
                                  rounding ties) noexcept {
  if (exponent == 0) return std::int64_t{1} << fraction_bits;
  if (const std::int64_t odd = odd_half_ulps(raw, exponent, fraction_bits); odd != 0) {
    const std::int64_t low = odd >> 1;
    return low + (ties == rounding::half_even ? low & 1 : ties == rounding::floor ? 0 : 1);
  }
  const std::int64_t magnitude = exponent < 0 ? -exponent : exponent;
  // y multiplies the error of the logarithm. For y below 2^16, that makes an error below 2^-60 of
  // the value.
  for (int lowest = magnitude >> (fraction_bits + 16) == 0 ? short_digit : 0;; lowest = 0) {
    real power = logarithm_of(raw, fraction_bits, lowest);
    if (exponent < 0) power.negate();
    power *= scaled_integer(magnitude, real_bits);
    power.shift(-fraction_bits);
    take_power(power);
    const std::int64_t ulps = nearest_units(power, fraction_bits);
    if (ulps != undecided) return ulps;
  }
}

// Constant expressions compute in words; variant.hpp has the reasons.

constexpr std::int64_t nearest_cube_root(std::uint64_t raw, int fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated()) return detail::nearest_cube_root(raw, fraction_bits);
  return cube_root_ulps(raw, fraction_bits);
}

template <rounding Rounding>
constexpr std::int64_t nearest_reciprocal_root(std::uint64_t raw, int fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated())
    return detail::nearest_reciprocal_root<Rounding>(raw, fraction_bits);
  return reciprocal_root_ulps(raw, fraction_bits, Rounding);
}

template <rounding Rounding>
constexpr std::int64_t nearest_real_power(std::uint64_t raw, std::int64_t exponent,
                                          int fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated()) {
    return detail::nearest_real_power<Rounding>(raw, exponent, fraction_bits);
  }
  return power_ulps(raw, exponent, fraction_bits, Rounding);
}

}  // namespace fixproof::detail::in_digits

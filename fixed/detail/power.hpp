/// \file
/// Powers and roots of words of at most 32 bits, each the nearest integer of ulps.
///
/// All are powers of two whose exponent is a multiple of a binary logarithm. Where 64 bits allow
/// two integers, exact integers decide a root; a power with a rational result is computed exactly,
/// and any other one again with more bits.
#pragma once

#include <bit>
#include <cstdint>

#include "fixed/detail/exponential.hpp"
#include "fixed/detail/real.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/square_root.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/detail/wide_integer.hpp"

namespace fixproof::detail {

/// log2(raw / 2^fraction_bits) in units of 2^-64. The error is below 5 units.
constexpr int128 logarithm_in_units(std::uint64_t raw, int fraction_bits) noexcept {
  const scaled_word x = scaled(raw, fraction_bits);
  return (int128{x.exponent} << 64) + int128{binary_logarithm(x.m)};
}

/// An exponent in units of 2^-64.
constexpr binary_exponent split(const int128& exponent) noexcept {
  return {static_cast<std::int64_t>(exponent >> 64), static_cast<std::uint64_t>(exponent)};
}

/// The cube root of raw / 2^fraction_bits in units of 2^-fraction_bits. There are no ties: eight
/// times a word is no odd cube.
constexpr std::int64_t nearest_cube_root(std::uint64_t raw, int fraction_bits) noexcept {
  if (raw == 0) return 0;
  const int128 log = logarithm_in_units(raw, fraction_bits);
  // log / 3 by a product with (2^64 + 2) / 3, of the magnitude
  constexpr std::uint64_t third = 0x5555555555555556;
  const bool is_negative = log < int128{0};
  const int128 magnitude = is_negative ? -log : log;
  const auto high = static_cast<std::uint64_t>(magnitude >> 64);
  const int128 part = int128{high} * int128{third} +
                      int128{multiply_high(static_cast<std::uint64_t>(magnitude), third)};
  constexpr std::int64_t error = 40;  // 5/3, and 2/3 for each of 33 parts of 2^64, and 1
  return nearest_power(split(is_negative ? -part : part), error, fraction_bits,
                       [&](std::int64_t low) {
                         const int128 middle{2 * low + 1};
                         const int128 cube = int128{raw} << (2 * fraction_bits + 3);
                         return low + (middle * middle * middle < cube ? 1 : 0);
                       });
}

/// 1 / sqrt(raw / 2^fraction_bits) in units of 2^-fraction_bits. \pre raw > 0
///
/// Only a half is a tie, the root of a power of two; rule R decides.
template <rounding R>
constexpr std::int64_t nearest_reciprocal_root(std::uint64_t raw, int fraction_bits) noexcept {
  const int128 log = logarithm_in_units(raw, fraction_bits);
  constexpr std::int64_t error = 4;
  return nearest_power(split(-log >> 1), error, fraction_bits, [&](std::int64_t low) {
    const int128 middle{2 * low + 1};
    const int128 scaled = middle * middle * int128{raw};
    const int128 exact = int128{1} << (3 * fraction_bits + 2);
    if (scaled == exact) return shift_right<R>(2 * low + 1, 1);
    return low + (scaled < exact ? 1 : 0);
  });
}

/// 1 / (raw / 2^FractionBits) in units of 2^-FractionBits, rounded by rule R. \pre raw is not 0
template <rounding R, int FractionBits, class Raw>
constexpr auto nearest_reciprocal(Raw raw) noexcept {
  using wide = signed_t<2 * FractionBits + larger(bits_of<Raw> - FractionBits, 2) + 2>;
  return rounded_ratio<R>(wide{1} << (2 * FractionBits), wide{raw});
}

/// A rational power: the integer nearest to it in ulps, or the news that the power is not rational
/// or has too many bits to be a tie.
struct exact_power {
  bool is_known;
  std::int64_t ulps;
};

/// x^y for x = raw / 2^fraction_bits and y = exponent / 2^fraction_bits.
///
/// Let x be m 2^e with an odd m, and y be n / 2^k with an odd n. The power is rational only if k
/// square roots of m are whole and 2^k divides e. Then it is a power of two, or for n > 0 an odd
/// integer m^n times one, or for n < 0 the reciprocal of that, which is no tie.
/// \pre raw > 0, exponent != 0
template <rounding R>
constexpr exact_power rational_power(std::uint64_t raw, std::int64_t exponent,
                                     int fraction_bits) noexcept {
  constexpr exact_power unknown{false, 0};
  std::uint64_t m = raw >> std::countr_zero(raw);
  std::int64_t e = std::countr_zero(raw) - fraction_bits;
  std::int64_t n = exponent;
  int roots = fraction_bits;
  for (; roots > 0 && n % 2 == 0; --roots) n /= 2;
  for (; roots > 0; --roots) {
    const auto root = static_cast<std::uint64_t>(nearest_sqrt_of_word(m));
    if (root * root != m || e % 2 != 0) return unknown;
    m = root;
    e /= 2;
  }
  if (m > 1 && n < 0) return unknown;
  // From 2^66 on, an odd integer has more bits than a tie.
  int128 power{1};
  if (m > 1) {
    for (std::int64_t i = 0; i < n; ++i) {
      power = power * int128{m};
      if ((int128{1} << 66) < power) return unknown;
    }
  }
  constexpr std::int64_t far_out = 100;
  if (n > far_out || n < -far_out) {
    // A power of two that is out of range or rounds to zero, unless it is 1.
    return {true, e == 0               ? std::int64_t{1} << fraction_bits
                  : (e > 0) == (n > 0) ? std::int64_t{1} << 35
                                       : 0};
  }
  const std::int64_t shift = e * n + fraction_bits;
  if (shift >= 35) return {true, std::int64_t{1} << 35};
  if (shift >= 0) {
    const int128 ulps = power << static_cast<int>(shift);
    constexpr std::int64_t highest = std::int64_t{1} << 35;
    return {true, int128{highest} < ulps ? highest : static_cast<std::int64_t>(ulps)};
  }
  if (shift < -100) return {true, 0};
  return {true, static_cast<std::int64_t>(shift_right<R>(power, static_cast<int>(-shift)))};
}

/// x^y for x = raw / 2^fraction_bits and y = exponent / 2^fraction_bits in units of
/// 2^-fraction_bits, rounded to nearest, ties by rule R. \pre raw > 0
template <rounding R>
constexpr std::int64_t nearest_real_power(std::uint64_t raw, std::int64_t exponent,
                                          int fraction_bits) noexcept {
  if (exponent == 0) return std::int64_t{1} << fraction_bits;
  const int128 log = logarithm_in_units(raw, fraction_bits);
  // At most 2^70 and 2^32.
  const int128 scaled_log = log * int128{exponent} >> fraction_bits;
  const std::int64_t error = ((exponent < 0 ? -exponent : exponent) * 5 >> fraction_bits) + 6;
  return nearest_power(split(scaled_log), error, fraction_bits, [&](std::int64_t /*low*/) {
    const exact_power exact = rational_power<R>(raw, exponent, fraction_bits);
    if (exact.is_known) return exact.ulps;
    const real precise = precise_logarithm(scaled(raw, fraction_bits));
    return nearest_precise_power(precise * real{exponent} >> fraction_bits, fraction_bits);
  });
}

}  // namespace fixproof::detail

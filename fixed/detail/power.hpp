/// @file
/// Powers and roots of words of at most 32 bits, each the nearest integer of ulps.
///
/// A root is first computed with an error below 1/4, and exact integers decide between the two
/// integers next to it. A power is a power of two whose exponent is a multiple of a binary
/// logarithm. Where 64 bits allow two integers, a power with a rational result is computed exactly,
/// and any other one again with more bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "fixed/detail/assert.hpp"
#include "fixed/detail/bits.hpp"
#include "fixed/detail/choose.hpp"
#include "fixed/detail/exponential.hpp"
#include "fixed/detail/function_tables.hpp"
#include "fixed/detail/hardware.hpp"
#include "fixed/detail/nearest.hpp"
#include "fixed/detail/quotient.hpp"
#include "fixed/detail/real.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/series.hpp"
#include "fixed/detail/square_root.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/detail/wide_integer.hpp"

namespace fixproof::detail {

/// The integer next to 1 / sqrt(raw / 2^fraction_bits) in units of 2^-fraction_bits: the nearest
/// one or the one below.
///
/// It is the root of 2^(3 fraction_bits) / raw. Each of the two operations in double is off by less
/// than 2^-52 of its result in every rounding mode, so a root below 2^48 is off by less than 1/4.
constexpr std::int64_t below_reciprocal_root(std::uint64_t raw, int fraction_bits) noexcept {
  if constexpr (hardware_double) {
    if (!std::is_constant_evaluated()) {
      const auto unit = static_cast<double>(std::int64_t{1} << fraction_bits);
      const double scale = unit * unit * unit;
      const auto divisor = static_cast<double>(static_cast<std::int64_t>(raw));
      return static_cast<std::int64_t>(sqrt(scale / divisor));
    }
  }
  // In 16.16, a Cortex-M0 takes 4,900 instructions with a numerator of one word, and 123,300 with
  // one of 128 bits.
  if (fraction_bits <= 21)
    return nearest_sqrt_of_word((std::uint64_t{1} << (3 * fraction_bits)) / raw);
  const int128 numerator = int128{1} << (3 * fraction_bits);
  return static_cast<std::int64_t>(
      nearest_sqrt_by_pairs<49>(truncated_ratio(numerator, int128{raw})));
}

/// 1 / sqrt(raw / 2^fraction_bits) in units of 2^-fraction_bits. @pre 0 < raw < 2^32
///
/// Only a half is a tie, the root of a power of two; rule Rounding decides.
template <rounding Rounding>
constexpr std::int64_t nearest_reciprocal_root(std::uint64_t raw, int fraction_bits) noexcept {
  // The root is at most 2^48, and its square times raw at most 2^(3 fraction_bits): so 128 bits
  // have room for four times that and 4 root raw.
  const std::int64_t low = below_reciprocal_root(raw, fraction_bits);
  FIXED_ASSERT(low >= 0 && low <= std::int64_t{1} << 48);
  const int128 middle{2 * low + 1};
  const int128 scaled = middle * middle * int128{raw};
  const int128 exact = int128{1} << (3 * fraction_bits + 2);
  if (scaled == exact) return shift_right<Rounding>(2 * low + 1, 1);
  return low + (scaled < exact ? 1 : 0);
}

/// The cube root of raw / 2^fraction_bits in units of 2^-fraction_bits, rounded down after an error
/// below 1/4. @pre 0 < raw < 2^32
///
/// With a reciprocal c of the leading six bits, m c is 1 + r as in binary_logarithm(). The root is
/// that of 1, 2 or 4, times that of 1 / c, times the binomial series of (1 + r)^(1/3). Its terms
/// after the fourth are below 2^-35. The power of two is at most 2^31 ulps. The root is off by
/// less than 268435456 units of 2^-61 of it, which is 1/4 ulp.
constexpr std::int64_t below_cube_root(std::uint64_t raw, int fraction_bits) noexcept {
  const scaled_word x = scaled(raw, fraction_bits);
  // From 0 to 31 + 64, as x.exponent >= -fraction_bits, so at least 61 - 31 bits of the root are
  // dropped below.
  const auto exponent = static_cast<std::uint32_t>(x.exponent + 3 * fraction_bits);
  const std::size_t interval = x.m >> 26 & 63;
  const std::uint64_t rest = x.m * reciprocals[interval] << 5;
  const std::uint64_t sum =
      sum_of_alternating_series<cube_root_coefficients.size()>(cube_root_coefficients, rest);
  const std::uint32_t third = exponent % 3;
  const std::uint64_t middle = multiply_high(cube_roots[interval], roots_of_powers[third]);
  const std::uint64_t root = middle + multiply_high(middle, multiply_high(rest, sum));
  return static_cast<std::int64_t>(root >> (61 - exponent / 3));
}

/// The cube root of raw / 2^fraction_bits in units of 2^-fraction_bits. There are no ties: eight
/// times a word is no odd cube. @pre raw < 2^32
constexpr std::int64_t nearest_cube_root(std::uint64_t raw, int fraction_bits) noexcept {
  if (raw == 0) return 0;
  // At most 2^32, so the cube of the middle is below 2^100, as is that of the exact root.
  const std::int64_t low = below_cube_root(raw, fraction_bits);
  FIXED_ASSERT(low >= 0 && low <= std::int64_t{1} << 32);
  const int128 middle{2 * low + 1};
  const int128 cube = int128{raw} << (2 * fraction_bits + 3);
  return low + (middle * middle * middle < cube ? 1 : 0);
}

/// 1 / (raw / 2^FractionBits) in units of 2^-FractionBits, rounded by rule Rounding. @pre raw is
/// not 0
template <rounding Rounding, int FractionBits, class Raw>
constexpr auto nearest_reciprocal(Raw raw) noexcept {
  using wide = signed_t<2 * FractionBits + larger(bits_of<Raw> - FractionBits, 2) + 2>;
  // Without a remainder it takes fewer instructions.
  if constexpr (std::is_same_v<wide, std::int64_t> && std::is_signed_v<Raw> && FractionBits <= 30 &&
                Rounding != rounding::half_even) {
    return quotient_by_integers<Rounding, FractionBits>(std::int32_t{1} << FractionBits, raw);
  } else {
    return quick_ratio<Rounding>(wide{1} << (2 * FractionBits), wide{raw});
  }
}

/// How many terms of the logarithm a quick power takes.
inline constexpr std::size_t quick_real_power_terms = 6;

/// A rational power as the nearest integer of ulps. `is_known` is false if the power is not
/// rational, or has too many bits to be a tie.
struct exact_power {
  bool is_known;
  std::int64_t ulps;
};

/// m^n, or 0 above 2^66, where an odd integer has more bits than a tie. @pre m > 1
constexpr int128 short_power(std::uint64_t m, std::int64_t n) noexcept {
  int128 power{1};
  for (std::int64_t i = 0; i < n; ++i) {
    power = power * int128{m};
    if ((int128{1} << 66) < power) return int128{0};
  }
  return power;
}

/// x^y for x = raw / 2^fraction_bits and y = exponent / 2^fraction_bits.
///
/// Let x be m 2^e with an odd m, and y be n / 2^k with an odd n. The power is rational only if k
/// square roots of m are whole and 2^k divides e. Then it is a power of two, or for n > 0 an odd
/// integer m^n times a power of two, or for n < 0 the reciprocal of such a number, which is no tie.
/// @pre raw > 0, exponent != 0
template <rounding Rounding>
constexpr exact_power rational_power(std::uint64_t raw, std::int64_t exponent,
                                     int fraction_bits) noexcept {
  constexpr exact_power unknown{false, 0};
  std::uint64_t m = raw >> trailing_zeros(raw);
  std::int64_t e = trailing_zeros(raw) - fraction_bits;
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
  const int128 power = m > 1 ? short_power(m, n) : int128{1};
  if (power == int128{0}) return unknown;
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
  const int places = static_cast<int>(-shift);
  // Powers from 2^34 ulps on never come here, because both ends of their bounds are beyond.
  FIXED_ASSERT((power >> places) < (int128{1} << 36));
  // Rule floor is for magnitudes whose negatives round half up: only ties go down.
  if constexpr (Rounding == rounding::floor) {
    return {true, -static_cast<std::int64_t>(shift_right<rounding::half_up>(-power, places))};
  } else {
    return {true, static_cast<std::int64_t>(shift_right<Rounding>(power, places))};
  }
}

/// The ends of x^y for y = exponent / 2^fraction_bits in units of 2^-fraction_bits.
template <std::size_t LogarithmTerms, std::size_t PowerTerms>
constexpr nearest_ends real_power_within(const scaled_word& x, std::int64_t exponent,
                                         int fraction_bits) noexcept {
  // A quick logarithm is in units of 2^-57, so that its product with a word takes one
  // multiplication.
  constexpr bool is_quick = LogarithmTerms < logarithm_terms;
  using log_type = std::conditional_t<is_quick, std::int64_t, int128>;
  constexpr int bits = is_quick ? 57 : 64;
  const std::uint64_t fraction = binary_logarithm<LogarithmTerms>(x.m) >> (64 - bits);
  const log_type log = (log_type{x.exponent} << bits) + static_cast<log_type>(fraction);
  // At most 2^70 and 2^32.
  const int128 scaled_log = int128{log} * int128{exponent} << (64 - bits) >> fraction_bits;
  constexpr std::int64_t log_error = logarithm_error<LogarithmTerms> + (is_quick ? 128 : 0);
  const std::int64_t error =
      (chosen(exponent < 0, -exponent, exponent) * log_error >> fraction_bits) + 6;
  // The whole part is at most 2^38.
  FIXED_ASSERT(int128{static_cast<std::int64_t>(scaled_log >> 64)} == scaled_log >> 64);
  return power_within<PowerTerms>(
      {static_cast<std::int64_t>(scaled_log >> 64), static_cast<std::uint64_t>(scaled_log)}, error,
      fraction_bits);
}

/// Like nearest_real_power(), but without the quick try. @param x raw / 2^fraction_bits
template <rounding Rounding>
constexpr std::int64_t careful_real_power(std::uint64_t raw, const scaled_word& x,
                                          std::int64_t exponent, int fraction_bits) noexcept {
  const nearest_ends ends =
      real_power_within<logarithm_terms, power_terms>(x, exponent, fraction_bits);
  if (ends.agree()) [[likely]]
    return ends.low;
  const exact_power exact = rational_power<Rounding>(raw, exponent, fraction_bits);
  if (exact.is_known) return exact.ulps;
  return nearest_precise_power(precise_logarithm(x) * real{exponent} >> fraction_bits,
                               fraction_bits);
}

/// x^y for x = raw / 2^fraction_bits and y = exponent / 2^fraction_bits in units of
/// 2^-fraction_bits, rounded to nearest, ties by rule Rounding. @pre raw > 0
template <rounding Rounding>
constexpr std::int64_t nearest_real_power(std::uint64_t raw, std::int64_t exponent,
                                          int fraction_bits) noexcept {
  if (exponent == 0) return std::int64_t{1} << fraction_bits;
  const scaled_word x = scaled(raw, fraction_bits);
  if (fraction_bits <= quick_bits) {
    const nearest_ends quick =
        real_power_within<quick_real_power_terms, quick_power_terms>(x, exponent, fraction_bits);
    if (quick.agree()) [[likely]]
      return quick.low;
  }
  return careful_real_power<Rounding>(raw, x, exponent, fraction_bits);
}

}  // namespace fixproof::detail

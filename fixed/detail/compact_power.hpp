/// @file
/// Roots and powers, computed in compact words of at most 32 bits. Each is the nearest integer of
/// ulps.
///
/// Exact integers decide roots. In formats of more than 16 fraction bits they have more than 64
/// bits, so digits compute them. The steps of powers are those of power.hpp without a quick try,
/// but whole powers decide the rest.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fixed/detail/assert.hpp"
#include "fixed/detail/compact_exponential.hpp"
#include "fixed/detail/compact_words.hpp"
#include "fixed/detail/digit_power.hpp"
#include "fixed/detail/power.hpp"
#include "fixed/detail/rounding.hpp"

namespace fixproof::detail::in_compact_words {

/// The formats whose roots have 64 bits: raw 4^fraction_bits and 2^(3 fraction_bits + 4) fit.
inline constexpr int most_root_bits = 16;

/// The cube root of raw / 2^fraction_bits. @pre raw < 2^32, fraction_bits <= most_root_bits
///
/// Takes three bits of n = raw 4^fraction_bits at a time from the top. With the root r of the bits
/// so far, `rest` is what r^3 lacks of them, so it is at most 3 r^2 + 3 r. Of n, the next bits are
/// on top. The root is nearer to r + 1 if n - r^3 is above (r + 1/2)^3 - r^3, which is no integer.
constexpr std::int64_t cube_root_ulps(std::uint64_t raw, int fraction_bits) noexcept {
  FIXED_ASSERT(raw >> 32 == 0 && fraction_bits <= most_root_bits);
  std::uint64_t n = raw << (2 * fraction_bits);
  std::uint64_t rest = n >> 63;
  n <<= 1;
  std::uint32_t root = 0;
  std::uint64_t square = 0;
  for (int i = 0;; ++i) {
    // (root + 1)^3 - root^3
    const std::uint64_t more = 3 * (square + root) + 1;
    if (rest >= more) {
      rest -= more;
      square += 2 * root + 1;
      ++root;
    }
    if (i == 21) break;
    root <<= 1;
    square <<= 2;
    rest = rest << 3 | n >> 61;
    n <<= 3;
  }
  return root + (4 * rest > 3 * (2 * square + root) ? 1 : 0);
}

/// 1 / sqrt(raw / 2^fraction_bits). @pre 0 < raw < 2^32, fraction_bits <= most_root_bits
///
/// The root of 2^(3 fraction_bits) / raw, both rounded down, is the nearest integer or the one
/// below. Squares modulo 2^64 decide, because both are below 2^54. Only a half is a tie.
constexpr std::int64_t reciprocal_root_ulps(std::uint64_t raw, int fraction_bits,
                                            rounding ties) noexcept {
  FIXED_ASSERT(raw > 0 && raw >> 32 == 0 && fraction_bits <= most_root_bits);
  std::uint64_t quotient = 0;
  if (fraction_bits > 0) {
    // If raw is 1, the quotient is one too low, as it is below, which the last line makes good.
    std::uint64_t rest = 1;
    quotient = take_quotient(rest, raw, fraction_bits);
    quotient = quotient << 2 * fraction_bits | take_quotient(rest, raw, 2 * fraction_bits);
  }
  const std::uint64_t low = take_root(quotient);
  const std::uint64_t middle = 2 * low + 1;
  const std::uint64_t scaled = middle * middle * raw;
  const std::uint64_t exact = std::uint64_t{1} << (3 * fraction_bits + 2);
  if (scaled == exact) return in_digits::rounded_half(false, ties);
  return static_cast<std::int64_t>(low) + (scaled < exact ? 1 : 0);
}

/// A number from 1 to 2, in words of units of 2^-191 with the lowest first, times a power of two.
struct long_number {
  static constexpr std::size_t size = 6;
  std::array<std::uint32_t, size> words;
  std::int64_t exponent;
};

/// Sets the upper two words to `top`, and the others to 0, without memset(), which takes a tenth of
/// a kilobyte.
FIXED_NOINLINE constexpr void fill(std::uint32_t* words, std::size_t size,
                                   std::uint64_t top) noexcept {
  while (size-- > 0) {
    words[size] = static_cast<std::uint32_t>(top >> 32);
    top <<= 32;
  }
}

/// Multiplies a by b, and rounds down.
FIXED_NOINLINE constexpr void multiply(long_number& a, const long_number& b) noexcept {
  constexpr std::size_t size = long_number::size;
  // The upper words of the sum so far, and the one below them
  std::array<std::uint32_t, size + 1> sum;  // NOLINT(*-member-init): fill() sets it
  fill(sum.data(), sum.size(), 0);
  for (const std::uint32_t word : a.words) {
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < size; ++i) {
      carry += product_of(word, b.words[i]) + sum[i + 1];
      sum[i] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    sum[size] = static_cast<std::uint32_t>(carry);
  }
  const std::uint32_t is_two = sum[size] >> 31;
  a.exponent += b.exponent + is_two;
  for (std::size_t i = 0; i < size; ++i) {
    a.words[i] = is_two != 0 ? sum[i + 1] : sum[i + 1] << 1 | sum[i] >> 31;
  }
}

/// word 2^places. @pre word > 0
FIXED_NOINLINE constexpr void set(long_number& number, std::uint64_t word, int places) noexcept {
  places += 63;
  for (; word >> 63 == 0; word <<= 1) --places;
  fill(number.words.data(), long_number::size, word);
  number.exponent = places;
}

/// Whether x^y is a tie, for x = raw / 2^fraction_bits and y = n / 2^fraction_bits, or -y if it is
/// negative. @pre It is from half an ulp to 2^34.
///
/// Let x be m 2^e with an odd m, and y be n / 2^k with an odd n. A power in whole half ulps needs k
/// whole square roots of m, and an e that 2^k divides. It is then m^n, which is odd, times a power
/// of two. For a negative y, m is 1, because other powers have no finite digits. For a power in
/// range, e n has 31 bits.
constexpr bool is_tie(std::uint32_t raw, std::uint32_t n, bool is_negative,
                      int fraction_bits) noexcept {
  int e = -fraction_bits;
  for (; raw % 2 == 0; raw >>= 1) ++e;
  for (int roots = fraction_bits; roots > 0; --roots) {
    if (n % 2 == 0) {
      n >>= 1;
    } else {
      const std::uint32_t root = in_digits::whole_root(raw);
      if (root * root != raw || e % 2 != 0) return false;
      raw = root;
      e /= 2;
    }
  }
  if (is_negative) e = -e;
  return static_cast<std::uint32_t>(e) * n == static_cast<std::uint32_t>(-1 - fraction_bits);
}

/// Whether x^y is above `odd` half ulps. @pre It is no tie.
///
/// Both sides to the power of 2^fraction_bits are whole powers, less than 2^-157 of themselves too
/// low. So is x^y, which has less than 2^35 ulps: it decides if it is 2^-122 ulps from a tie.
constexpr bool is_above(std::uint32_t raw, std::uint32_t n, bool is_negative, int fraction_bits,
                        std::uint64_t odd) noexcept {
  // NOLINTBEGIN(*-member-init): set() sets them
  long_number factor;
  long_number power;
  long_number tie;
  // NOLINTEND(*-member-init)
  set(tie, odd, -1 - fraction_bits);
  for (int i = 0; i < fraction_bits; ++i) multiply(tie, tie);
  set(factor, raw, -fraction_bits);
  set(power, 1, 0);
  for (std::uint32_t bit = std::uint32_t{1} << 31; bit != 0; bit >>= 1) {
    multiply(power, power);
    if ((n & bit) != 0) multiply(power, factor);
  }
  if (is_negative) {
    multiply(power, tie);
    return power.exponent < 0;
  }
  if (power.exponent != tie.exponent) return power.exponent > tie.exponent;
  for (std::size_t i = long_number::size; i-- > 0;) {
    if (power.words[i] != tie.words[i]) return power.words[i] > tie.words[i];
  }
  return false;
}

/// The zeros above the highest one of x. @pre x > 0
///
/// A loop, because what the compiler calls takes 60 bytes.
FIXED_NOINLINE constexpr int zeros_above(std::uint32_t x) noexcept {
  int zeros = 0;
  for (; x >> 31 == 0; x <<= 1) ++zeros;
  return zeros;
}

/// x^y for x = raw / 2^fraction_bits and y = exponent / 2^fraction_bits, and 1 for y = 0. @pre raw
/// > 0 or exponent = 0, |exponent| < 2^32
constexpr std::int64_t real_power_ulps(std::uint32_t raw, std::int64_t exponent, int fraction_bits,
                                       rounding ties) noexcept {
  if (exponent == 0) return std::int64_t{1} << fraction_bits;
  const bool is_negative = exponent < 0;
  const auto n = static_cast<std::uint32_t>(is_negative ? -exponent : exponent);
  const int zeros = zeros_above(raw);
  const std::uint64_t log = binary_logarithm_of(raw << zeros << 1);
  // The logarithm has a whole part of 31 - fraction_bits - zeros. In units of 2^-(64 +
  // fraction_bits), n times the logarithm is high 2^64 + low.
  std::uint64_t low = product_of(n, static_cast<std::uint32_t>(log));
  const std::uint64_t middle = product_of(n, static_cast<std::uint32_t>(log >> 32)) + (low >> 32);
  low = middle << 32 | static_cast<std::uint32_t>(low);
  auto high = static_cast<std::int64_t>(
      (std::uint64_t{n} << 5) + (middle >> 32) -
      product_of(n, static_cast<std::uint32_t>(zeros + fraction_bits + 1)));
  if (is_negative) {
    low = 0 - low;
    high = -high - (low != 0 ? 1 : 0);
  }
  low = low >> fraction_bits | static_cast<std::uint64_t>(high) << 1 << (63 - fraction_bits);
  const std::int64_t place = (high >> fraction_bits) + fraction_bits;
  if (place > 34) return std::int64_t{1} << 35;
  if (place < -2) return 0;
  const int bits = 61 - static_cast<int>(place);
  const auto power = static_cast<std::int64_t>(power_of(low) >> 2);
  // As detail::power_within() allows: a quarter of the error of the exponent, which is below 79 |y|
  // + 1. For |y| from 2^26 on, only powers of 1 come here, and every error decides them.
  const std::uint32_t whole = fraction_bits < 32 ? n >> fraction_bits : 0;
  const auto error = static_cast<std::int32_t>(20 * whole + 27);
  const std::int64_t ulps = nearest_or_undecided_within(power, error, bits);
  if (ulps != undecided) return ulps;
  const std::int64_t below = power >> bits;
  bool is_up = ties != rounding::floor;
  if (!is_tie(raw, n, is_negative, fraction_bits)) {
    is_up = is_above(raw, n, is_negative, fraction_bits, static_cast<std::uint64_t>(2 * below + 1));
  } else if (ties == rounding::half_even) {
    is_up = below % 2 != 0;
  }
  return below + (is_up ? 1 : 0);
}

// Constant expressions compute in words; variant.hpp has the reasons.

template <class Bits>
constexpr std::int64_t nearest_cube_root(std::uint64_t raw, Bits fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated()) return detail::nearest_cube_root(raw, fraction_bits);
  if constexpr (has_at_most<Bits, most_root_bits>) return cube_root_ulps(raw, fraction_bits);
  return in_digits::cube_root_ulps(raw, fraction_bits);
}

template <rounding Rounding, class Bits>
constexpr std::int64_t nearest_reciprocal_root(std::uint64_t raw, Bits fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated())
    return detail::nearest_reciprocal_root<Rounding>(raw, fraction_bits);
  if constexpr (has_at_most<Bits, most_root_bits>) {
    return reciprocal_root_ulps(raw, fraction_bits, Rounding);
  }
  return in_digits::reciprocal_root_ulps(raw, fraction_bits, Rounding);
}

template <rounding Rounding>
constexpr std::int64_t nearest_real_power(std::uint64_t raw, std::int64_t exponent,
                                          int fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated()) {
    return detail::nearest_real_power<Rounding>(raw, exponent, fraction_bits);
  }
  return real_power_ulps(static_cast<std::uint32_t>(raw), exponent, fraction_bits, Rounding);
}

}  // namespace fixproof::detail::in_compact_words

/// @file
/// Roots, computed in compact words of at most 32 bits. Each is the nearest integer of ulps.
///
/// Exact integers decide. Formats of more than 16 fraction bits need more than 64 bits, and compute
/// in digits, as powers do.
#pragma once

#include <cstdint>

#include "fixed/detail/assert.hpp"
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

using in_digits::nearest_real_power;

}  // namespace fixproof::detail::in_compact_words

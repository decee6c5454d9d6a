/// @file
/// Numbers with 184 bits after the point, for results that 64 bits cannot round.
#pragma once

#include <cstdint>

#include "fixed/detail/assert.hpp"
#include "fixed/detail/function_tables.hpp"
#include "fixed/detail/gpu.hpp"
#include "fixed/detail/wide_integer.hpp"

namespace fixproof::detail {

/// A number in units of 2^-184.
using real = wide_integer<6>;
inline constexpr int real_bits = 184;
FIXED_CONSTANT real real_one = real{1} << real_bits;

constexpr real real_from(const real_words& words) noexcept {
  return (real{words[2]} << 128) + (real{words[1]} << 64) + real{words[0]};
}

/// a * b, rounded down. @pre |a * b| < 2^15
constexpr real product(const real& a, const real& b) noexcept { return (a * b) >> real_bits; }

/// x / n, rounded down. @pre x >= 0, n > 0
constexpr real quotient(const real& x, std::uint32_t n) noexcept {
  real result;
  std::uint64_t rest = 0;
  for (int half = 11; half >= 0; --half) {
    const auto digit = static_cast<std::uint64_t>(x >> 32 * half) & 0xffffffff;
    const std::uint64_t part = rest << 32 | digit;
    result = (result << 32) + real{part / n};
    rest = part % n;
  }
  return result;
}

/// a / b, rounded down. @pre 0 <= a < 2^15, b > 0
constexpr real ratio(const real& a, const real& b) noexcept {
  return real::divide(a << real_bits, b).quotient;
}

/// The integer nearest to x * 2^fraction_bits. @pre that is from -2^63 to 2^63 - 1, and x is so far
/// from a tie that its error does not matter
constexpr std::int64_t nearest_units(const real& x, int fraction_bits) noexcept {
  const real units = (x + (real_one >> (fraction_bits + 1))) >> (real_bits - fraction_bits);
  FIXED_ASSERT(real{static_cast<std::int64_t>(units)} == units);
  return static_cast<std::int64_t>(units);
}

}  // namespace fixproof::detail

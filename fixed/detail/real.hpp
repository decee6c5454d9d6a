/// \file
/// Numbers with 120 bits after the point, for results that 64 bits cannot round.
#pragma once

#include <cstdint>

#include "fixed/detail/function_tables.hpp"
#include "fixed/detail/wide_integer.hpp"

namespace fixproof::detail {

/// A number in units of 2^-120.
using real = wide_integer<4>;
inline constexpr int real_bits = 120;
inline constexpr real real_one = real{1} << real_bits;

constexpr real real_from(const real_words& words) noexcept {
  return (real{words.high} << 64) + real{words.low};
}

/// a * b, rounded down. \pre |a * b| < 2^15
constexpr real product(const real& a, const real& b) noexcept { return (a * b) >> real_bits; }

/// x / n, rounded down. \pre x >= 0, n > 0
constexpr real quotient(const real& x, std::uint32_t n) noexcept {
  real result;
  std::uint64_t rest = 0;
  for (int half = 7; half >= 0; --half) {
    const auto digit = static_cast<std::uint64_t>(x >> 32 * half) & 0xffffffff;
    const std::uint64_t part = rest << 32 | digit;
    result = (result << 32) + real{part / n};
    rest = part % n;
  }
  return result;
}

}  // namespace fixproof::detail

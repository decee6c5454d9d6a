/// @file
/// A cosine with an error below 2^-56, in integers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fixed/detail/gpu.hpp"
#include "fixed/detail/series.hpp"
#include "fixed/detail/wide_integer.hpp"

namespace fixproof::detail {

/// pi/2 in units of 2^-62, to nearest.
FIXED_CONSTANT std::uint64_t half_pi = 0x6487ed5110b4611a;

/// Coefficient n is 4^n / (2n)! in units of 2^-62, for n from 1. Each is less than 3 units too low.
FIXED_CONSTANT std::array<std::uint64_t, 12> cosine_coefficients = [] {
  std::array<std::uint64_t, 12> all{};
  std::uint64_t coefficient = std::uint64_t{1} << 62;
  for (std::size_t n = 1; n <= all.size(); ++n) {
    const std::uint64_t divisor = n * (2 * n - 1);  // 4 / ((2n - 1) 2n) is 2 / divisor
    coefficient = coefficient / divisor * 2 + coefficient % divisor * 2 / divisor;
    all[n - 1] = coefficient;
  }
  return all;
}();

/// The cosine of an angle from 0 to pi/2, both in units of 2^-62. The error is below 2^-56 even if
/// the angle is 4 units off.
///
/// Horner's form of the Taylor series, 1 - u (c1 - u (c2 - ...)) for u = x^2/4 < 0.62. Twelve terms
/// leave a remainder below 2^-70. Each step loses less than 4 units, which the next one multiplies
/// by u, so the sum loses less than 11; u is 1/4 too low, which adds 1/2, and an angle 4 units off
/// adds 4.
constexpr std::int64_t cosine(std::uint64_t angle) noexcept {
  const std::uint64_t u = multiply_high(angle << 1, angle << 1);  // in units of 2^-64
  const std::uint64_t sum =
      sum_of_alternating_series<cosine_coefficients.size()>(cosine_coefficients, u);
  return (std::int64_t{1} << 62) - static_cast<std::int64_t>(multiply_high(u, sum));
}

}  // namespace fixproof::detail

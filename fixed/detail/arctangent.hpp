/// \file
/// The angle of a vector of words of at most 32 bits, to the nearest integer of ulps.
///
/// An angle is first computed in 64 bits with a bound of its error. If the bound allows two
/// integers, it is computed again with an error below 2^-110. There are no ties: by Lindemann's
/// theorem the tangent of a rational angle other than zero is not rational, nor is pi.
#pragma once

#include <cstddef>
#include <cstdint>

#include "fixed/detail/cosine.hpp"
#include "fixed/detail/function_tables.hpp"
#include "fixed/detail/real.hpp"

namespace fixproof::detail {

/// The arctangent of n / d in units of 2^-58, for 0 <= n <= d <= 2^32, d > 0. The error is below 6
/// units.
///
/// Let c = i/32 be nearest to n / d. Then atan(n/d) = atan(c) + atan(z) with z = (32 n - i d) / (32
/// d
/// + i n), exactly, and |z| <= 2^-6. z is rounded down to 2^-58, in two steps because a quotient
/// has 32 bits or less; the series of atan(z) / z loses less than 2 units, and its remainder is
/// below 2^-63.
constexpr std::int64_t arctangent(std::uint64_t n, std::uint64_t d) noexcept {
  const std::uint64_t i = (64 * n / d + 1) / 2;
  const bool is_below = 32 * n < i * d;
  const std::uint64_t numerator = is_below ? i * d - 32 * n : 32 * n - i * d;
  const std::uint64_t denominator = 32 * d + i * n;
  const std::uint64_t high = (numerator << 32) / denominator;
  const std::uint64_t rest = (numerator << 32) % denominator;
  const std::uint64_t z = (high << 26) + (rest << 26) / denominator;
  const std::uint64_t square = multiply_high(z << 11, z << 11);  // 1024 z^2 in units of 2^-64
  std::uint64_t sum = arctangent_coefficients.back();
  for (std::size_t k = arctangent_coefficients.size() - 1; k-- > 0;) {
    sum = arctangent_coefficients[k] - multiply_high(square, sum);
  }
  const auto angle = static_cast<std::int64_t>(z - multiply_high(z, multiply_high(square, sum)));
  const auto middle = static_cast<std::int64_t>(arctangents[i]);
  return is_below ? middle - angle : middle + angle;
}

/// The arctangent of n / d for 0 <= n <= d <= 2^32, d > 0.
///
/// Above tan(pi/8), atan(n/d) = pi/4 - atan((d - n) / (d + n)). Below it, Euler's series has terms
/// that fall by a factor of 6.8; those after the 44th are below 2^-120.
constexpr real precise_arctangent(std::uint64_t n, std::uint64_t d) noexcept {
  const bool is_high = 5 * n > 2 * d;
  const real a{is_high ? d - n : n};
  const real b{is_high ? d + n : d};
  const real squares = a * a + b * b;
  const real ratio = real::divide(a * a << real_bits, squares).quotient;
  real sum = real_one;
  for (std::uint32_t k = 44; k > 0; --k) {
    sum = real_one + quotient(product(ratio, sum) * real{2 * k}, 2 * k + 1);
  }
  const real angle = product(real::divide(a * b << real_bits, squares).quotient, sum);
  return is_high ? (real_from(real_pi) >> 2) - angle : angle;
}

/// The angle of the vector (x, y) in units of 2^-FractionBits, from -pi to pi, rounded to nearest;
/// 0 for the vector 0. \pre |x|, |y| <= 2^32
template <int FractionBits>
constexpr std::int64_t nearest_angle(std::int64_t y, std::int64_t x) noexcept {
  const auto height = static_cast<std::uint64_t>(y < 0 ? -y : y);
  const auto width = static_cast<std::uint64_t>(x < 0 ? -x : x);
  if (height == 0 && x >= 0) return 0;
  const bool is_steep = height > width;
  const std::uint64_t n = is_steep ? width : height;
  const std::uint64_t d = is_steep ? height : width;
  const auto turned = [&](auto angle, auto pi) {
    if (is_steep) angle = (pi >> 1) - angle;
    return x < 0 ? pi - angle : angle;
  };
  const std::int64_t angle = turned(arctangent(n, d), static_cast<std::int64_t>(pi_58));
  constexpr std::int64_t error = 8;
  constexpr int dropped = 58 - FractionBits;
  constexpr std::int64_t half = std::int64_t{1} << (dropped - 1);
  std::int64_t result = (angle - error + half) >> dropped;
  if (result != (angle + error + half) >> dropped) {
    const real precise = turned(precise_arctangent(n, d), real_from(real_pi));
    result = static_cast<std::int64_t>((precise + (real_one >> (FractionBits + 1))) >>
                                       (real_bits - FractionBits));
  }
  return y < 0 ? -result : result;
}

}  // namespace fixproof::detail

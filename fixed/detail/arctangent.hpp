/// @file
/// The angle of a vector of words of at most 32 bits, to the nearest integer of ulps.
///
/// The code first computes an angle in 64 bits, with a bound of its error. If the bound allows two
/// integers, it computes the angle again with an error below 2^-170. There are no ties: by
/// Lindemann's theorem the tangent of a rational angle other than zero is not rational, nor is pi.
#pragma once

#include <cstdint>

#include "fixed/detail/assert.hpp"
#include "fixed/detail/choose.hpp"
#include "fixed/detail/function_tables.hpp"
#include "fixed/detail/nearest.hpp"
#include "fixed/detail/real.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/series.hpp"
#include "fixed/detail/wide_integer.hpp"

namespace fixproof::detail {

/// n / d in units of 2^-58, rounded down, for 0 <= n <= d / 64 and d < 2^64.
constexpr std::uint64_t small_ratio(std::uint64_t n, std::uint64_t d) noexcept {
  FIXED_ASSERT(n <= d / 64);  // so the quotient is at most 2^52
  if (d >> 38 != 0) {
    return static_cast<std::uint64_t>(truncated_ratio(int128{n} << 58, int128{d}));
  }
  // In two steps, because a quotient has 32 bits or less: faster than 128 bits.
  const std::uint64_t high = (n << 32) / d;
  const std::uint64_t rest = (n << 32) % d;
  return (high << 26) + (rest << 26) / d;
}

/// The arctangent of n / d in units of 2^-58, for 0 <= n <= d, d > 0 and n + d < 2^58. The error is
/// below 6 units.
///
/// Let c = i/64 be n / d rounded down. Then atan(n/d) = atan(c) + atan(z), exactly, with
/// z = (64 n - i d) / (64 d + i n) and 0 <= z < 2^-6. z is rounded down to 2^-58; the series of
/// atan(z) / z loses less than 2 units, and its remainder is below 2^-63.
constexpr std::int64_t arctangent(std::uint64_t n, std::uint64_t d) noexcept {
  FIXED_ASSERT(n <= d && d > 0 && (n + d) >> 58 == 0);
  const auto i = static_cast<std::uint32_t>(64 * n / d);  // at most 64
  const std::uint64_t z = small_ratio(64 * n - i * d, 64 * d + i * n);
  const std::uint64_t square = multiply_high(z << 11, z << 11);  // 1024 z^2 in units of 2^-64
  const std::uint64_t sum =
      sum_of_alternating_series<arctangent_coefficients.size()>(arctangent_coefficients, square);
  const std::uint64_t angle = z - multiply_high(z, multiply_high(square, sum));
  return static_cast<std::int64_t>(arctangents[i] + angle);
}

/// The arctangent of n / d in units of 2^-32, for 0 <= n <= d <= 2^32, d > 0. The error is below 3
/// units.
///
/// Like arctangent(), but with one division fewer and only one term of the series, z^3 / 3. The
/// next one, z^5 / 5, is below 2^-32.3. z is less than 1 unit too low, z^3 / 3 less than 1.01
/// units, and the arctangent of c less than 1.
constexpr std::int64_t quick_arctangent(std::uint64_t n, std::uint64_t d) noexcept {
  FIXED_ASSERT(n <= d && d > 0 && d <= std::uint64_t{1} << 32);
  const auto i = static_cast<std::uint32_t>(64 * n / d);  // at most 64
  const std::uint64_t z = ((64 * n - i * d) << 32) / (64 * d + i * n);
  const std::uint64_t square = z * z >> 32;
  return static_cast<std::int64_t>((arctangents[i] >> 26) + z - (square * z / 3 >> 32));
}

/// The arctangent of x for 0 <= x <= 1.
///
/// Above 2/5, atan(x) = pi/4 - atan((1 - x) / (1 + x)). Up to 3/7, Euler's series has terms that
/// fall by a factor of 6.4; those after the 70th are below 2^-185.
constexpr real precise_arctangent(const real& x) noexcept {
  const bool is_high = (real_one << 1) < x * real{5};
  const real a = is_high ? ratio(real_one - x, real_one + x) : x;
  const real squares = real_one + product(a, a);
  const real part = real_one - ratio(real_one, squares);
  real sum = real_one;
  for (std::uint32_t k = 70; k > 0; --k) {
    sum = real_one + quotient(product(part, sum) * real{2 * k}, 2 * k + 1);
  }
  const real angle = product(ratio(a, squares), sum);
  return is_high ? (real_from(real_pi) >> 2) - angle : angle;
}

/// A vector in one of eight parts of the plane, by its magnitudes n <= d.
template <class Length>
struct octant {
  Length n;
  Length d;
  bool is_steep;
  bool is_left;

  /// The angle of the vector, from 0 to pi, from that of (d, n).
  template <class Angle>
  [[nodiscard]] constexpr Angle turned(Angle angle, const Angle& pi) const noexcept {
    angle = chosen(is_steep, (pi >> 1) - angle, angle);
    return chosen(is_left, pi - angle, angle);
  }
};

/// The octant of (width, height), both not negative, or of (-width, height).
template <class Length>
constexpr octant<Length> octant_of(const Length& height, const Length& width,
                                   bool is_left) noexcept {
  const bool is_steep = width < height;
  return {chosen(is_steep, width, height), chosen(is_steep, height, width), is_steep, is_left};
}

/// The ends of the angle of a vector in units of 2^-fraction_bits, by quick_arctangent().
///
/// Pi and its half are less than 1 unit of 2^-32 too low, the arctangent is 3 off, and the vector
/// moves the angle by less than `more`.
constexpr nearest_ends quick_angle_within(const octant<std::uint64_t>& part, int fraction_bits,
                                          std::int64_t more) noexcept {
  const std::int64_t quick =
      part.turned(quick_arctangent(part.n, part.d), static_cast<std::int64_t>(pi_58 >> 26));
  constexpr std::int64_t quick_error = 6;
  return nearest_within(quick, quick_error + more, 32 - fraction_bits);
}

/// The angle of a vector in units of 2^-fraction_bits, from 0 to pi, rounded to nearest.
constexpr std::int64_t careful_angle(const octant<std::uint64_t>& part,
                                     int fraction_bits) noexcept {
  const std::int64_t angle =
      part.turned(arctangent(part.n, part.d), static_cast<std::int64_t>(pi_58));
  constexpr std::int64_t error = 8;
  const nearest_ends ends = nearest_within(angle, error, 58 - fraction_bits);
  if (ends.agree()) [[likely]]
    return ends.low;
  const real precise = precise_arctangent(ratio(real{part.n}, real{part.d}));
  return nearest_units(part.turned(precise, real_from(real_pi)), fraction_bits);
}

/// The angle of the vector (x, y) in units of 2^-fraction_bits, from -pi to pi, rounded to nearest;
/// 0 for the vector 0. @pre |x|, |y| <= 2^32
constexpr std::int64_t nearest_angle(std::int64_t y, std::int64_t x, int fraction_bits) noexcept {
  if (y == 0 && x >= 0) return 0;
  const auto part = octant_of(static_cast<std::uint64_t>(chosen(y < 0, -y, y)),
                              static_cast<std::uint64_t>(chosen(x < 0, -x, x)), x < 0);
  if (fraction_bits <= quick_bits) {
    // In 16.16, this decides all but about one operand in 5,000.
    const nearest_ends quick = quick_angle_within(part, fraction_bits, 0);
    if (quick.agree()) [[likely]]
      return chosen(y < 0, -quick.low, quick.low);
  }
  const std::int64_t angle = careful_angle(part, fraction_bits);
  return y < 0 ? -angle : angle;
}

}  // namespace fixproof::detail

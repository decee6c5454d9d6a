/// @file
/// Angles of vectors and triangles, computed in compact words of at most 32 bits. Each is the
/// nearest integer of ulps.
///
/// The steps and the bounds of angles of vectors are those of arctangent.hpp without its quick try.
/// Those of triangles have a table of their own, which takes no division.
#pragma once

#include <cstddef>
#include <cstdint>

#include "fixed/detail/arcsine.hpp"
#include "fixed/detail/arctangent.hpp"
#include "fixed/detail/assert.hpp"
#include "fixed/detail/compact_words.hpp"
#include "fixed/detail/cosine.hpp"
#include "fixed/detail/digit_angle.hpp"
#include "fixed/detail/function_kinds.hpp"
#include "fixed/detail/function_tables.hpp"

namespace fixproof::detail::in_compact_words {

/// An angle: high / 2^58 + low / 2^90.
struct long_angle {
  std::int64_t high;
  std::int64_t low;
};

/// Of results with more fraction bits, digits decide some.
inline constexpr int most_angle_bits = 16;

/// The error of a long_arctangent() in units of 2^-90, and that of an angle of four quarters.
inline constexpr std::int64_t angle_error = 700;

/// The arctangent of n / d for 0 <= n <= d, d > 0 and 64 n^2 + 64 d^2 < 2^63 d. The error is below
/// 666 units of 2^-90.
///
/// As in arctangent(), it is that of i/64 plus that of z, but a ratio of 1 counts as one below:
/// then i is 63 and z is 1/127. So y = 64 z is below 1, and atan(z) = z - z y^2 S / 8192 with S =
/// 2/3 - y^2 (2/5 - ...) / 4096. In units of 2^-90:
/// - z is less than 1 too low, and the table is 1/2 off.
/// - y has 64 bits, so z y^2 S / 8192, which is below 2^-19.58, is up to 85 too low.
/// - y^2 is up to 3 units of 2^-64 too low, its product with S 1 more, and S 1 1/2 units too low or
///   1/2 too high. Together: less than 3 1/2 units too low or 1 1/2 too high. A unit counts 128.
/// - the last product is less than 128 too low.
/// The terms after z^13 are below 2^-93.
constexpr long_angle long_arctangent(std::uint64_t n, std::uint64_t d) noexcept {
  std::uint64_t rest = n;
  const std::uint32_t i = take_quotient(rest, d, 6);
  const std::uint64_t divisor = (d << 6) + i * n;
  rest <<= 6;
  // In units of 2^-58, and the next 32 bits
  const std::uint64_t upper = take_quotient(rest, divisor, 20);
  const std::uint64_t z = upper << 32 | take_quotient(rest, divisor, 32);
  const std::uint32_t z_rest = take_quotient(rest, divisor, 32);
  const std::uint64_t y = z << 12 | z_rest >> 20;
  const std::uint64_t square = high_product(y, y);
  constexpr std::uint64_t two_thirds = 0xaaaaaaaaaaaaaaab;
  const std::uint64_t tail = series_of(long_arctangent_coefficients.data(),
                                       long_arctangent_coefficients.size(), square, true);
  // In units of 2^-83
  const std::uint64_t less = high_product(y, high_product(square, two_thirds - (tail >> 12)));
  return {static_cast<std::int64_t>(arctangents[i] + z - (less >> 25)),
          std::int64_t{arctangent_rests[i]} + std::int64_t{z_rest} -
              static_cast<std::int64_t>(less << 39 >> 32)};
}

/// The angle of a vector, or `undecided`.
constexpr std::int64_t vector_angle_ulps(std::int64_t y, std::int64_t x,
                                         int fraction_bits) noexcept {
  if (y == 0 && x >= 0) return 0;
  const auto height = static_cast<std::uint64_t>(y < 0 ? -y : y);
  const auto width = static_cast<std::uint64_t>(x < 0 ? -x : x);
  const bool is_steep = width < height;
  long_angle angle = long_arctangent(is_steep ? width : height, is_steep ? height : width);
  if (is_steep) {
    angle = {static_cast<std::int64_t>(pi_58 >> 1) - angle.high,
             (std::int64_t{pi_58 & 1} << 31) + (pi_rest >> 1) - angle.low};
  }
  if (x < 0) angle = {static_cast<std::int64_t>(pi_58) - angle.high, pi_rest - angle.low};
  // No vector is nearer to a tie than 2^-80.5 if the result has at most 16 fraction bits; see
  // docs/functions/arctangent.md.
  const std::int64_t error = fraction_bits <= most_angle_bits ? 0 : angle_error;
  const std::int64_t ulps =
      nearest_or_undecided(angle.high + ((angle.low - error) >> 32),
                           angle.high + ((angle.low + error) >> 32), 58 - fraction_bits);
  return y < 0 && ulps != undecided ? -ulps : ulps;
}

/// The smaller acute angle of a right triangle in units of 2^-62, from its sides in units of 2^-58
/// of the hypotenuse. If one side is less than 1.1 units off, the error is below 21 units.
///
/// With i/64 next to the sine, the angle is the table's a_i = asin(i/64) plus asin(z) with z = sine
/// cos a_i - cosine i/64. So |z| is below 1/90, and asin(z) = z + z S with S = z^2/6 + 3 z^4/40 + 5
/// z^6/112. In units of 2^-62:
/// - a side moves z by less than 17.6.
/// - the first product is less than 1 too low, and its table 0.2 off. The second one is less than 1
///   too low. So z is less than 18.8 off, and asin(z) less than 18.81.
/// - S is less than 7 units of 2^-64 off, which count 90 times less. Its product is less than 1 too
///   low, the terms after z^7 are below 0.4, and the table's a_i is 1/2 off.
constexpr std::int64_t arcsine(std::uint64_t sine, std::uint64_t cosine) noexcept {
  const auto i = static_cast<std::uint32_t>((sine + (std::uint64_t{1} << 51)) >> 52);
  FIXED_ASSERT(i < arcsines.size());
  const auto z =
      static_cast<std::int64_t>(high_product(sine << 5, arcsine_cosines[i]) - (cosine * i >> 2));
  const auto magnitude = static_cast<std::uint64_t>(z < 0 ? -z : z);
  const std::uint64_t y = magnitude << 8;  // 64 |z| in units of 2^-64
  const std::uint64_t series = series_of(arcsine_coefficients.data(), arcsine_coefficients.size(),
                                         high_product(y, y), false);
  const auto more = static_cast<std::int64_t>(high_product(magnitude, series));
  return static_cast<std::int64_t>(arcsines[i]) + z + (z < 0 ? -more : more);
}

/// The arcsine or arccosine, or `undecided`. @pre |raw| <= 2^operand_bits <= 2^32
constexpr std::int64_t triangle_angle_ulps(std::int64_t raw, int operand_bits, int fraction_bits,
                                           triangle_side side) noexcept {
  // In units of 2^-32
  const auto known = static_cast<std::uint64_t>(raw < 0 ? -raw : raw) << (32 - operand_bits);
  const std::uint64_t given = known << 26;
  std::uint64_t other = known == 0 ? std::uint64_t{1} << 58 : 0;
  // 1 is 2^64, which is 0 here.
  if (std::uint64_t rest = 0 - known * known; rest != 0) {
    // The root is in units of 2^-63, and of 2^-31 of that of a `rest` from 2^62 on. It is off by
    // less than 2 units: rest / (2 root) is rounded down, and the next term is below a half. So the
    // side is less than 1.1 units off.
    int shift = 63 - 58;
    for (; rest >> 62 == 0; rest <<= 2) ++shift;
    const std::uint64_t root = take_root(rest);
    other = ((root << 31) + take_quotient(rest, 2 * root, 31)) >> shift;
  }
  const bool is_sine = side == triangle_side::sine;
  const bool is_upper = other < given;
  std::int64_t angle = is_upper ? arcsine(other, given) : arcsine(given, other);
  // half_pi is in units of 2^-62, and so is pi in units of 2^-61.
  constexpr auto pi_61 = static_cast<std::int64_t>(half_pi);
  if (is_upper == is_sine) angle = pi_61 - angle;
  angle >>= 1;
  if (!is_sine && raw < 0) angle = pi_61 - angle;
  // In units of 2^-61: less than 10.5 of arcsine(), and 2 of the shift and of pi.
  const std::int64_t ulps = nearest_or_undecided_within(angle, 13, 61 - fraction_bits);
  return is_sine && raw < 0 && ulps != undecided ? -ulps : ulps;
}

// Constant expressions compute in words; variant.hpp has the reasons.

template <class Bits>
constexpr std::int64_t nearest_angle(std::int64_t y, std::int64_t x, Bits fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated()) return detail::nearest_angle(y, x, fraction_bits);
  return decided<has_at_most<Bits, most_angle_bits>>(vector_angle_ulps(y, x, fraction_bits), [&] {
    return in_digits::vector_angle_ulps(y, x, fraction_bits);
  });
}

template <triangle_side Side, class Bits>
constexpr std::int64_t nearest_triangle_angle(std::int64_t raw, int operand_bits,
                                              Bits fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated()) {
    return detail::nearest_triangle_angle<Side>(raw, operand_bits, fraction_bits);
  }
  return decided<is_tried<Bits>>(triangle_angle_ulps(raw, operand_bits, fraction_bits, Side), [&] {
    return in_digits::triangle_angle_ulps(raw, operand_bits, fraction_bits, Side);
  });
}

}  // namespace fixproof::detail::in_compact_words

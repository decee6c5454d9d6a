/// @file
/// Angles of vectors and triangles, computed in compact words of at most 32 bits. Each is the
/// nearest integer of ulps.
///
/// The steps and the bounds are those of arctangent.hpp and arcsine.hpp without their quick tries.
#pragma once

#include <cstddef>
#include <cstdint>

#include "fixed/detail/arcsine.hpp"
#include "fixed/detail/arctangent.hpp"
#include "fixed/detail/assert.hpp"
#include "fixed/detail/compact_words.hpp"
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

/// The angle of (width, height), or of (-width, height), from 0 to pi, or `undecided`.
constexpr std::int64_t angle_ulps(std::uint64_t height, std::uint64_t width, bool is_left,
                                  std::int64_t error, int fraction_bits) noexcept {
  const bool is_steep = width < height;
  long_angle angle = long_arctangent(is_steep ? width : height, is_steep ? height : width);
  if (is_steep) {
    angle = {static_cast<std::int64_t>(pi_58 >> 1) - angle.high,
             (std::int64_t{pi_58 & 1} << 31) + (pi_rest >> 1) - angle.low};
  }
  if (is_left) angle = {static_cast<std::int64_t>(pi_58) - angle.high, pi_rest - angle.low};
  return nearest_or_undecided(angle.high + ((angle.low - error) >> 32),
                              angle.high + ((angle.low + error) >> 32), 58 - fraction_bits);
}

constexpr std::int64_t vector_angle_ulps(std::int64_t y, std::int64_t x,
                                         int fraction_bits) noexcept {
  if (y == 0 && x >= 0) return 0;
  // No vector is nearer to a tie than 2^-80.5 if the result has at most 16 fraction bits; see
  // docs/functions/arctangent.md.
  const std::int64_t ulps = angle_ulps(
      static_cast<std::uint64_t>(y < 0 ? -y : y), static_cast<std::uint64_t>(x < 0 ? -x : x), x < 0,
      fraction_bits <= most_angle_bits ? 0 : angle_error, fraction_bits);
  return y < 0 && ulps != undecided ? -ulps : ulps;
}

/// The arcsine or arccosine. @pre |raw| <= 2^operand_bits <= 2^32
constexpr std::int64_t triangle_angle_ulps(std::int64_t raw, int operand_bits, int fraction_bits,
                                           triangle_side side) noexcept {
  const auto known = static_cast<std::uint64_t>(raw < 0 ? -raw : raw);
  std::uint64_t given = 0;
  std::uint64_t other = 0;
  if (known == 0 || known >> operand_bits != 0) {
    (known == 0 ? other : given) = 1;
  } else {
    // Both sides in units of 2^-56 of the hypotenuse. The root is in units of 2^-31 of that of
    // `rest`, which is at least 2^62, and is off by less than 2 units: rest / (2 root) is rounded
    // down, and the next term is below a half. So the other side is off by less than 1.1 units,
    // and moves the angle by at most as much.
    constexpr int bits = 56;
    std::uint64_t rest = 0 - known * known;
    if (operand_bits < 32) rest += std::uint64_t{1} << (2 * operand_bits);
    int shift = 31 + operand_bits - bits;
    for (; rest >> 62 == 0; rest <<= 2) ++shift;
    const std::uint64_t root = take_root(rest);
    other = ((root << 31) + take_quotient(rest, 2 * root, 31)) >> shift;
    given = known << (bits - operand_bits);
  }
  constexpr std::int64_t error = std::int64_t{5} << 32;
  const bool is_sine = side == triangle_side::sine;
  const std::int64_t ulps = angle_ulps(is_sine ? given : other, is_sine ? other : given,
                                       !is_sine && raw < 0, error, fraction_bits);
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

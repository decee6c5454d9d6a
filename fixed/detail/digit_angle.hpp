/// @file
/// Angles of vectors and triangles, computed in digits for words of at most 32 bits. Each is the
/// nearest integer of ulps, as in arctangent.hpp and arcsine.hpp, without a first try in words.
#pragma once

#include <cstdint>

#include "fixed/detail/arcsine.hpp"
#include "fixed/detail/arctangent.hpp"
#include "fixed/detail/digit_series.hpp"
#include "fixed/detail/function_kinds.hpp"

namespace fixproof::detail::in_digits {

/// The angle of (width, height), or of (-width, height), from 0 to pi. Overwrites both.
/// @pre neither is negative, and at least one is not 0
constexpr std::int64_t angle_ulps(real& height, real& width, bool is_left,
                                  int fraction_bits) noexcept {
  real difference = width;
  difference -= height;
  const bool is_steep = difference.negative();
  if (is_steep) {
    difference = width;
    width = height;
    height = difference;
  }
  height /= width;
  take_arctangent(height);
  if (is_steep) {
    height.negate();
    height += half_pi;
  }
  if (is_left) {
    height.negate();
    height += pi;
  }
  return nearest_units(height, fraction_bits);
}

/// The angle of the vector (x, y), from -pi to pi; 0 for the vector 0. @pre |x|, |y| <= 2^32
constexpr std::int64_t vector_angle_ulps(std::int64_t y, std::int64_t x,
                                         int fraction_bits) noexcept {
  if (y == 0 && x >= 0) return 0;
  for (int lowest = short_digit;; lowest = 0) {
    real height = scaled_integer(y < 0 ? -y : y, real_bits - 32, lowest);
    real width = scaled_integer(x < 0 ? -x : x, real_bits - 32, lowest);
    const std::int64_t ulps = angle_ulps(height, width, x < 0, fraction_bits);
    if (ulps != undecided) return y < 0 ? -ulps : ulps;
  }
}

constexpr std::int64_t triangle_angle_ulps(std::int64_t raw, int operand_bits, int fraction_bits,
                                           triangle_side side) noexcept {
  const std::int64_t known = raw < 0 ? -raw : raw;
  // 4^operand_bits - known^2 in units of 2^-64; 4^32 is 0 modulo 2^64, which is right unless the
  // operand is 0.
  const auto square = static_cast<std::uint64_t>(known) * static_cast<std::uint64_t>(known);
  const int unused = 32 - operand_bits;
  for (int lowest = short_digit;; lowest = 0) {
    real other = known == 0 ? real_one : root_of(0 - (square << unused << unused), lowest);
    other.use_from(lowest);
    real given = scaled_integer(known, real_bits - operand_bits, lowest);
    const bool is_sine = side == triangle_side::sine;
    const std::int64_t ulps = is_sine ? angle_ulps(given, other, false, fraction_bits)
                                      : angle_ulps(other, given, raw < 0, fraction_bits);
    if (ulps != undecided) return is_sine && raw < 0 ? -ulps : ulps;
  }
}

// Constant expressions compute in words; variant.hpp has the reasons.

constexpr std::int64_t nearest_angle(std::int64_t y, std::int64_t x, int fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated()) return detail::nearest_angle(y, x, fraction_bits);
  return vector_angle_ulps(y, x, fraction_bits);
}

/// The arcsine or arccosine of raw / 2^operand_bits.
/// @pre |raw| <= 2^operand_bits <= 2^32
template <triangle_side Side>
constexpr std::int64_t nearest_triangle_angle(std::int64_t raw, int operand_bits,
                                              int fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated()) {
    return detail::nearest_triangle_angle<Side>(raw, operand_bits, fraction_bits);
  }
  return triangle_angle_ulps(raw, operand_bits, fraction_bits, Side);
}

}  // namespace fixproof::detail::in_digits

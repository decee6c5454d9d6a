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

/// The angle of (width, height), or of (-width, height), from 0 to pi. @pre as arctangent()
constexpr std::int64_t angle_ulps(std::uint64_t height, std::uint64_t width, bool is_left,
                                  std::int32_t error, int fraction_bits) noexcept {
  const bool is_steep = width < height;
  const std::uint64_t d = is_steep ? height : width;
  std::uint64_t n = is_steep ? width : height;
  std::uint64_t rest = n;
  // As arctangent(), except that a ratio of 1 is 63/64 and a z of 1/127
  const auto i = static_cast<std::uint32_t>(take_quotient(rest, d, 6));
  const std::uint64_t z = take_quotient(rest, 64 * d + i * n, 58);
  const std::uint64_t square = high_product(z << 11, z << 11);
  const std::uint64_t sum =
      series_of(arctangent_coefficients.data(), arctangent_coefficients.size(), square, true);
  auto angle = static_cast<std::int64_t>(arctangents[i] + z - high_product(z, sum));
  if (is_steep) angle = static_cast<std::int64_t>(pi_58 >> 1) - angle;
  if (is_left) angle = static_cast<std::int64_t>(pi_58) - angle;
  return nearest_or_undecided(angle, error, 58 - fraction_bits);
}

constexpr std::int64_t vector_angle_ulps(std::int64_t y, std::int64_t x,
                                         int fraction_bits) noexcept {
  if (y == 0 && x >= 0) return 0;
  const std::int64_t ulps =
      angle_ulps(static_cast<std::uint64_t>(y < 0 ? -y : y),
                 static_cast<std::uint64_t>(x < 0 ? -x : x), x < 0, 8, fraction_bits);
  return y < 0 && ulps != undecided ? -ulps : ulps;
}

// Constant expressions compute in words; variant.hpp has the reasons.

template <class Bits>
constexpr std::int64_t nearest_angle(std::int64_t y, std::int64_t x, Bits fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated()) return detail::nearest_angle(y, x, fraction_bits);
  return decided<Bits>(vector_angle_ulps(y, x, fraction_bits),
                       [&] { return in_digits::vector_angle_ulps(y, x, fraction_bits); });
}

template <triangle_side Side, class Bits>
constexpr std::int64_t nearest_triangle_angle(std::int64_t raw, int operand_bits,
                                              Bits fraction_bits) noexcept {
  return in_digits::nearest_triangle_angle<Side>(raw, operand_bits, fraction_bits);
}

}  // namespace fixproof::detail::in_compact_words

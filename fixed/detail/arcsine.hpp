/// @file
/// Arcsines and arccosines of words of at most 32 bits, each the nearest integer of ulps.
///
/// Both are angles of the vector (cosine, sine), of which one is the operand and the other a square
/// root. There are no ties: by Lindemann's theorem the sine of a rational angle other than zero is
/// not rational.
#pragma once

#include <cstdint>
#include <type_traits>

#include "fixed/detail/arctangent.hpp"
#include "fixed/detail/assert.hpp"
#include "fixed/detail/bits.hpp"
#include "fixed/detail/choose.hpp"
#include "fixed/detail/function_kinds.hpp"
#include "fixed/detail/hardware.hpp"
#include "fixed/detail/nearest.hpp"
#include "fixed/detail/square_root.hpp"

namespace fixproof::detail {

/// The root of n * 4^doublings, a number from 2^62 to 2^64, in units of 2^-31. The error is below 2
/// units. @pre n > 0
///
/// The integer r nearest to the root leaves a rest |n - r^2| <= r. The next term, rest / (2r), is
/// rounded to a unit; the one after it is below an eighth of a unit.
struct scaled_root {
  std::uint64_t root;
  int doublings;
};
constexpr scaled_root root_of(std::uint64_t n) noexcept {
  const int doublings = leading_zeros(n) / 2;
  n <<= 2 * doublings;
  const std::int64_t root = nearest_sqrt_of_word(n);
  const auto square = static_cast<std::uint64_t>(root) * static_cast<std::uint64_t>(root);
  // Modulo 2^64, which is exact, because the rest is at most 2^32.
  const auto rest = static_cast<std::int64_t>(n - square);
  FIXED_ASSERT(rest <= root && -rest <= root);
  const std::int64_t fraction = rest * (std::int64_t{1} << 30) / root;
  return {(static_cast<std::uint64_t>(root) << 31) + static_cast<std::uint64_t>(fraction),
          doublings};
}

/// sqrt(n) in units of 2^-shift, off by less than 1.01 units. @pre 0 < n < 4^(32 - shift), shift >=
/// 16
constexpr std::uint64_t quick_root(std::uint64_t n, int shift) noexcept {
  if constexpr (hardware_double) {
    if (!std::is_constant_evaluated()) {
      // Off by less than 2^-52 of the root in every rounding mode.
      const double root = sqrt(static_cast<double>(static_cast<std::int64_t>(n)));
      const auto scale = static_cast<double>(std::int64_t{1} << shift);
      // At most 2^32.
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(root * scale));
    }
  }
  return static_cast<std::uint64_t>(nearest_sqrt_of_word(n << (2 * shift)));
}

/// sqrt(4^fraction_bits - sine^2), the other side of a triangle, in units of 2^-184 of its
/// hypotenuse. @param squares 4^fraction_bits - sine^2
constexpr real precise_side(std::uint64_t squares, int fraction_bits) noexcept {
  return nearest_sqrt_by_pairs<real_bits>(real{squares} << (2 * (real_bits - fraction_bits)));
}

/// The angle of a triangle with the side `known` / 2^operand_bits and the hypotenuse 1, from 0 to
/// pi, to nearest.
/// @param squares 4^operand_bits - known^2 @param is_left whether the known side is negative
template <triangle_side Side>
constexpr std::int64_t careful_triangle_angle(std::uint64_t known, std::uint64_t squares,
                                              bool is_left, int operand_bits,
                                              int fraction_bits) noexcept {
  constexpr bool is_sine = Side == triangle_side::sine;
  // Both sides in units of 2^-57 of the hypotenuse. The root is off by 2 units, and moves the angle
  // by at most as much.
  constexpr int bits = 57;
  // As squares is below 4^operand_bits, doublings + operand_bits is at least 32: a right shift.
  const scaled_root root = root_of(squares);
  FIXED_ASSERT(root.doublings + operand_bits >= 32);
  const std::uint64_t other = root.root >> (31 + root.doublings + operand_bits - bits);
  const std::uint64_t side = known << (bits - operand_bits);
  const auto part = is_sine ? octant_of(side, other, false) : octant_of(other, side, is_left);
  const std::int64_t angle =
      part.turned(arctangent(part.n, part.d), static_cast<std::int64_t>(pi_58));
  constexpr std::int64_t error = 16;
  const nearest_ends ends = nearest_within(angle, error, 58 - fraction_bits);
  if (ends.agree()) [[likely]]
    return ends.low;
  const real precise_other = precise_side(squares, operand_bits);
  const real precise_known = real{known} << (real_bits - operand_bits);
  const auto precise = is_sine ? octant_of(precise_known, precise_other, false)
                               : octant_of(precise_other, precise_known, is_left);
  return nearest_units(
      precise.turned(precise_arctangent(ratio(precise.n, precise.d)), real_from(real_pi)),
      fraction_bits);
}

/// The arcsine or arccosine of raw / 2^operand_bits in units of 2^-fraction_bits.
/// @pre |raw| <= 2^operand_bits <= 2^32
template <triangle_side Side>
constexpr std::int64_t nearest_triangle_angle(std::int64_t raw, int operand_bits,
                                              int fraction_bits) noexcept {
  constexpr bool is_sine = Side == triangle_side::sine;
  const auto known = static_cast<std::uint64_t>(chosen(raw < 0, -raw, raw));
  if (known == 0 || known >> operand_bits != 0) {
    // The other side is 1 or 0.
    const std::int64_t other = known == 0 ? 1 : 0;
    return is_sine ? nearest_angle(raw, other, fraction_bits)
                   : nearest_angle(other, raw, fraction_bits);
  }
  // 4^operand_bits is 0 modulo 2^64 if there are 32.
  const std::uint64_t one = operand_bits < 32 ? std::uint64_t{1} << (2 * operand_bits) : 0;
  const std::uint64_t squares = one - known * known;

  if (operand_bits <= quick_bits && fraction_bits <= quick_bits) {
    // Both sides in units of 2^-32 of the hypotenuse. The root moves the angle by at most its
    // error.
    const int shift = 32 - operand_bits;
    const std::uint64_t other = quick_root(squares, shift);
    const std::uint64_t side = known << shift;
    const auto part = is_sine ? octant_of(side, other, false) : octant_of(other, side, raw < 0);
    const nearest_ends quick = quick_angle_within(part, fraction_bits, 2);
    if (quick.agree()) [[likely]]
      return chosen(is_sine && raw < 0, -quick.low, quick.low);
  }

  const std::int64_t angle =
      careful_triangle_angle<Side>(known, squares, raw < 0, operand_bits, fraction_bits);
  return is_sine && raw < 0 ? -angle : angle;
}

}  // namespace fixproof::detail

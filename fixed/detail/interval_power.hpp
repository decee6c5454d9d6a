/// @file
/// Roots and powers by intervals: an integer of ulps.
#pragma once

#include <cstddef>
#include <cstdint>

#include "fixed/detail/bits.hpp"
#include "fixed/detail/interval.hpp"
#include "fixed/detail/interval_functions.hpp"
#include "fixed/detail/interval_rounding.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/square_root.hpp"
#include "fixed/detail/wide_integer.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// The cube root. No tie: the cube of an odd number of half ulps is no multiple of 1/4. The cube of
/// the nearest one differs by at least 1/8 from that of the root, in ulps, so 320 bits decide.
template <rounding Rounding>
constexpr int128 interval_cube_root(const real_operand& x, int fraction_bits) noexcept {
  if (x.magnitude == 0) return int128{0};
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    return with_sign(power_of_two(binary_logarithm(x.absolute().with(digits)) / 3), x.is_negative);
  });
}

/// 1 / sqrt(x) for x > 0. The square of an odd number of half ulps has the reciprocal x in ulps
/// only if both are powers of two. The product of that square and x differs by at least 1/4 from
/// a power of two otherwise, so 320 bits decide.
template <rounding Rounding>
constexpr int128 interval_reciprocal_root(const real_operand& x, int fraction_bits) noexcept {
  // 1 / sqrt(2^(2 f + 2)) is 2^-(f + 1).
  const int exponent = 2 * fraction_bits + 2 + x.places;
  if (exponent < 64 && x.magnitude == std::uint64_t{1} << exponent) {
    return shift_right<Rounding>(int128{1}, 1);
  }
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval root = sqrt(x.with(digits));
    return whole_like(root, 1) / root;
  });
}

/// The root of a square; 0 if it is none.
constexpr std::uint64_t exact_root(std::uint64_t square) noexcept {
  const auto root = static_cast<std::uint64_t>(nearest_sqrt_of_word(square));
  return root >> 32 == 0 && root * root == square ? root : 0;
}

/// An odd number of half ulps that is a power; 0 if the power is not one, or is above 2^66.
///
/// Let |x| = odd 2^n and y = p / q in lowest terms, where q is a power of two. A rational power has
/// an integer r with r^q = odd, and q divides n. The power is then r^p 2^(n p / q), with an odd
/// r^p, so it is an odd number of half ulps only if n p / q = -(f + 1).
constexpr int128 odd_half_ulps(const real_operand& x, const real_operand& y,
                               int fraction_bits) noexcept {
  if (x.magnitude == 0 || y.magnitude == 0) return int128{0};
  const int twos = trailing_zeros(x.magnitude);
  std::uint64_t root = x.magnitude >> twos;
  int exponent = twos - x.places;
  const int shared = trailing_zeros(y.magnitude);
  for (int q = y.places; q > shared; --q) {
    if (exponent % 2 != 0) return int128{0};
    exponent /= 2;
    root = exact_root(root);
    if (root == 0) return int128{0};
    if (root == 1 && exponent == 0) return int128{0};  // x is 1
  }
  // p is the rest of y, with the twos that q does not take.
  const int more = shared > y.places ? shared - y.places : 0;
  const std::uint64_t odd = y.magnitude >> shared;
  // |exponent| is at most 64, so a p above 65 is far from -(f + 1).
  if (exponent == 0 || more > 6 || odd > 65) return int128{0};
  const int p = static_cast<int>(odd) << more;
  if (p > 65 || (y.is_negative ? -exponent : exponent) * p != -(fraction_bits + 1)) {
    return int128{0};
  }
  if (root == 1) return int128{1};
  if (y.is_negative) return int128{0};
  int128 power{1};
  for (int i = 0; i < p; ++i) {
    if ((power >> 66) != int128{0} || root >> 33 != 0) return p == 1 ? int128{root} : int128{0};
    power = power * int128{root};
  }
  return power;
}

/// x^y for x > 0, or for x < 0 and a whole y.
template <rounding Rounding>
constexpr int128 interval_power(const real_operand& x, const real_operand& y,
                                int fraction_bits) noexcept {
  // An odd whole number: its last bit is in the format.
  const bool is_odd = y.places < 64 && (y.magnitude >> y.places & 1) != 0;
  const bool is_negative = x.is_negative && is_odd;
  if (y.magnitude == 0 || x.is_one()) {
    return with_sign(int128{1} << fraction_bits, is_negative);
  }
  const int128 half_ulps = odd_half_ulps(x, y, fraction_bits);
  if (half_ulps != int128{0}) return shift_right<Rounding>(with_sign(half_ulps, is_negative), 1);
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval exponent = y.with(digits) * binary_logarithm(x.absolute().with(digits));
    // From 2^8 on, the power is at least 2^256 or at most 2^-256.
    const interval power = exponent.exponent() > 8
                               ? whole_like(exponent, 1).scaled(exponent.is_negative() ? -256 : 256)
                               : power_of_two(exponent);
    return with_sign(power, is_negative);
  });
}

}  // namespace fixproof::detail

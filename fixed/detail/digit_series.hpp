/// @file
/// Powers of two, logarithms, arctangents, sines and square roots in digits.
///
/// They take the steps of precise_power(), precise_logarithm(), precise_arctangent(),
/// precise_sine_of() and precise_side(), each rounded alike, so the results are the same to the bit
/// and their bounds hold. Short numbers take fewer terms, and the error of a short number is below
/// 2^-77.
#pragma once

#include <cstdint>
#include <limits>

#include "fixed/detail/assert.hpp"
#include "fixed/detail/digits.hpp"
#include "fixed/detail/function_tables.hpp"
#include "fixed/detail/gpu.hpp"
#include "fixed/detail/nearest.hpp"
#include "fixed/detail/rounding.hpp"

namespace fixproof::detail::in_digits {

/// integer * 2^places units of 2^-184, from digit `lowest` on. @pre those below it are 0
constexpr real scaled_integer(std::int64_t integer, int places, int lowest = 0) noexcept {
  real x(integer);
  x.shift(places);
  x.use_from(lowest);
  return x;
}

FIXED_CONSTANT real real_one = scaled_integer(1, real_bits);
FIXED_CONSTANT real log2_e(real_log2_e);
FIXED_CONSTANT real log_2(real_log_2);
FIXED_CONSTANT real log10_2(real_log10_2);
FIXED_CONSTANT real pi(real_pi);
FIXED_CONSTANT real two_over_pi(real_2_over_pi);

constexpr real half_of(const real& x) noexcept {
  real half = x;
  half.shift(-1);
  return half;
}
FIXED_CONSTANT real half_pi = half_of(pi);

/// 1 in the units of x.
constexpr real one_as(const real& x) noexcept {
  real one = real_one;
  one.use_from(x.lowest());
  return one;
}

/// Says that a short number is too near to a tie.
FIXED_CONSTANT std::int64_t undecided = std::numeric_limits<std::int64_t>::min();

/// The integer nearest to x * 2^fraction_bits, like nearest_units() of real.hpp, but at most 2^35,
/// which is beyond every format; `undecided` if x is short and too near to a tie. Overwrites x.
/// @pre x is not short, or its error is at most 2^-21 of a unit of the result
constexpr std::int64_t nearest_units(real& x, int fraction_bits) noexcept {
  constexpr std::int64_t beyond = std::int64_t{1} << 35;
  constexpr int more_bits = 21;
  // A unit of 2^-21 for the error of x, and one for the shift, which rounds down.
  const std::int64_t error = x.lowest() == 0 ? 0 : 2;
  x.use_from(0);
  x.shift(fraction_bits + more_bits - real_bits);
  real room(beyond << more_bits);
  room -= x;
  if (room.negative()) return beyond;
  // Negative results are sines, and logarithms down to -32.
  FIXED_ASSERT(x.is_word());
  const nearest_ends ends = nearest_within(x.units(), error, more_bits);
  return ends.agree() ? ends.low : undecided;
}

/// 1/2 or -1/2 rounded by `ties`, which is a rule to nearest.
constexpr std::int64_t rounded_half(bool is_negative, rounding ties) noexcept {
  if (ties == rounding::half_even) return 0;
  if (is_negative) return ties == rounding::half_up ? 0 : -1;
  return 1;
}

/// Subtracts the whole part from x, and returns that part, which is at most 2^39 in magnitude. x is
/// then from 0 to 1.
constexpr std::int64_t take_whole(real& x) noexcept {
  real whole = x;
  whole.use_from(0);
  whole.shift(-real_bits);
  FIXED_ASSERT(whole.is_word());
  const std::int64_t units = whole.units();
  whole.shift(real_bits);
  x -= whole;
  return units;
}

/// 2^x for 0 <= x < 1.
constexpr void raise_two(real& x) noexcept {
  x *= log_2;
  real sum = one_as(x);
  for (digit n = x.lowest() == 0 ? 44 : 24; n > 0; --n) {
    sum *= x;
    sum /= n;
    sum += real_one;
  }
  x = sum;
}

/// log2(m / 2^32) for 2^32 <= m < 2^33.
constexpr real logarithm_of(std::int64_t m, int lowest) noexcept {
  constexpr std::int64_t unit = std::int64_t{1} << 32;
  real z = scaled_integer(m - unit, real_bits - 32, lowest);
  z /= scaled_integer(m + unit, real_bits - 32);
  real square = z;
  square *= z;
  real sum = scaled_integer(0, 0, lowest);
  for (digit n = lowest == 0 ? 115 : 55; n > 1; n -= 2) {
    real term = one_as(z);
    term /= n;
    sum += term;
    sum *= square;
  }
  sum += real_one;
  z += z;
  sum *= z;
  sum *= log2_e;
  return sum;
}

/// The arctangent of x for 0 <= x <= 1.
constexpr void take_arctangent(real& x) noexcept {
  real fifth = scaled_integer(2, real_bits, x.lowest());
  for (int i = 0; i < 5; ++i) fifth -= x;
  const bool is_high = fifth.negative();
  if (is_high) {
    real sum = one_as(x);
    sum += x;
    x.negate();
    x += real_one;
    x /= sum;
  }
  real squares = x;
  squares *= x;
  squares += real_one;
  real part = one_as(x);
  part /= squares;
  part.negate();
  part += real_one;
  real sum = one_as(x);
  for (digit k = x.lowest() == 0 ? 140 : 70; k > 0; k -= 2) {
    sum *= part;
    real factor = scaled_integer(k, real_bits, x.lowest());
    factor *= sum;
    sum = factor;
    sum /= static_cast<digit>(k + 1);
    sum += real_one;
  }
  x /= squares;
  x *= sum;
  if (is_high) {
    x.negate();
    x += half_of(half_pi);
  }
}

/// The sine or cosine of an angle from 0 to pi/2.
constexpr void take_sine(real& angle, bool is_cosine) noexcept {
  real square = angle;
  square *= angle;
  real sum = one_as(angle);
  for (digit n = angle.lowest() == 0 ? 56 : 30; n > 0; n -= 2) {
    sum *= square;
    sum /= static_cast<digit>(n * (is_cosine ? n - 1 : n + 1));
    sum.negate();
    sum += real_one;
  }
  if (is_cosine) {
    angle = sum;
  } else {
    angle *= sum;
  }
}

/// sqrt(squares / 2^64) to nearest.
///
/// Takes two bits of squares * 4^(184 - 32) at a time from the top, like nearest_sqrt_by_pairs().
constexpr real root_of(std::uint64_t squares, int lowest) noexcept {
  real root = scaled_integer(0, 0, lowest);
  real rest = root;
  for (int i = lowest * digit_bits; i < real_bits; ++i) {
    rest.add(rest, squares >> 63 != 0 ? 1 : 0);
    squares <<= 1;
    rest.add(rest, squares >> 63 != 0 ? 1 : 0);
    squares <<= 1;
    // rest - (4 root + 1)
    real trial = root;
    trial += trial;
    trial.add(trial, 1);
    rest -= trial;
    const bool fits = !rest.negative();
    if (!fits) rest += trial;
    root.add(root, fits ? 1 : 0);
  }
  // The rest is at most twice the root.
  real over = root;
  over -= rest;
  if (over.negative()) root.add(real(), 1);
  return root;
}

}  // namespace fixproof::detail::in_digits

/// @file
/// Exponentials, logarithms and hyperbolic functions by intervals: an integer of ulps.
#pragma once

#include <cstddef>
#include <cstdint>

#include "fixed/detail/function_kinds.hpp"
#include "fixed/detail/interval.hpp"
#include "fixed/detail/interval_constants.hpp"
#include "fixed/detail/interval_functions.hpp"
#include "fixed/detail/interval_rounding.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/wide_integer.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// From 2^7 on, an exponential is above 2^128 or below 2^-128.
constexpr bool has_far_power(const real_operand& x) noexcept { return x.whole() >= 128; }

template <exponential_base Base>
constexpr interval exponential_interval(const interval& x) noexcept {
  if constexpr (Base == exponential_base::two) {
    return power_of_two(x);
  } else {
    constexpr const real_constant& factor = Base == exponential_base::e ? log2_of_e : log2_of_10;
    return power_of_two(x * interval(x.size(), factor));
  }
}

/// The exponential, less 1 if `less`.
template <exponential_base Base, rounding Rounding>
constexpr int128 interval_exponential(const real_operand& x, bool less,
                                      int fraction_bits) noexcept {
  if (has_far_power(x)) {
    const int128 least = -(int128{less ? 1 : 0} << fraction_bits);
    return x.is_negative ? beside<Rounding>(least, true) : far_ulps;
  }
  // By the theorems of Gelfond and Schneider and of Lindemann, only a whole power of two is a tie.
  if (Base == exponential_base::two && x.is_negative && x.is_whole() &&
      x.whole() == static_cast<std::uint64_t>(fraction_bits) + 1) {
    return shift_right<Rounding>(int128{1}, 1);
  }
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval power = exponential_interval<Base>(x.with(digits));
    return power - whole_like(power, less ? 1 : 0);
  });
}

/// The logarithm of x, or of x + 1 if `more`. @pre that is positive
template <logarithm_base Base, rounding Rounding>
constexpr int128 interval_logarithm(const real_operand& x, bool more, int fraction_bits) noexcept {
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval operand = x.with(digits);
    const interval sum = operand + whole_like(operand, more ? 1 : 0);
    if constexpr (Base == logarithm_base::e) {
      return natural_logarithm(sum);
    } else if constexpr (Base == logarithm_base::two) {
      return binary_logarithm(sum);
    } else {
      return binary_logarithm(sum) * interval(digits, log10_of_2);
    }
  });
}

template <hyperbola Function, rounding Rounding>
constexpr int128 interval_hyperbolic(const real_operand& x, int fraction_bits) noexcept {
  const bool is_odd = Function == hyperbola::sine;
  if (has_far_power(x)) return with_sign(far_ulps, is_odd && x.is_negative);
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval power = exponential_interval<exponential_base::e>(x.with(digits));
    const interval inverse = whole_like(power, 1) / power;
    return (is_odd ? power - inverse : power + inverse).scaled(-1);
  });
}

/// From 64 on, the result is 1 less 2 e^-128.
template <rounding Rounding>
constexpr int128 interval_hyperbolic_tangent(const real_operand& x, int fraction_bits) noexcept {
  if (x.whole() >= 64) {
    return beside<Rounding>(with_sign(int128{1} << fraction_bits, x.is_negative), x.is_negative);
  }
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval power = exponential_interval<exponential_base::e>(x.with(digits).scaled(1));
    const interval one = whole_like(power, 1);
    return (power - one) / (power + one);
  });
}

/// asinh(x) = log(|x| + sqrt(x^2 + 1)) with the sign of x; acosh(x) = log(x + sqrt(x^2 - 1)).
/// @pre x >= 1 for acosh
template <hyperbola Function, rounding Rounding>
constexpr int128 interval_inverse_hyperbolic(const real_operand& x, int fraction_bits) noexcept {
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval operand = x.absolute().with(digits);
    const interval one = whole_like(operand, 1);
    const interval square =
        Function == hyperbola::sine ? operand * operand + one : (operand - one) * (operand + one);
    return with_sign(natural_logarithm(operand + sqrt(square)), x.is_negative);
  });
}

/// atanh(x) = log((1 + x) / (1 - x)) / 2. @pre |x| < 1
template <rounding Rounding>
constexpr int128 interval_inverse_hyperbolic_tangent(const real_operand& x,
                                                     int fraction_bits) noexcept {
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval operand = x.with(digits);
    const interval one = whole_like(operand, 1);
    return natural_logarithm((one + operand) / (one - operand)).scaled(-1);
  });
}

}  // namespace fixproof::detail

/// @file
/// Exponentials, logarithms and hyperbolic functions, computed in digits for words of at most 32
/// bits. Each is the nearest integer of ulps.
///
/// The results are those of exponential.hpp and hyperbolic.hpp, without the first try in words.
/// Where that try decides, its bound has room for the error of the digits. Where it does not
/// decide, the steps are those of the precise parts.
#pragma once

#include <cstdint>

#include "fixed/detail/digit_series.hpp"
#include "fixed/detail/exponential.hpp"
#include "fixed/detail/function_kinds.hpp"
#include "fixed/detail/hyperbolic.hpp"
#include "fixed/detail/rounding.hpp"

namespace fixproof::detail::in_digits {

// The value is below 2^34 units of the result unless that is beyond every format. The error of a
// short number is below 2^-76 of the value, so it is below 2^-42 of a unit.

/// 2^x. Below 2^-200 it is 0, and from 2^37 on it is at least that.
constexpr void take_power(real& x) noexcept {
  const std::int64_t whole = take_whole(x);
  raise_two(x);
  x.shift(static_cast<int>(whole < -200 ? -200 : whole > 37 ? 37 : whole));
}

constexpr std::int64_t exponential_ulps(std::int64_t x, int fraction_bits, exponential_base base,
                                        rounding ties) noexcept {
  if (base == exponential_base::two &&
      x == std::int64_t{-1 - fraction_bits} * (std::int64_t{1} << 32)) {
    return rounded_half(false, ties);
  }
  for (int lowest = short_digit;; lowest = 0) {
    real power = scaled_integer(x, real_bits - 32, lowest);
    if (base == exponential_base::e) power *= log2_e;
    take_power(power);
    const std::int64_t ulps = nearest_units(power, fraction_bits);
    if (ulps != undecided) return ulps;
  }
}

/// log2(raw / 2^fraction_bits). @pre 0 < raw < 2^33
constexpr real logarithm_of(std::uint64_t raw, int fraction_bits, int lowest) noexcept {
  int exponent = 32 - fraction_bits;
  for (; raw >> 32 == 0; raw <<= 1) --exponent;
  real log = logarithm_of(static_cast<std::int64_t>(raw), lowest);
  log += scaled_integer(exponent, real_bits);
  return log;
}

constexpr std::int64_t logarithm_ulps(std::uint64_t raw, int operand_bits, int fraction_bits,
                                      logarithm_base base) noexcept {
  for (int lowest = short_digit;; lowest = 0) {
    real log = logarithm_of(raw, operand_bits, lowest);
    if (base != logarithm_base::two) log *= base == logarithm_base::e ? log_2 : log10_2;
    const std::int64_t ulps = nearest_units(log, fraction_bits);
    if (ulps != undecided) return ulps;
  }
}

/// e^(x / 2^32), limited like take_power().
constexpr real exponential_of(std::int64_t x, int lowest) noexcept {
  real power = scaled_integer(x, real_bits - 32, lowest);
  power *= log2_e;
  take_power(power);
  return power;
}

constexpr std::int64_t hyperbolic_ulps(std::int64_t x, int fraction_bits,
                                       hyperbola function) noexcept {
  for (int lowest = short_digit;; lowest = 0) {
    real sum = exponential_of(-x, lowest);
    if (function == hyperbola::sine) sum.negate();
    sum += exponential_of(x, lowest);
    sum.shift(-1);
    const std::int64_t ulps = nearest_units(sum, fraction_bits);
    if (ulps != undecided) return ulps;
  }
}

/// The result beyond 13 is 1, because 2 e^-26 is below 2^-36.
constexpr std::int64_t hyperbolic_tangent_ulps(std::int64_t x, int fraction_bits) noexcept {
  if (x >= std::int64_t{13} << 32) return std::int64_t{1} << fraction_bits;
  for (int lowest = short_digit;; lowest = 0) {
    real numerator = exponential_of(-2 * x, lowest);
    real denominator = numerator;
    denominator += real_one;
    numerator.negate();
    numerator += real_one;
    numerator /= denominator;
    const std::int64_t ulps = nearest_units(numerator, fraction_bits);
    if (ulps != undecided) return ulps;
  }
}

// Constant expressions compute in words; variant.hpp has the reasons.

template <exponential_base Base, rounding Rounding>
constexpr std::int64_t nearest_exponential(std::int64_t x, int fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated())
    return detail::nearest_exponential<Base, Rounding>(x, fraction_bits);
  return exponential_ulps(x, fraction_bits, Base, Rounding);
}

template <logarithm_base Base>
constexpr std::int64_t nearest_logarithm(std::uint64_t raw, int operand_bits,
                                         int fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated()) {
    return detail::nearest_logarithm<Base>(raw, operand_bits, fraction_bits);
  }
  return logarithm_ulps(raw, operand_bits, fraction_bits, Base);
}

template <hyperbola Function>
constexpr std::int64_t nearest_hyperbolic(std::int64_t x, int fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated())
    return detail::nearest_hyperbolic<Function>(x, fraction_bits);
  return hyperbolic_ulps(x, fraction_bits, Function);
}

constexpr std::int64_t nearest_hyperbolic_tangent(std::int64_t x, int fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated())
    return detail::nearest_hyperbolic_tangent(x, fraction_bits);
  return hyperbolic_tangent_ulps(x, fraction_bits);
}

}  // namespace fixproof::detail::in_digits

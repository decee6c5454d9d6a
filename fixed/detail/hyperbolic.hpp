/// @file
/// Hyperbolic functions of words of at most 32 bits, each the nearest integer of ulps.
///
/// As in exponential.hpp, the code first computes in 64 bits, with a bound of the error. More bits
/// decide where the bound allows two integers. There are no ties: by Lindemann's theorem the
/// functions of a rational number other than zero are transcendental.
#pragma once

#include <cstddef>
#include <cstdint>

#include "fixed/detail/assert.hpp"
#include "fixed/detail/choose.hpp"
#include "fixed/detail/exponential.hpp"
#include "fixed/detail/function_kinds.hpp"
#include "fixed/detail/nearest.hpp"
#include "fixed/detail/real.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/wide_integer.hpp"

namespace fixproof::detail {

/// e^x for |x| < 64.
constexpr real precise_exponential(const real& x) noexcept {
  const real exponent = product(x, real_from(real_log2_e));
  // From -93 to 92.
  const int whole = static_cast<int>(static_cast<std::int64_t>(exponent >> real_bits));
  FIXED_ASSERT(whole >= -93 && real{whole} == exponent >> real_bits && whole <= 92);
  const real power = precise_power(exponent - (real{whole} << real_bits));
  return whole < 0 ? power >> -whole : power << whole;
}

/// e^-y for y = x / 2^32 >= 0, in units of 2^-62. The error is below 10 units, or with
/// quick_power_terms below 2097152.
///
/// power_of_two() is off by 7.5 units, or by 2^21, and the shift by 1. The exponent is off by 2y +
/// 1 units of 2^-64, which adds (2y + 1) e^-y log(2)/4 < 1/4.
template <std::size_t Terms>
constexpr std::int64_t falling_exponential(std::int64_t x) noexcept {
  const binary_exponent exponent = exponent_of<exponential_base::e>(-x);
  const std::int64_t shift = 1 - exponent.whole;
  // The power is below 2^64, and its half below 2^63.
  return static_cast<std::int64_t>(power_of_two<Terms>(exponent.fraction) >> 1 >>
                                   chosen(shift < 64, shift - 1, std::int64_t{63}));
}

/// The ends of sinh or cosh of x / 2^32 in units of 2^-fraction_bits. @param up the exponent of e^x
template <hyperbola Function, std::size_t Terms>
constexpr nearest_ends hyperbolic_within(std::int64_t x, const binary_exponent& up,
                                         int fraction_bits) noexcept {
  // e^x / 2 and e^-x / 2 as parts of 2^whole, in units of 2^-62; the exponent is from 0 to 33
  const auto whole = static_cast<int>(up.whole);
  FIXED_ASSERT(up.whole >= 0 && up.whole < 34 - fraction_bits);
  const auto rising = static_cast<std::int64_t>(power_of_two<Terms>(up.fraction) >> 2);
  const std::int64_t falling = falling_exponential<Terms>(x) >> (whole + 1);
  const std::int64_t value = Function == hyperbola::sine ? rising - falling : rising + falling;
  // `rising` is off by 5, and by 9 more for an error of 49 units in the exponent; `falling` by 6.
  // With quick_power_terms each is off by 2^20 more.
  constexpr std::int64_t error = Terms == quick_power_terms ? 2097200 : 40;
  return nearest_within(value, error, 62 - whole - fraction_bits);
}

/// sinh or cosh of x / 2^32 in units of 2^-fraction_bits; 2^35 for every result that is not below
/// 2^33 units. @pre 0 <= x <= 2^38
template <hyperbola Function>
constexpr std::int64_t nearest_hyperbolic(std::int64_t x, int fraction_bits) noexcept {
  const binary_exponent up = exponent_of<exponential_base::e>(x);
  if (up.whole >= 34 - fraction_bits) return std::int64_t{1} << 35;
  if (fraction_bits <= quick_bits) {
    const auto quick = hyperbolic_within<Function, quick_power_terms>(x, up, fraction_bits);
    if (quick.agree()) [[likely]]
      return quick.low;
  }
  const auto ends = hyperbolic_within<Function, power_terms>(x, up, fraction_bits);
  if (ends.agree()) [[likely]]
    return ends.low;
  const real precise = real{x} << (real_bits - 32);
  const real rising = precise_exponential(precise);
  const real falling = precise_exponential(-precise);
  const real twice = Function == hyperbola::sine ? rising - falling : rising + falling;
  return nearest_units(twice >> 1, fraction_bits);
}

/// tanh of x / 2^32 in units of 2^-fraction_bits. @pre 0 <= x <= 2^38
///
/// It is (1 - t) / (1 + t) for t = e^(-2x).
constexpr std::int64_t nearest_hyperbolic_tangent(std::int64_t x, int fraction_bits) noexcept {
  // From here on, 2t is below 2^-36.
  constexpr std::int64_t flat = std::int64_t{13} << 32;
  if (x >= flat) return std::int64_t{1} << fraction_bits;
  constexpr std::int64_t one = std::int64_t{1} << 62;
  if (fraction_bits <= quick_bits) {
    const auto t = static_cast<std::uint64_t>(falling_exponential<quick_power_terms>(2 * x));
    constexpr auto whole = static_cast<std::uint64_t>(one);
    FIXED_ASSERT(t <= whole);  // so that the quotient is at most 1
    // In units of 2^-32. Rounding the divisor down makes the quotient up to 2 units too high; the
    // rest is off by less than 2.
    const auto quick = static_cast<std::int64_t>(((whole - t) << 1) / ((whole + t) >> 31));
    constexpr std::int64_t quick_error = 4;
    const nearest_ends ends = nearest_within(quick, quick_error, 32 - fraction_bits);
    if (ends.agree()) [[likely]]
      return ends.low;
  }
  const std::int64_t t = falling_exponential<power_terms>(2 * x);
  FIXED_ASSERT(t >= 0 && t <= one);  // so that the quotient is at most 2^62
  const auto value =
      static_cast<std::int64_t>(truncated_ratio(int128{one - t} << 62, int128{one} + int128{t}));
  // The derivative is at least -2, so the error of t counts twice.
  constexpr std::int64_t error = 24;
  const nearest_ends ends = nearest_within(value, error, 62 - fraction_bits);
  if (ends.agree()) [[likely]]
    return ends.low;
  const real precise = precise_exponential(-(real{x} << (real_bits - 31)));
  return nearest_units(ratio(real_one - precise, real_one + precise), fraction_bits);
}

}  // namespace fixproof::detail

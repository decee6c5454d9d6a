/// \file
/// Hyperbolic functions of words of at most 32 bits, each the nearest integer of ulps.
///
/// As in exponential.hpp, 64 bits with a bound of the error come first, and more bits decide where
/// the bound allows two integers. There are no ties: by Lindemann's theorem the functions of a
/// rational number other than zero are transcendental.
#pragma once

#include <cstdint>

#include "fixed/detail/exponential.hpp"
#include "fixed/detail/nearest.hpp"
#include "fixed/detail/real.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/wide_integer.hpp"

namespace fixproof::detail {

/// e^x for |x| < 64.
constexpr real precise_exponential(const real& x) noexcept {
  const real exponent = product(x, real_from(real_log2_e));
  const int whole = static_cast<int>(static_cast<std::int64_t>(exponent >> real_bits));
  const real power = precise_power(exponent - (real{whole} << real_bits));
  return whole < 0 ? power >> -whole : power << whole;
}

/// e^-y for y = x / 2^32 >= 0, in units of 2^-62. The error is below 10 units.
///
/// power_of_two() is off by 7.5 units, and the shift by 1. The exponent is off by 2y + 1 units of
/// 2^-64, which adds (2y + 1) e^-y log(2)/4 < 1/4.
constexpr std::int64_t falling_exponential(std::int64_t x) noexcept {
  const binary_exponent exponent = exponent_of<exponential_base::e>(-x);
  const std::int64_t shift = 1 - exponent.whole;
  return shift < 64 ? static_cast<std::int64_t>(power_of_two<power_terms>(exponent.fraction) >> shift) : 0;
}

enum class hyperbola { sine, cosine };

/// sinh or cosh of x / 2^32 in units of 2^-fraction_bits; 2^35 for every result that is not below
/// 2^33 units. \pre 0 <= x <= 2^38
template <hyperbola Function>
constexpr std::int64_t nearest_hyperbolic(std::int64_t x, int fraction_bits) noexcept {
  constexpr bool is_sine = Function == hyperbola::sine;
  const binary_exponent exponent = exponent_of<exponential_base::e>(x);
  if (exponent.whole >= 34 - fraction_bits) return std::int64_t{1} << 35;
  // e^x / 2 and e^-x / 2 as parts of 2^whole, in units of 2^-62
  const auto whole = static_cast<int>(exponent.whole);
  const auto rising = static_cast<std::int64_t>(power_of_two<power_terms>(exponent.fraction) >> 2);
  const std::int64_t falling = falling_exponential(x) >> (whole + 1);
  const std::int64_t value = is_sine ? rising - falling : rising + falling;
  // `rising` is off by 5, and by 17 for an error of 49 units in the exponent; `falling` by 6.
  constexpr std::int64_t error = 40;
  const nearest_ends ends = nearest_within(value, error, 62 - whole - fraction_bits);
  if (ends.agree()) return ends.low;
  const real precise = real{x} << (real_bits - 32);
  const real up = precise_exponential(precise);
  const real down = precise_exponential(-precise);
  return nearest_units((is_sine ? up - down : up + down) >> 1, fraction_bits);
}

/// tanh of x / 2^32 in units of 2^-fraction_bits. \pre 0 <= x <= 2^38
///
/// It is (1 - t) / (1 + t) for t = e^(-2x).
constexpr std::int64_t nearest_hyperbolic_tangent(std::int64_t x, int fraction_bits) noexcept {
  // From here on, 2t is below 2^-36.
  constexpr std::int64_t flat = std::int64_t{13} << 32;
  if (x >= flat) return std::int64_t{1} << fraction_bits;
  constexpr std::int64_t one = std::int64_t{1} << 62;
  const std::int64_t t = falling_exponential(2 * x);
  const auto value =
      static_cast<std::int64_t>(truncated_ratio(int128{one - t} << 62, int128{one} + int128{t}));
  // The derivative is at least -2, so the error of t counts twice.
  constexpr std::int64_t error = 24;
  const nearest_ends ends = nearest_within(value, error, 62 - fraction_bits);
  if (ends.agree()) return ends.low;
  const real precise = precise_exponential(-(real{x} << (real_bits - 31)));
  return nearest_units(ratio(real_one - precise, real_one + precise), fraction_bits);
}

}  // namespace fixproof::detail

/// @file
/// Sines, cosines and tangents, computed in digits for angles in words of at most 32 bits. Each is
/// the nearest integer of ulps, as in phase.hpp, without a first try in words.
#pragma once

#include <cstdint>

#include "fixed/detail/digit_series.hpp"
#include "fixed/detail/function_kinds.hpp"
#include "fixed/detail/phase.hpp"
#include "fixed/detail/rounding.hpp"

namespace fixproof::detail::in_digits {

/// An angle as a whole number of quarter turns, and a part of one from 0 to 1. In short numbers the
/// error of the part is below 2^(33 - fraction_bits - 88).
struct phase {
  std::int64_t quarters = 0;
  real part;
};

constexpr phase phase_of(std::int64_t raw, int fraction_bits, angle_unit unit,
                         int lowest) noexcept {
  real angle = scaled_integer(raw < 0 ? -raw : raw, real_bits, lowest);
  if (unit == angle_unit::radian) angle *= two_over_pi;
  angle.shift(unit == angle_unit::turn ? 2 - fraction_bits : -fraction_bits);
  if (unit == angle_unit::degree) angle /= digit{90};
  if (raw < 0) angle.negate();
  const std::int64_t quarters = take_whole(angle);
  return {quarters, angle};
}

/// The sine or cosine of a part of a quarter turn.
constexpr real sine_of(const real& part, bool is_cosine) noexcept {
  real sine = part;
  sine *= half_pi;
  take_sine(sine, is_cosine);
  return sine;
}

/// The lowest digit to begin with. The bounds of short numbers are those of an angle with as many
/// bits after the point as the result, and of one with more.
constexpr int first_digit(int angle_bits, int fraction_bits) noexcept {
  return angle_bits < fraction_bits ? 0 : short_digit;
}

constexpr std::int64_t sine_ulps(std::int64_t raw, unsigned ahead, int angle_bits,
                                 int fraction_bits, angle_unit unit, rounding ties) noexcept {
  for (int lowest = first_digit(angle_bits, fraction_bits);; lowest = 0) {
    const phase angle = phase_of(raw, angle_bits, unit, lowest);
    const std::int64_t quarters = angle.quarters + ahead;
    real result = sine_of(angle.part, quarters % 2 != 0);
    const bool is_negative = (quarters & 2) != 0;
    // A sine of whole degrees that is this near to 1/2 is 1/2.
    real copy = result;
    if (unit == angle_unit::degree && fraction_bits == 0 &&
        raw >> angle_bits << angle_bits == raw && nearest_units(copy, 8) == 128) {
      return rounded_half(is_negative, ties);
    }
    if (is_negative) result.negate();
    const std::int64_t ulps = nearest_units(result, fraction_bits);
    if (ulps != undecided) return ulps;
  }
}

constexpr std::int64_t tangent_ulps(std::int64_t raw, int angle_bits, int fraction_bits,
                                    angle_unit unit) noexcept {
  for (int lowest = first_digit(angle_bits, fraction_bits);; lowest = 0) {
    const phase angle = phase_of(raw, angle_bits, unit, lowest);
    const bool is_steep = angle.quarters % 2 != 0;
    real numerator = sine_of(angle.part, is_steep);
    const real denominator = sine_of(angle.part, !is_steep);
    // The square of the tangent multiplies an error, so short numbers serve only tangents below
    // 2^8. Then the error is below 2^(51 - fraction_bits - 88) + 2^-60.
    real least = numerator;
    least.shift(lowest == 0 ? -34 : -8);
    least -= denominator;
    std::int64_t ulps = lowest == 0 ? std::int64_t{1} << 34 : undecided;
    if (least.negative()) {
      numerator /= denominator;
      ulps = nearest_units(numerator, fraction_bits);
    }
    if (ulps != undecided) return is_steep ? -ulps : ulps;
  }
}

// Constant expressions compute in words; variant.hpp has the reasons.

/// Quarter turns are exact in degrees and turns.
template <angle_unit Unit>
constexpr bool is_pole(std::int64_t raw, int fraction_bits) noexcept {
  if constexpr (Unit == angle_unit::radian) {
    return false;
  } else {
    if (__builtin_is_constant_evaluated()) return detail::is_pole<Unit>(raw, fraction_bits);
    phase angle = phase_of(raw, fraction_bits, Unit, short_digit);
    angle.part.negate();
    return angle.quarters % 2 != 0 && !angle.part.negative();
  }
}

template <angle_unit Unit, rounding Rounding>
constexpr std::int64_t nearest_sine_of(std::int64_t raw, unsigned ahead, int angle_bits,
                                       int fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated()) {
    return detail::nearest_sine_of<Unit, Rounding>(raw, ahead, angle_bits, fraction_bits);
  }
  return sine_ulps(raw, ahead, angle_bits, fraction_bits, Unit, Rounding);
}

template <angle_unit Unit>
constexpr std::int64_t nearest_tangent(std::int64_t raw, int angle_bits,
                                       int fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated()) {
    return detail::nearest_tangent<Unit>(raw, angle_bits, fraction_bits);
  }
  return tangent_ulps(raw, angle_bits, fraction_bits, Unit);
}

}  // namespace fixproof::detail::in_digits

/// @file
/// Sines, cosines and tangents, computed in compact words for angles in words of at most 32 bits.
/// Each is the nearest integer of ulps.
///
/// The steps and the bounds are those of phase.hpp without its quick tries. Only degrees become
/// turns in another way.
#pragma once

#include <array>
#include <cstdint>

#include "fixed/detail/assert.hpp"
#include "fixed/detail/compact_words.hpp"
#include "fixed/detail/cosine.hpp"
#include "fixed/detail/digit_phase.hpp"
#include "fixed/detail/function_kinds.hpp"
#include "fixed/detail/function_tables.hpp"
#include "fixed/detail/gpu.hpp"
#include "fixed/detail/phase.hpp"
#include "fixed/detail/rounding.hpp"

namespace fixproof::detail::in_compact_words {

/// A radian and a degree in units of 2^-128 of a turn, rounded down, the lowest word first. Both
/// are below 2^-2 of a turn.
using turns = std::array<std::uint32_t, 4>;
FIXED_CONSTANT turns turns_of_radian{
    static_cast<std::uint32_t>(turns_low), static_cast<std::uint32_t>(turns_low >> 32),
    static_cast<std::uint32_t>(turns_high), static_cast<std::uint32_t>(turns_high >> 32)};
FIXED_CONSTANT turns turns_of_degree{0x60b60b60, 0x0b60b60b, 0xb60b60b6, 0x00b60b60};

/// An angle in units of 2^-64 of a turn, modulo a turn; rounded toward 0, after an error of `unit`
/// times the angle, which is below 2^-32 units. So the error is at most 1 + 2^-32 units, as that of
/// detail::phase_of().
FIXED_NOINLINE constexpr std::uint64_t phase_of(std::int64_t raw, int fraction_bits,
                                                const turns& unit) noexcept {
  const auto magnitude = static_cast<std::uint32_t>(raw < 0 ? -raw : raw);
  FIXED_ASSERT((raw < 0 ? -raw : raw) == std::int64_t{magnitude});
  // Each word of the product, the lowest first, in units of 2^-(128 + fraction_bits)
  std::uint64_t carry = 0;
  std::uint64_t phase = 0;
  for (const std::uint32_t word : unit) {
    carry += product_of(magnitude, word);
    phase = phase >> 32 | carry << 32;
    carry >>= 32;
  }
  // The upper words are those of 2^-(64 + fraction_bits).
  phase = fraction_bits == 0 ? phase : phase >> fraction_bits | carry << 1 << (63 - fraction_bits);
  return raw < 0 ? 0 - phase : phase;
}

template <angle_unit Unit>
constexpr std::uint64_t phase_of(std::int64_t raw, int fraction_bits) noexcept {
  if constexpr (Unit == angle_unit::turn) {
    return fraction_bits == 0 ? 0 : static_cast<std::uint64_t>(raw) << (64 - fraction_bits);
  } else {
    return phase_of(raw, fraction_bits,
                    Unit == angle_unit::radian ? turns_of_radian : turns_of_degree);
  }
}

/// The sine of a phase. The error is that of nearest_sine_of().
constexpr std::int64_t sine_ulps(std::uint64_t phase, int fraction_bits) noexcept {
  constexpr std::uint64_t quarter = std::uint64_t{1} << 62;
  const std::uint64_t in_half = phase << 1 >> 1;
  const std::uint64_t from_peak = in_half < quarter ? quarter - in_half : in_half - quarter;
  const std::uint64_t angle = high_product(from_peak << 1, half_pi << 1) << 1;
  const std::uint64_t square = high_product(angle, angle);
  const auto magnitude = static_cast<std::int64_t>(
      quarter - series_of(cosine_coefficients.data(), cosine_coefficients.size(), square, true));
  return nearest_or_undecided_within(phase >> 63 == 0 ? magnitude : -magnitude, 64,
                                     62 - fraction_bits);
}

/// Of the phase, tangents take 8 bits more than words have: those of 2^8 times the angle.
inline constexpr int more_phase_bits = 8;

/// The tangent of a phase from 0 on, or `undecided`; 2^34 for every result from 2^33 on.
/// @param fine 2^8 times the phase, modulo 2^64
///
/// As in tangent_of_phase(), the angle is i / 64 of a quarter turn, and z beyond, but z has the 8
/// bits more. In the upper half of a quarter, all bits of the phase become their complements, which
/// takes a unit of 2^-72 of a turn. Numerator and divisor are less than 8 units of 2^-62 off, as in
/// tangent_of_phase(). If the tangent is above 2^6, i is 0, and the divisor is that of z alone, in
/// units of 2^-68: the phase is 1.01 units of z off, z rounds down and has 1/2 more from pi/2, the
/// products lose 4, and the terms after z^9 are below 1. That is less than 9 units of 2^-69, so the
/// quotient is off by less than 9/128 T.
constexpr std::int64_t tangent_ulps(std::uint64_t phase, std::uint64_t fine,
                                    int fraction_bits) noexcept {
  constexpr std::uint64_t one = std::uint64_t{1} << 62;
  constexpr int narrow = 6;
  std::uint64_t part = phase << 2;
  const bool is_odd_quarter = (phase >> 62 & 1) != 0;
  const bool is_upper = part >> 63 != 0;
  if (is_upper) {
    part = ~part;
    fine = ~fine;
  }
  const auto i = static_cast<std::uint32_t>(part >> 58);
  const std::uint64_t z = high_product(fine, half_pi << 1);  // 32 z in units of 2^-64
  const std::uint64_t rest =
      z + high_product(z, series_of(tangent_coefficients.data(), tangent_coefficients.size(),
                                    high_product(z, z), false));
  const std::uint64_t middle = tangents[i];
  std::uint64_t numerator = middle + (rest >> 7);
  std::uint64_t divisor = one - (high_product(middle << 1, rest) >> 6);
  // The tangent is numerator / divisor 2^place, and the quotient is at most 1.
  int place = 0;
  if (is_upper != is_odd_quarter) {
    std::uint64_t steep = numerator;
    if (i == 0) {
      steep = rest >> 1;
      place = narrow;
    }
    numerator = divisor;
    for (divisor = steep; divisor < numerator; divisor <<= 1) {
      // The tangent is above 2^place. Of 16.16, seven tangents above 2^17 would be undecided.
      if (place >= 33 - fraction_bits) {
        return is_odd_quarter ? -(std::int64_t{1} << 34) : std::int64_t{1} << 34;
      }
      ++place;
    }
  }
  const std::uint64_t high = take_quotient(numerator, divisor, 30);
  const auto value = static_cast<std::int64_t>(high << 32 | take_quotient(numerator, divisor, 32));
  // With T = tan and errors below e, the quotient is off by less than e (1 + T) T / 2^place / 0.96,
  // and by a unit that is rounded down. T is at most 2^place.
  const std::int64_t error =
      place > narrow ? 2 + (std::int64_t{5} << place >> 6) : std::int64_t{18} << place;
  return nearest_or_undecided(is_odd_quarter ? -value - error : value - error,
                              is_odd_quarter ? error - value : value + error,
                              62 - place - fraction_bits);
}

// Constant expressions compute in words; variant.hpp has the reasons.

/// A phase is less than 2 units off. The distance of any other angle from a pole is at least
/// 2^-32 / 360 of a turn.
template <angle_unit Unit>
constexpr bool is_pole(std::int64_t raw, int fraction_bits) noexcept {
  if constexpr (Unit == angle_unit::radian) {
    return false;
  } else {
    if (__builtin_is_constant_evaluated()) return detail::is_pole<Unit>(raw, fraction_bits);
    constexpr std::uint64_t near = 8;
    const std::uint64_t in_half = phase_of<Unit>(raw, fraction_bits) << 1;
    return in_half - (std::uint64_t{1} << 63) + near < 2 * near;
  }
}

template <angle_unit Unit, rounding Rounding, class Bits>
constexpr std::int64_t nearest_sine_of(std::int64_t raw, unsigned ahead, int angle_bits,
                                       Bits fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated()) {
    return detail::nearest_sine_of<Unit, Rounding>(raw, ahead, angle_bits, fraction_bits);
  }
  const std::uint64_t phase = phase_of<Unit>(raw, angle_bits) + (std::uint64_t{ahead} << 62);
  return decided<is_tried<Bits>>(sine_ulps(phase, fraction_bits), [&] {
    return in_digits::sine_ulps(raw, ahead, angle_bits, fraction_bits, Unit, Rounding);
  });
}

template <angle_unit Unit, class Bits>
constexpr std::int64_t nearest_tangent(std::int64_t raw, int angle_bits,
                                       Bits fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated()) {
    return detail::nearest_tangent<Unit>(raw, angle_bits, fraction_bits);
  }
  std::int64_t ulps = undecided;
  if (angle_bits >= more_phase_bits) {
    const std::int64_t magnitude = raw < 0 ? -raw : raw;
    ulps = tangent_ulps(phase_of<Unit>(magnitude, angle_bits),
                        phase_of<Unit>(magnitude, angle_bits - more_phase_bits), fraction_bits);
    if (raw < 0 && ulps != undecided) ulps = -ulps;
  }
  return decided < is_tried<Bits> && has_at_least < Bits,
         more_phase_bits >>
             (ulps, [&] { return in_digits::tangent_ulps(raw, angle_bits, fraction_bits, Unit); });
}

}  // namespace fixproof::detail::in_compact_words

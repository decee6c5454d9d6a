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
#include "fixed/detail/phase.hpp"
#include "fixed/detail/rounding.hpp"

namespace fixproof::detail::in_compact_words {

/// A radian and a degree in units of 2^-128 of a turn, rounded down, the lowest word first. Both
/// are below 2^-2 of a turn.
using turns = std::array<std::uint32_t, 4>;
inline constexpr turns turns_of_radian{
    static_cast<std::uint32_t>(turns_low), static_cast<std::uint32_t>(turns_low >> 32),
    static_cast<std::uint32_t>(turns_high), static_cast<std::uint32_t>(turns_high >> 32)};
inline constexpr turns turns_of_degree{0x60b60b60, 0x0b60b60b, 0xb60b60b6, 0x00b60b60};

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
    return detail::phase_of<Unit>(raw, fraction_bits);
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
      quarter -
      series_of(cosine_coefficients.data(), cosine_coefficients.size(), square, true));
  return nearest_or_undecided_within(phase >> 63 == 0 ? magnitude : -magnitude, 64, 62 - fraction_bits);
}

// Constant expressions compute in words; variant.hpp has the reasons.

template <angle_unit Unit>
constexpr bool is_pole(std::int64_t raw, int fraction_bits) noexcept {
  return in_digits::is_pole<Unit>(raw, fraction_bits);
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
  return in_digits::nearest_tangent<Unit>(raw, angle_bits, fraction_bits);
}

}  // namespace fixproof::detail::in_compact_words

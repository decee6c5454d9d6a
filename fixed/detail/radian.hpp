/// @file
/// The number nearest to the sine or cosine of an angle in radians.
///
/// There are no ties: by the Lindemann-Weierstrass theorem the sine and cosine of a nonzero
/// rational angle are transcendental; those of 0 are 0 and 1.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "fixed/detail/cosine.hpp"
#include "fixed/detail/gpu.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// 2^-16 radians in units of 2^-64 of a turn, that is 2^48 / (2 pi), to nearest; then the remainder
/// in units of 2^-96 of a turn. The error of the first alone is at most 2^-38.5 of a turn.
FIXED_CONSTANT std::uint64_t turns_per_unit = 0x28be60db9391;
FIXED_CONSTANT std::int64_t turns_per_unit_rest = 88768266;

FIXED_CONSTANT std::uint64_t quarter_turn = std::uint64_t{1} << 62;
FIXED_CONSTANT std::uint64_t half_turn = std::uint64_t{1} << 63;

/// The error bound of fast_cosine() in units of 2^-62: 2^-29.
FIXED_CONSTANT std::uint64_t fast_cosine_error = std::uint64_t{1} << 33;

/// Coefficients of a minimax polynomial in the square z of d: c0 - z (c1 - z (c2 - ...)). c0 has 62
/// bits after the point, c1 31, the others 32.
FIXED_CONSTANT std::array<std::uint64_t, 6> fast_coefficients{
    0x3fffffff74bfd230, 0x9de9e62b, 0x40f07905, 0x55741d4, 0x3c24de, 0x18fb7};

/// The cosine of d / 2^31 quarter turns in units of 2^-62, modulo 2^64. The error is below 2^-29
/// even if d is 0.53 units off. Multiplies only 32-bit words, as vector units can.
///
/// The polynomial with these coefficients is at most 5.1e-10 too low and 3.6e-10 too high. The
/// error of d adds 0.53 * pi/2^32 < 3.9e-10. Truncation makes the result up to 2^-31 c1 + 2 * 2^-32
/// < 10.5e-10 higher and up to 2^-31 + 2^-32 < 7.0e-10 lower. The total is less than 1.82e-9, and
/// 2^-29 is 1.86e-9.
constexpr std::uint64_t fast_cosine(std::int32_t d) noexcept {
  const auto& c = fast_coefficients;
  const std::uint64_t z = static_cast<std::uint64_t>(std::int64_t{d} * d) >> 31;
  std::uint64_t factor = c[4] - (z * c[5] >> 31);
  factor = c[3] - (z * factor >> 31);
  factor = c[2] - (z * factor >> 31);
  factor = c[1] - (z * factor >> 32);
  return c[0] - z * factor;
}

/// The magnitude of the sine of an angle in units of 2^-16 radians, advanced by `ahead` / 2^64
/// turns, in units of 2^-62. The error is below 2^-56.
constexpr std::uint64_t precise_sine(std::int32_t angle, std::uint64_t ahead) noexcept {
  constexpr std::int64_t half = std::int64_t{1} << 31;
  const std::uint64_t turns =
      static_cast<std::uint64_t>(std::int64_t{angle}) * turns_per_unit +
      static_cast<std::uint64_t>((std::int64_t{angle} * turns_per_unit_rest + half) >> 32) + ahead;
  const std::uint64_t in_half = turns & (half_turn - 1);
  const std::uint64_t from_peak =
      in_half < quarter_turn ? quarter_turn - in_half : in_half - quarter_turn;
  // 2^-64 of a turn is pi/2 units of 2^-62; the error of `from_peak` is below 0.6 of the former.
  return static_cast<std::uint64_t>(cosine(multiply_high(from_peak << 1, half_pi << 1)));
}

/// The rounding of a fast_cosine() to units of 2^-FractionBits.
template <int FractionBits>
struct fast_rounding {
  /// The number of bits that the result drops.
  static constexpr int dropped = 62 - FractionBits;
  /// A half plus the error bound. If the bits `doubtful` of the biased sum are zero, the cosine may
  /// lie on either side of a tie.
  static constexpr std::uint64_t bias = (std::uint64_t{1} << (dropped - 1)) + fast_cosine_error;
  static constexpr std::uint64_t doubtful = (std::uint64_t{1} << dropped) - 2 * fast_cosine_error;
};

/// Added to the turns of an angle to round them to the bits above the lower 31.
FIXED_CONSTANT std::uint64_t turns_bias = std::uint64_t{1} << 30;

/// Whether nearest_sine() covers the format, 8.8 or 16.16, and the rule of its functions.
template <class Raw, int FractionBits, policy Rules>
inline constexpr bool has_radians = Rules.functions == rounding::nearest &&
                                    (FractionBits == 8 || FractionBits == 16) &&
                                    std::is_signed_v<Raw>&& bits_of<Raw> == 2 * FractionBits;

/// The nearest sine of an angle in units of 2^-FractionBits radians, advanced by `ahead` / 2^64
/// turns, in the same units.
///
/// Of all 2^32 sines and 2^32 cosines, the one nearest to a tie is cos(24783.448608...), stored
/// integer 0x60cf72d8: its distance of 2^-48.8 is 140 times the error of precise_sine().
template <int FractionBits>
constexpr std::int32_t nearest_sine(std::int32_t raw, std::uint64_t ahead) noexcept {
  using rounding = fast_rounding<FractionBits>;
  const std::int32_t angle = raw * (1 << (16 - FractionBits));
  const std::uint64_t turns =
      static_cast<std::uint64_t>(std::int64_t{angle}) * turns_per_unit + turns_bias + ahead;
  // The error is 1/2 unit by rounding, and 0.021 by the error of turns_per_unit. The conversion is
  // modulo half a turn.
  const auto from_peak = static_cast<std::int32_t>((turns - quarter_turn) >> 31);
  std::uint64_t sum = fast_cosine(from_peak) + rounding::bias;
  if ((sum & rounding::doubtful) == 0) {
    sum = precise_sine(angle, ahead) + (std::uint64_t{1} << (rounding::dropped - 1));
  }
  const auto magnitude = static_cast<std::int32_t>(sum >> rounding::dropped);
  return turns < half_turn ? magnitude : -magnitude;
}

}  // namespace fixproof::detail

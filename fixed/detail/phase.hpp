/// @file
/// Sines, cosines and tangents of angles in words of at most 32 bits, in radians, degrees or turns,
/// each the nearest integer of ulps.
///
/// The code first computes in 64 bits, with a bound of the error. More bits decide where the bound
/// allows two integers. A tie is rational. By the theorems of Lindemann and Niven, the magnitudes
/// of rational results are 0, 1 and, for a sine or cosine, 1/2.
#pragma once

#include <cstdint>

#include "fixed/detail/assert.hpp"
#include "fixed/detail/choose.hpp"
#include "fixed/detail/cosine.hpp"
#include "fixed/detail/function_kinds.hpp"
#include "fixed/detail/function_tables.hpp"
#include "fixed/detail/nearest.hpp"
#include "fixed/detail/radian.hpp"
#include "fixed/detail/real.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/series.hpp"
#include "fixed/detail/wide_integer.hpp"

namespace fixproof::detail {

/// An angle in units of 2^-64 of a turn, modulo a turn. The error is at most 1 + 2^-32 units.
template <angle_unit Unit>
constexpr std::uint64_t phase_of(std::int64_t raw, int fraction_bits) noexcept {
  if constexpr (Unit == angle_unit::turn) {
    const auto bits = static_cast<std::uint64_t>(raw);
    return fraction_bits == 0 ? 0 : bits << (64 - fraction_bits);
  } else if constexpr (Unit == angle_unit::degree) {
    const std::int64_t turn = std::int64_t{360} << fraction_bits;
    const std::int64_t in_turn = raw % turn < 0 ? raw % turn + turn : raw % turn;
    // 360 is 8 * 45, and n counts units of 2^-32 degrees: this is n 2^29 / 45, in two steps.
    const std::uint64_t n = static_cast<std::uint64_t>(in_turn) << (32 - fraction_bits);
    return (n / 45 << 29) + (n % 45 << 29) / 45;
  } else {
    const auto magnitude = static_cast<std::uint64_t>(chosen(raw < 0, -raw, raw));
    const two_words high = multiply_words(magnitude, turns_high);
    const std::uint64_t carried = multiply_high(magnitude, turns_low);
    const std::uint64_t low = high.low + carried;
    const std::uint64_t top = high.high + (low < carried ? 1 : 0);
    const std::uint64_t phase =
        fraction_bits == 0 ? low : top << (64 - fraction_bits) | low >> fraction_bits;
    return chosen(raw < 0, 0 - phase, phase);
  }
}

/// The magnitude of the sine of a phase in units of 2^-62. The error is below 2^-56.
constexpr std::int64_t sine_of_phase(std::uint64_t phase) noexcept {
  constexpr std::uint64_t quarter = std::uint64_t{1} << 62;
  const std::uint64_t in_half = phase << 1 >> 1;
  const std::uint64_t from_peak = chosen(in_half < quarter, quarter - in_half, in_half - quarter);
  // 2^-64 of a turn is pi/2 units of 2^-62.
  return cosine(multiply_high(from_peak << 1, half_pi << 1));
}

/// An angle as a number of quarter turns and a rest in radians, 0 <= rest < pi/2.
struct precise_phase {
  unsigned quarters = 0;  ///< modulo 4
  real rest;
};

/// The error of the rest is below 2^-150.
template <angle_unit Unit>
constexpr precise_phase precise_phase_of(std::int64_t raw, int fraction_bits) noexcept {
  const real angle = real{raw < 0 ? -raw : raw} << (real_bits - fraction_bits);
  real quarters;
  if constexpr (Unit == angle_unit::turn) {
    quarters = angle << 2;
  } else if constexpr (Unit == angle_unit::degree) {
    quarters = quotient(angle, 90);
  } else {
    quarters = real_from(real_2_over_pi) * real{raw < 0 ? -raw : raw} >> fraction_bits;
  }
  if (raw < 0) quarters = -quarters;
  const auto whole = static_cast<std::uint64_t>(quarters >> real_bits);
  const real fraction = quarters - (quarters >> real_bits << real_bits);
  return {static_cast<unsigned>(whole % 4), product(fraction, real_from(real_pi) >> 1)};
}

struct precise_sine_and_cosine {
  real sine;
  real cosine;
};

/// The sine and cosine of an angle from 0 to pi/2, by the Taylor series. The terms after that of
/// x^57 are below 2^-200.
constexpr precise_sine_and_cosine precise_sine_of(const real& angle) noexcept {
  const real square = product(angle, angle);
  real sine = real_one;
  real cosine = real_one;
  for (std::uint32_t n = 56; n > 0; n -= 2) {
    cosine = real_one - quotient(product(square, cosine), n * (n - 1));
    sine = real_one - quotient(product(square, sine), n * (n + 1));
  }
  return {product(angle, sine), cosine};
}

/// The sine of the angle raw / 2^angle_bits plus `ahead` quarter turns in units of
/// 2^-fraction_bits. Only 1/2 and -1/2, in degrees, are ties; rule Rounding decides.
///
/// The bounds of the errors hold for every angle, and are the same in units of every result.
template <angle_unit Unit, rounding Rounding>
constexpr std::int64_t nearest_sine_of(std::int64_t raw, unsigned ahead, int angle_bits,
                                       int fraction_bits) noexcept {
  const std::uint64_t phase = phase_of<Unit>(raw, angle_bits) + (std::uint64_t{ahead} << 62);
  if (fraction_bits <= quick_bits) {
    // Modulo half a turn; the sign is that of the half.
    const auto from_peak = static_cast<std::int32_t>((phase + turns_bias - quarter_turn) >> 31);
    const nearest_ends quick =
        nearest_within(static_cast<std::int64_t>(fast_cosine(from_peak)),
                       static_cast<std::int64_t>(fast_cosine_error), 62 - fraction_bits);
    if (quick.agree()) [[likely]]
      return chosen(phase >> 63 == 0, quick.low, -quick.low);
  }
  const std::int64_t magnitude = sine_of_phase(phase);
  const std::int64_t sine = chosen(phase >> 63 == 0, magnitude, -magnitude);
  constexpr std::int64_t error = 64;
  const nearest_ends ends = nearest_within(sine, error, 62 - fraction_bits);
  if (ends.agree()) [[likely]]
    return ends.low;
  if (Unit == angle_unit::degree && fraction_bits == 0 &&
      raw % (std::int64_t{30} << angle_bits) == 0) {
    return shift_right<Rounding>(std::int64_t{phase >> 63 == 0 ? 1 : -1}, 1);
  }
  const precise_phase precise = precise_phase_of<Unit>(raw, angle_bits);
  const unsigned quarters = precise.quarters + ahead;
  const precise_sine_and_cosine both = precise_sine_of(precise.rest);
  const real result = quarters % 2 == 0 ? both.sine : both.cosine;
  return nearest_units(quarters % 4 < 2 ? result : -result, fraction_bits);
}

/// Whether the tangent is infinite: after an odd number of quarter turns. Never in radians.
template <angle_unit Unit>
constexpr bool is_pole(std::int64_t raw, int fraction_bits) noexcept {
  if constexpr (Unit == angle_unit::radian) {
    return false;
  } else {
    const std::int64_t n = Unit == angle_unit::degree ? raw : 4 * raw;
    const std::int64_t quarter = std::int64_t{Unit == angle_unit::degree ? 90 : 1} << fraction_bits;
    return n % quarter == 0 && n / quarter % 2 != 0;
  }
}

/// A tangent or, if `is_steep`, its reciprocal: n / d, both in units of 2^-62.
struct tangent_ratio {
  std::uint64_t n;
  std::uint64_t d;
  bool is_steep;
  bool is_negative;
};

/// The tangent of a phase. The error of n and of d is below 8 units even if the phase is 2 units
/// off, 0 <= n <= d and d > 0.96.
///
/// With c = i / 64 of a quarter turn and an angle z < 0.0246 beyond c, tan(c + z) is
/// (tan(c) + tan(z)) / (1 - tan(c) tan(z)). The series of tan(z) has five terms; the rest is below
/// 2^-64.
constexpr tangent_ratio tangent_of_phase(std::uint64_t phase) noexcept {
  const std::uint64_t in_quarter = phase << 2;  // in units of 2^-64 of a quarter turn
  const bool is_odd_quarter = (phase >> 62 & 1) != 0;
  const bool is_upper = in_quarter >> 63 != 0;
  const std::uint64_t part = chosen(is_upper, 0 - in_quarter, in_quarter);  // at most 2^63
  const std::uint64_t z = multiply_high(part << 6, half_pi << 1);  // 32 z in units of 2^-64
  const std::uint64_t square = multiply_high(z, z);
  const std::uint64_t sum =
      sum_of_series<tangent_coefficients.size()>(tangent_coefficients, square);
  const std::uint64_t rest = z + multiply_high(z, multiply_high(square, sum));  // 32 tan(z)
  const std::uint64_t middle = tangents[static_cast<std::uint32_t>(part >> 58)];
  return {middle + (rest >> 7), (std::uint64_t{1} << 62) - (multiply_high(middle << 1, rest) >> 6),
          is_upper != is_odd_quarter, is_odd_quarter};
}

/// Like nearest_tangent(), but without the quick try.
/// @param a the numerator of the tangent of the phase @param b its divisor
template <angle_unit Unit>
constexpr std::int64_t careful_tangent(std::uint64_t a, std::uint64_t b, bool is_negative,
                                       std::int64_t raw, int angle_bits,
                                       int fraction_bits) noexcept {
  // Tangents above 2^24 need more bits.
  if (b >> 38 != 0) {
    const int128 tangent = truncated_ratio(int128{a} << 62, int128{b});
    // Errors e of a and of b make e / b + e a / b^2 < 1.1 e (1 + a/b)^2.
    const std::int64_t bound = static_cast<std::int64_t>(tangent >> 62) + 2;
    FIXED_ASSERT((tangent >> 62) < (int128{1} << 26) && bound >= 2);
    const nearest_ends ends =
        // NOLINTNEXTLINE(bugprone-implicit-widening-of-multiplication-result): bound < 2^27
        nearest_within(tangent, int128{10 * bound} * int128{bound}, 62 - fraction_bits);
    if (ends.agree()) [[likely]]
      return is_negative ? -ends.low : ends.low;
  }
  const precise_phase precise = precise_phase_of<Unit>(raw, angle_bits);
  const precise_sine_and_cosine both = precise_sine_of(precise.rest);
  const bool is_steep = precise.quarters % 2 != 0;
  const real& n = is_steep ? both.cosine : both.sine;
  const real& d = is_steep ? both.sine : both.cosine;
  // 2^34 units are beyond every format. Next to a pole there are more than 2^64.
  if (d < n >> (34 - fraction_bits))
    return is_steep ? -(std::int64_t{1} << 34) : std::int64_t{1} << 34;
  const std::int64_t result = nearest_units(ratio(n, d), fraction_bits);
  return is_steep ? -result : result;
}

/// The tangent of the angle raw / 2^angle_bits in units of 2^-fraction_bits; a result beyond 2^33
/// units may be any integer beyond that. @pre the angle is no pole
template <angle_unit Unit>
constexpr std::int64_t nearest_tangent(std::int64_t raw, int angle_bits,
                                       int fraction_bits) noexcept {
  const tangent_ratio tangent = tangent_of_phase(phase_of<Unit>(raw, angle_bits));
  const std::uint64_t a = chosen(tangent.is_steep, tangent.d, tangent.n);
  const std::uint64_t b = chosen(tangent.is_steep, tangent.n, tangent.d);
  if (fraction_bits <= quick_bits && b >> 46 != 0) {
    // In units of 2^-32. The bits that b loses make a / b too high by less than 2.2 (1 + a/b)^2.
    // At most 2^48, because a is at most 2^62 + 8 and b at least 2^46.
    const auto quick = static_cast<std::int64_t>((a << 1) / (b >> 31));
    FIXED_ASSERT(a >> 63 == 0 && quick >= 0 && quick >> 49 == 0);
    const std::int64_t bound = (quick >> 32) + 2;
    const nearest_ends ends = nearest_within(quick, 3 * bound * bound, 32 - fraction_bits);
    if (ends.agree()) [[likely]]
      return chosen(tangent.is_negative, -ends.low, ends.low);
  }
  return careful_tangent<Unit>(a, b, tangent.is_negative, raw, angle_bits, fraction_bits);
}

}  // namespace fixproof::detail

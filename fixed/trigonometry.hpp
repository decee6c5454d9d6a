/// @file
/// Sines, cosines and tangents of radians, degrees and turns, rounded to nearest, in every format;
/// docs/functions.md says what was compared.
///
/// Each result is the number nearest to the exact value, or a bound of it under policy::functions.
/// Only sines and cosines of degrees in a format without fraction bits have ties: 1/2 and -1/2. If
/// the policy rounds products to nearest, ties follow that rule; otherwise they go up. A result out
/// of range throws an overflow_error under overflow::trap. Under every other policy it saturates.
///
/// fixed/sine.hpp has sin(), cos() and sin_cos() of radians in 16.16 and 8.8.
#pragma once

#include <cstdint>
#include <limits>

#include "fixed/detail/function_kinds.hpp"
#include "fixed/detail/interval_angle.hpp"
#include "fixed/detail/limited.hpp"
#include "fixed/detail/operands.hpp"
#include "fixed/detail/variant.hpp"
#include "fixed/number.hpp"
#include "fixed/sine.hpp"

#if defined(FIXED_SMALL)
#include "fixed/detail/digit_phase.hpp"
#else
#include "fixed/detail/phase.hpp"
#endif

namespace fixproof {

namespace detail::FIXED_FUNCTIONS {

/// The sine of an angle plus `ahead` quarter turns, as a To.
template <angle_unit Unit, class To, class Number>
constexpr To sine_of(Number x, unsigned ahead, const char* function) noexcept(To::never_throws) {
  if constexpr (needs_intervals<To, Number>) {
    return limited<To>(
        interval_sine<Unit, rounding_of<To>>(real_operand_of(x), ahead, To::fraction_bits),
        function, x);
  } else {
    return limited<To>(nearest_sine_of<Unit, rounding_of<To>>(x.raw(), ahead, Number::fraction_bits,
                                                              To::fraction_bits),
                       function, x);
  }
}

/// The tangent of an angle, as a To.
template <angle_unit Unit, class To, class Number>
constexpr To tangent_of(Number x, const char* function) noexcept(To::never_throws) {
  using limits = std::numeric_limits<typename To::raw_type>;
  if constexpr (needs_intervals<To, Number>) {
    if (is_tangent_pole<Unit>(real_operand_of(x))) {
      return outside_domain<To>((limits::max)(), function, x);
    }
    return limited<To>(
        interval_tangent<Unit, rounding_of<To>>(real_operand_of(x), To::fraction_bits), function,
        x);
  } else {
    if (is_pole<Unit>(x.raw(), Number::fraction_bits)) {
      return outside_domain<To>((limits::max)(), function, x);
    }
    return limited<To>(nearest_tangent<Unit>(x.raw(), Number::fraction_bits, To::fraction_bits),
                       function, x);
  }
}

}  // namespace detail::FIXED_FUNCTIONS

inline namespace FIXED_FUNCTIONS {

/// The sine of an angle in radians.
///
///     static_assert(sin(q2_30(1)).raw() == 903522590);  // 903522589.9
template <class Raw, int Point, policy Rules>
requires(!detail::has_radians<Raw, Point, Rules>)
    [[nodiscard]] constexpr number<Raw, Point, Rules> sin(number<Raw, Point, Rules> angle) noexcept(
        number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::sine_of<detail::angle_unit::radian, number<Raw, Point, Rules>>(
      angle, 0, "sin");
}

/// The cosine of an angle in radians.
///
///     static_assert(cos(q8_24(100)).raw() == 14467310);  // 14467309.98
template <class Raw, int Point, policy Rules>
requires(!detail::has_radians<Raw, Point, Rules>)
    [[nodiscard]] constexpr number<Raw, Point, Rules> cos(number<Raw, Point, Rules> angle) noexcept(
        number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::sine_of<detail::angle_unit::radian, number<Raw, Point, Rules>>(
      angle, 1, "cos");
}

/// The tangent of an angle in radians.
///
///     static_assert(tan(q16_16(1)).raw() == 102066);  // 102066.3
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> tan(number<Raw, Point, Rules> angle) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::tangent_of<detail::angle_unit::radian, number<Raw, Point, Rules>>(
      angle, "tan");
}

/// The sine of an angle in degrees.
///
///     static_assert(sin_of_degrees(q16_16(30)) == q16_16(0.5));
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> sin_of_degrees(
    number<Raw, Point, Rules> angle) noexcept(number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::sine_of<detail::angle_unit::degree, number<Raw, Point, Rules>>(
      angle, 0, "sin_of_degrees");
}

/// The cosine of an angle in degrees.
///
///     static_assert(cos_of_degrees(q16_16(60)) == q16_16(0.5));
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> cos_of_degrees(
    number<Raw, Point, Rules> angle) noexcept(number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::sine_of<detail::angle_unit::degree, number<Raw, Point, Rules>>(
      angle, 1, "cos_of_degrees");
}

/// The tangent of an angle in degrees. For an odd number of quarter turns it throws a domain_error
/// under overflow::trap, and is the highest number under every other policy.
///
///     static_assert(tan_of_degrees(q16_16(45)) == 1);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> tan_of_degrees(
    number<Raw, Point, Rules> angle) noexcept(number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::tangent_of<detail::angle_unit::degree, number<Raw, Point, Rules>>(
      angle, "tan_of_degrees");
}

/// The sine of an angle in turns.
///
///     static_assert(sin_of_turns(q16_16(0.25)) == 1);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> sin_of_turns(
    number<Raw, Point, Rules> angle) noexcept(number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::sine_of<detail::angle_unit::turn, number<Raw, Point, Rules>>(
      angle, 0, "sin_of_turns");
}

/// The cosine of an angle in turns.
///
///     static_assert(cos_of_turns(q16_16(0.5)) == -1);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> cos_of_turns(
    number<Raw, Point, Rules> angle) noexcept(number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::sine_of<detail::angle_unit::turn, number<Raw, Point, Rules>>(
      angle, 1, "cos_of_turns");
}

/// The tangent of an angle in turns. For an odd number of quarter turns it throws a domain_error
/// under overflow::trap, and is the highest number under every other policy.
///
///     static_assert(tan_of_turns(q16_16(0.125)) == 1);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> tan_of_turns(
    number<Raw, Point, Rules> angle) noexcept(number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::tangent_of<detail::angle_unit::turn, number<Raw, Point, Rules>>(
      angle, "tan_of_turns");
}

/// cos() and sin() of an angle in radians.
///
///     const auto [sin, cos] = fixproof::sin_cos(fixproof::q2_30(0.5));
template <class Raw, int Point, policy Rules>
requires(!detail::has_radians<Raw, Point, Rules>)
    [[nodiscard]] constexpr sin_and_cos<number<Raw, Point, Rules>> sin_cos(
        number<Raw, Point, Rules> angle) noexcept(number<Raw, Point, Rules>::never_throws) {
  return {sin(angle), cos(angle)};
}

/// cos_of_degrees() and sin_of_degrees().
///
///     static_assert(sin_cos_of_degrees(q16_16(90)).sin == 1);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr sin_and_cos<number<Raw, Point, Rules>> sin_cos_of_degrees(
    number<Raw, Point, Rules> angle) noexcept(number<Raw, Point, Rules>::never_throws) {
  return {sin_of_degrees(angle), cos_of_degrees(angle)};
}

/// cos_of_turns() and sin_of_turns().
///
///     static_assert(sin_cos_of_turns(q16_16(0.5)).cos == -1);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr sin_and_cos<number<Raw, Point, Rules>> sin_cos_of_turns(
    number<Raw, Point, Rules> angle) noexcept(number<Raw, Point, Rules>::never_throws) {
  return {sin_of_turns(angle), cos_of_turns(angle)};
}

/// @cond
FIXED_REFUSED_PLAIN(tan)
FIXED_REFUSED_PLAIN(sin_of_degrees)
FIXED_REFUSED_PLAIN(cos_of_degrees)
FIXED_REFUSED_PLAIN(tan_of_degrees)
FIXED_REFUSED_PLAIN(sin_of_turns)
FIXED_REFUSED_PLAIN(cos_of_turns)
FIXED_REFUSED_PLAIN(tan_of_turns)
FIXED_REFUSED_PLAIN(sin_cos)
FIXED_REFUSED_PLAIN(sin_cos_of_degrees)
FIXED_REFUSED_PLAIN(sin_cos_of_turns)
/// @endcond

}  // namespace FIXED_FUNCTIONS
}  // namespace fixproof

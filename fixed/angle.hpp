/// @file
/// Angles from vectors, tangents, sines and cosines, rounded to nearest, in every format;
/// docs/functions.md says what was compared.
///
/// Each result is the number nearest to the exact angle, or a bound of it under policy::functions.
/// Only angles in turns have ties. If the policy rounds products to nearest, ties follow that rule;
/// otherwise they go up. A signed format with fewer than three bits before the point, or an
/// unsigned one with none, can have results out of range. They throw an overflow_error under
/// overflow::trap, and saturate under every other policy.
#pragma once

#include <cstdint>

#include "fixed/detail/function_kinds.hpp"
#include "fixed/detail/interval_angle.hpp"
#include "fixed/detail/limited.hpp"
#include "fixed/detail/operands.hpp"
#include "fixed/detail/variant.hpp"
#include "fixed/number.hpp"

#if defined(FIXED_SMALL)
#include "fixed/detail/digit_angle.hpp"
#else
#include "fixed/detail/arcsine.hpp"
#include "fixed/detail/arctangent.hpp"
#endif

namespace fixproof {

namespace detail::FIXED_FUNCTIONS {

/// Whether an angle needs intervals. Angles in degrees and turns have no other code.
template <angle_unit Unit, class To, class Number>
inline constexpr bool angle_needs_intervals =
    Unit != angle_unit::radian || needs_intervals<To, Number>;

/// The angle of a vector, as a To.
template <angle_unit Unit, class To, class Number>
constexpr To angle_of(Number y, Number x, const char* function) noexcept(To::never_throws) {
  if constexpr (angle_needs_intervals<Unit, To, Number>) {
    return limited<To>(interval_vector_angle<Unit, rounding_of<To>>(
                           real_operand_of(y), real_operand_of(x), To::fraction_bits),
                       function, y, x);
  } else {
    return limited<To>(nearest_angle(y.raw(), x.raw(), To::fraction_bits), function, y, x);
  }
}

/// The angle of a tangent, as a To.
template <angle_unit Unit, class To, class Number>
constexpr To angle_of_slope(Number x, const char* function) noexcept(To::never_throws) {
  if constexpr (angle_needs_intervals<Unit, To, Number>) {
    return limited<To>(
        interval_slope_angle<Unit, rounding_of<To>>(real_operand_of(x), To::fraction_bits),
        function, x);
  } else {
    constexpr std::int64_t one = std::int64_t{1} << Number::fraction_bits;
    return limited<To>(nearest_angle(x.raw(), one, To::fraction_bits), function, x);
  }
}

/// The arcsine or arccosine, as a To.
template <angle_unit Unit, triangle_side Side, class To, class Number>
constexpr To triangle_angle(Number x, const char* function) noexcept(To::never_throws) {
  if constexpr (angle_needs_intervals<Unit, To, Number>) {
    const real_operand operand = real_operand_of(x);
    if (operand.whole() > 1 || (operand.whole() == 1 && !operand.is_one())) {
      return outside_domain<To>(0, function, x);
    }
    return limited<To>(
        interval_triangle_angle<Unit, Side, rounding_of<To>>(operand, To::fraction_bits), function,
        x);
  } else {
    constexpr std::int64_t one = std::int64_t{1} << Number::fraction_bits;
    if (x.raw() > one || x.raw() < -one) return outside_domain<To>(0, function, x);
    return limited<To>(
        nearest_triangle_angle<Side>(x.raw(), Number::fraction_bits, To::fraction_bits), function,
        x);
  }
}

}  // namespace detail::FIXED_FUNCTIONS

inline namespace FIXED_FUNCTIONS {

/// The angle whose tangent is x, from -pi/2 to pi/2.
///
///     static_assert(atan(q16_16(1)).raw() == 51472);    // 51471.9
///     static_assert(atan(q16_16(-1)).raw() == -51472);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> atan(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::angle_of_slope<detail::angle_unit::radian,
                                                 number<Raw, Point, Rules>>(x, "atan");
}

/// The angle of the vector (x, y), from -pi to pi; 0 if both are 0.
///
///     static_assert(atan2(q16_16(1), q16_16(-1)).raw() == 154416);   // 154415.7
///     static_assert(atan2(q16_16(), q16_16(-1)) == pi_v<q16_16>);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> atan2(
    number<Raw, Point, Rules> y,
    number<Raw, Point, Rules> x) noexcept(number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::angle_of<detail::angle_unit::radian, number<Raw, Point, Rules>>(
      y, x, "atan2");
}

/// The angle whose sine is x, from -pi/2 to pi/2. Outside -1 to 1 it throws a domain_error under
/// overflow::trap, and is 0 under every other policy.
///
///     static_assert(asin(q16_16(0.5)).raw() == 34315);  // 34314.6
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> asin(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::triangle_angle<
      detail::angle_unit::radian, detail::triangle_side::sine, number<Raw, Point, Rules>>(x,
                                                                                          "asin");
}

/// The angle whose cosine is x, from 0 to pi. Outside -1 to 1, see asin().
///
///     static_assert(acos(q16_16(-1)) == pi_v<q16_16>);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> acos(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::triangle_angle<
      detail::angle_unit::radian, detail::triangle_side::cosine, number<Raw, Point, Rules>>(x,
                                                                                            "acos");
}

/// The angle whose tangent is x, in degrees.
///
///     static_assert(atan_in_degrees(q16_16(-1)) == -45);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> atan_in_degrees(
    number<Raw, Point, Rules> x) noexcept(number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::angle_of_slope<detail::angle_unit::degree,
                                                 number<Raw, Point, Rules>>(x, "atan_in_degrees");
}

/// The angle of the vector (x, y), in degrees; 0 if both are 0.
///
///     static_assert(atan2_in_degrees(q16_16(1), q16_16(-1)) == 135);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> atan2_in_degrees(
    number<Raw, Point, Rules> y,
    number<Raw, Point, Rules> x) noexcept(number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::angle_of<detail::angle_unit::degree, number<Raw, Point, Rules>>(
      y, x, "atan2_in_degrees");
}

/// The angle whose sine is x, in degrees. Outside -1 to 1, see asin().
///
///     static_assert(asin_in_degrees(q16_16(0.5)) == 30);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> asin_in_degrees(
    number<Raw, Point, Rules> x) noexcept(number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::triangle_angle<
      detail::angle_unit::degree, detail::triangle_side::sine, number<Raw, Point, Rules>>(
      x, "asin_in_degrees");
}

/// The angle whose cosine is x, in degrees. Outside -1 to 1, see asin().
///
///     static_assert(acos_in_degrees(q16_16(0.5)) == 60);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> acos_in_degrees(
    number<Raw, Point, Rules> x) noexcept(number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::triangle_angle<
      detail::angle_unit::degree, detail::triangle_side::cosine, number<Raw, Point, Rules>>(
      x, "acos_in_degrees");
}

/// The angle whose tangent is x, in turns.
///
///     static_assert(atan_in_turns(q16_16(-1)) == q16_16(-0.125));
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> atan_in_turns(
    number<Raw, Point, Rules> x) noexcept(number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::angle_of_slope<detail::angle_unit::turn,
                                                 number<Raw, Point, Rules>>(x, "atan_in_turns");
}

/// The angle of the vector (x, y), in turns; 0 if both are 0.
///
///     static_assert(atan2_in_turns(q16_16(1), q16_16(-1)) == q16_16(0.375));
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> atan2_in_turns(
    number<Raw, Point, Rules> y,
    number<Raw, Point, Rules> x) noexcept(number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::angle_of<detail::angle_unit::turn, number<Raw, Point, Rules>>(
      y, x, "atan2_in_turns");
}

/// The angle whose sine is x, in turns. Outside -1 to 1, see asin().
///
///     static_assert(asin_in_turns(q16_16(-1)) == q16_16(-0.25));
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> asin_in_turns(
    number<Raw, Point, Rules> x) noexcept(number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::triangle_angle<
      detail::angle_unit::turn, detail::triangle_side::sine, number<Raw, Point, Rules>>(
      x, "asin_in_turns");
}

/// The angle whose cosine is x, in turns. Outside -1 to 1, see asin().
///
///     static_assert(acos_in_turns(q16_16(-1)) == q16_16(0.5));
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> acos_in_turns(
    number<Raw, Point, Rules> x) noexcept(number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::triangle_angle<
      detail::angle_unit::turn, detail::triangle_side::cosine, number<Raw, Point, Rules>>(
      x, "acos_in_turns");
}

/// @cond
FIXED_REFUSED_PLAIN(atan)
FIXED_REFUSED_PLAIN(asin)
FIXED_REFUSED_PLAIN(acos)
FIXED_REFUSED_MIX(atan2)
FIXED_REFUSED_PLAIN(atan_in_degrees)
FIXED_REFUSED_PLAIN(asin_in_degrees)
FIXED_REFUSED_PLAIN(acos_in_degrees)
FIXED_REFUSED_PLAIN(atan_in_turns)
FIXED_REFUSED_PLAIN(asin_in_turns)
FIXED_REFUSED_PLAIN(acos_in_turns)
FIXED_REFUSED_MIX(atan2_in_degrees)
FIXED_REFUSED_MIX(atan2_in_turns)
/// @endcond

}  // namespace FIXED_FUNCTIONS
}  // namespace fixproof

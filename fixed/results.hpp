/// @file
/// Functions of real numbers with a result in a format of its own: sin<q2_30>(x) for an x of 16.16.
///
/// Each result is the To nearest to the exact value, or a bound of it under policy::functions of
/// To. The policy of To decides ties and results out of range, and what happens outside the domain,
/// as the policy of the type does in the functions of one format. sqrt<To>() and hypot<To>() are in
/// fixed/power.hpp.
#pragma once

#include <cstdint>

#include "fixed/angle.hpp"
#include "fixed/detail/function_kinds.hpp"
#include "fixed/detail/variant.hpp"
#include "fixed/exponential.hpp"
#include "fixed/number.hpp"
#include "fixed/sine.hpp"
#include "fixed/trigonometry.hpp"

namespace fixproof {
inline namespace FIXED_FUNCTIONS {

/// @name Sines, cosines and tangents
/// \{

/// The sine of an angle in radians, as a To.
///
///     static_assert(sin<q2_30>(q16_16(100)).raw() == -543705967);  // -543705967.1
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To sin(number<Raw, Point, Rules> angle) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::sine_of<detail::angle_unit::radian, To>(angle, 0, "sin");
}

/// The cosine of an angle in radians, as a To.
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To cos(number<Raw, Point, Rules> angle) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::sine_of<detail::angle_unit::radian, To>(angle, 1, "cos");
}

/// The tangent of an angle in radians, as a To.
///
///     static_assert(tan<q16_16>(q2_30(1.5)).raw() == 924151);  // 924150.7
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To tan(number<Raw, Point, Rules> angle) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::tangent_of<detail::angle_unit::radian, To>(angle, "tan");
}

/// The sine of an angle in degrees, as a To.
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To sin_of_degrees(number<Raw, Point, Rules> angle) noexcept(
    To::never_throws) {
  return detail::FIXED_FUNCTIONS::sine_of<detail::angle_unit::degree, To>(angle, 0,
                                                                          "sin_of_degrees");
}

/// The cosine of an angle in degrees, as a To.
///
///     static_assert(cos_of_degrees<q2_30>(q16_16(60)) == q2_30(0.5));
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To cos_of_degrees(number<Raw, Point, Rules> angle) noexcept(
    To::never_throws) {
  return detail::FIXED_FUNCTIONS::sine_of<detail::angle_unit::degree, To>(angle, 1,
                                                                          "cos_of_degrees");
}

/// The tangent of an angle in degrees, as a To. The highest number for an odd number of quarter
/// turns, or a domain_error; see tan_of_degrees() of one format.
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To tan_of_degrees(number<Raw, Point, Rules> angle) noexcept(
    To::never_throws) {
  return detail::FIXED_FUNCTIONS::tangent_of<detail::angle_unit::degree, To>(angle,
                                                                             "tan_of_degrees");
}

/// The sine of an angle in turns, as a To.
///
///     static_assert(sin_of_turns<q16_16>(u0_32(0.25)) == 1);  // out of range in u0_32
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To sin_of_turns(number<Raw, Point, Rules> angle) noexcept(
    To::never_throws) {
  return detail::FIXED_FUNCTIONS::sine_of<detail::angle_unit::turn, To>(angle, 0, "sin_of_turns");
}

/// The cosine of an angle in turns, as a To.
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To cos_of_turns(number<Raw, Point, Rules> angle) noexcept(
    To::never_throws) {
  return detail::FIXED_FUNCTIONS::sine_of<detail::angle_unit::turn, To>(angle, 1, "cos_of_turns");
}

/// The tangent of an angle in turns, as a To. The highest number for an odd number of quarter
/// turns, or a domain_error; see tan_of_turns() of one format.
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To tan_of_turns(number<Raw, Point, Rules> angle) noexcept(
    To::never_throws) {
  return detail::FIXED_FUNCTIONS::tangent_of<detail::angle_unit::turn, To>(angle, "tan_of_turns");
}

/// cos<To>() and sin<To>().
///
///     static_assert(sin_cos<q2_30>(q16_16()).cos == 1);
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr sin_and_cos<To> sin_cos(number<Raw, Point, Rules> angle) noexcept(
    To::never_throws) {
  return {sin<To>(angle), cos<To>(angle)};
}

/// cos_of_degrees<To>() and sin_of_degrees<To>().
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr sin_and_cos<To> sin_cos_of_degrees(
    number<Raw, Point, Rules> angle) noexcept(To::never_throws) {
  return {sin_of_degrees<To>(angle), cos_of_degrees<To>(angle)};
}

/// cos_of_turns<To>() and sin_of_turns<To>().
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr sin_and_cos<To> sin_cos_of_turns(number<Raw, Point, Rules> angle) noexcept(
    To::never_throws) {
  return {sin_of_turns<To>(angle), cos_of_turns<To>(angle)};
}

/// \}

/// @name Exponentials and hyperbolic functions
/// \{

/// 2 to the power of x, as a To.
///
///     static_assert(exp2<q16_16>(q2_30(-1.5)).raw() == 23170);  // 23170.475
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To exp2(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::exponential<detail::exponential_base::two, To>(x, 0, "exp2");
}

/// e to the power of x, as a To.
///
///     static_assert(exp<q2_30>(q16_16(-1)).raw() == 395007542);  // 395007542.2
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To exp(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::exponential<detail::exponential_base::e, To>(x, 0, "exp");
}

/// e to the power of x, minus 1, as a To.
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To expm1(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::exponential<detail::exponential_base::e, To>(x, 1, "expm1");
}

/// 10 to the power of x, as a To.
///
///     static_assert(exp10<q2_30>(q16_16(-1)).raw() == 107374182);  // 107374182.4
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To exp10(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::exponential<detail::exponential_base::ten, To>(x, 0, "exp10");
}

/// The hyperbolic sine, as a To.
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To sinh(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::hyperbolic<detail::hyperbola::sine, To>(x, "sinh");
}

/// The hyperbolic cosine, as a To.
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To cosh(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::hyperbolic<detail::hyperbola::cosine, To>(x, "cosh");
}

/// The hyperbolic tangent, as a To.
///
///     static_assert(tanh<q1_31>(q16_16(-1)).raw() == -1635510996);  // -1635510996.3
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To tanh(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::hyperbolic_tangent<To>(x);
}

/// The number whose hyperbolic sine is x, as a To.
///
///     static_assert(asinh<q8_24>(q16_16(-1)).raw() == -14786995);  // -14786995.05
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To asinh(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::inverse_hyperbolic<detail::hyperbola::sine, To>(x, "asinh");
}

/// The number from 0 on whose hyperbolic cosine is x, as a To. Below 1 it is 0, or a domain_error.
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To acosh(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::inverse_hyperbolic<detail::hyperbola::cosine, To>(x, "acosh");
}

/// The number whose hyperbolic tangent is x, as a To. Outside -1 to 1, and there, it is 0, or a
/// domain_error.
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To atanh(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::inverse_hyperbolic_tangent<To>(x);
}

/// \}

/// @name Logarithms
/// \{

/// The natural logarithm, as a To. For x <= 0 it is the lowest To, or a domain_error; see log() of
/// one format.
///
///     static_assert(log<q8_24>(q32_0(3000000)).raw() == 250217460);  // 250217460.4
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To log(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::logarithm<detail::logarithm_base::e, To>(x, 0, "log");
}

/// The natural logarithm of 1 + x, as a To. For x <= -1, see log().
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To log1p(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::logarithm<detail::logarithm_base::e, To>(x, 1, "log1p");
}

/// The logarithm to base 2, as a To. For x <= 0, see log().
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To log2(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::logarithm<detail::logarithm_base::two, To>(x, 0, "log2");
}

/// The logarithm to base 10, as a To. For x <= 0, see log().
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To log10(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::logarithm<detail::logarithm_base::ten, To>(x, 0, "log10");
}

/// \}

/// @name Angles
/// \{

/// The angle whose tangent is x, as a To.
///
///     static_assert(atan<q2_30>(q16_16(100)).raw() == 1675892653);  // 1675892652.7
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To atan(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::angle_of_slope<detail::angle_unit::radian, To>(x, "atan");
}

/// The angle of the vector (x, y), as a To; 0 if both are 0. The two numbers have one type.
///
///     static_assert(atan2<q4_28>(q16_16(1), q16_16(-1)).raw() == 632486142);
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To atan2(number<Raw, Point, Rules> y,
                                 number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::angle_of<detail::angle_unit::radian, To>(y, x, "atan2");
}

/// The angle whose sine is x, as a To. Outside -1 to 1 it is 0, or a domain_error.
///
///     static_assert(asin<q2_30>(q1_31(-1)).raw() == -1686629713);  // -pi/2
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To asin(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::triangle_angle<detail::angle_unit::radian,
                                                 detail::triangle_side::sine, To>(x, "asin");
}

/// The angle whose cosine is x, as a To. Outside -1 to 1, see asin().
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To acos(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::triangle_angle<detail::angle_unit::radian,
                                                 detail::triangle_side::cosine, To>(x, "acos");
}

/// The angle whose tangent is x, in degrees, as a To.
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To atan_in_degrees(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::angle_of_slope<detail::angle_unit::degree, To>(x,
                                                                                 "atan_in_degrees");
}

/// The angle of the vector (x, y), in degrees, as a To; 0 if both are 0. The two numbers have one
/// type.
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To atan2_in_degrees(
    number<Raw, Point, Rules> y, number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::angle_of<detail::angle_unit::degree, To>(y, x,
                                                                           "atan2_in_degrees");
}

/// The angle whose sine is x, in degrees, as a To. Outside -1 to 1, see asin().
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To asin_in_degrees(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::triangle_angle<detail::angle_unit::degree,
                                                 detail::triangle_side::sine, To>(
      x, "asin_in_degrees");
}

/// The angle whose cosine is x, in degrees, as a To. Outside -1 to 1, see asin().
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To acos_in_degrees(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::triangle_angle<detail::angle_unit::degree,
                                                 detail::triangle_side::cosine, To>(
      x, "acos_in_degrees");
}

/// The angle whose tangent is x, in turns, as a To.
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To atan_in_turns(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::angle_of_slope<detail::angle_unit::turn, To>(x, "atan_in_turns");
}

/// The angle of the vector (x, y), in turns, as a To; 0 if both are 0. The two numbers have one
/// type.
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To atan2_in_turns(number<Raw, Point, Rules> y,
                                          number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::angle_of<detail::angle_unit::turn, To>(y, x, "atan2_in_turns");
}

/// The angle whose sine is x, in turns, as a To. Outside -1 to 1, see asin().
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To asin_in_turns(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::triangle_angle<detail::angle_unit::turn,
                                                 detail::triangle_side::sine, To>(x,
                                                                                  "asin_in_turns");
}

/// The angle whose cosine is x, in turns, as a To. Outside -1 to 1, see asin().
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To acos_in_turns(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::triangle_angle<detail::angle_unit::turn,
                                                 detail::triangle_side::cosine, To>(
      x, "acos_in_turns");
}

/// \}

}  // namespace FIXED_FUNCTIONS
}  // namespace fixproof

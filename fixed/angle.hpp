/// @file
/// Angles in radians from vectors, tangents, sines and cosines, rounded to nearest, in every format
/// of at most 32 bits; docs/functions.md says what was compared.
///
/// Each result is the number nearest to the exact angle, under every policy; there are no ties. A
/// signed format with fewer than three bits before the point, or an unsigned one with none, can
/// have results out of range. They throw an overflow_error under overflow::trap, and saturate under
/// every other policy.
#pragma once

#include <cstdint>

#include "fixed/detail/function_kinds.hpp"
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

/// The angle of a vector, as a To.
template <class To, class... Operands>
constexpr To angle_of(std::int64_t y, std::int64_t x, const char* function,
                      Operands... operands) noexcept(To::never_throws) {
  return limited<To>(nearest_angle(y, x, To::fraction_bits), function, operands...);
}

/// The arcsine or arccosine, as a To.
template <triangle_side Side, class To, class Number>
constexpr To triangle_angle(Number x, const char* function) noexcept(To::never_throws) {
  constexpr std::int64_t one = std::int64_t{1} << Number::fraction_bits;
  if (x.raw() > one || x.raw() < -one) return outside_domain<To>(0, function, x);
  return limited<To>(
      nearest_triangle_angle<Side>(x.raw(), Number::fraction_bits, To::fraction_bits), function, x);
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
  FIXED_NEEDS_32_BITS(atan, number<Raw, Point, Rules>);
  return detail::FIXED_FUNCTIONS::angle_of<number<Raw, Point, Rules>>(
      x.raw(), std::int64_t{1} << Point, "atan", x);
}

/// The angle of the vector (x, y), from -pi to pi; 0 if both are 0.
///
///     static_assert(atan2(q16_16(1), q16_16(-1)).raw() == 154416);   // 154415.7
///     static_assert(atan2(q16_16(), q16_16(-1)) == pi_v<q16_16>);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> atan2(
    number<Raw, Point, Rules> y,
    number<Raw, Point, Rules> x) noexcept(number<Raw, Point, Rules>::never_throws) {
  FIXED_NEEDS_32_BITS(atan2, number<Raw, Point, Rules>);
  return detail::FIXED_FUNCTIONS::angle_of<number<Raw, Point, Rules>>(y.raw(), x.raw(), "atan2", y,
                                                                      x);
}

/// The angle whose sine is x, from -pi/2 to pi/2. Outside -1 to 1 it throws a domain_error under
/// overflow::trap, and is 0 under every other policy.
///
///     static_assert(asin(q16_16(0.5)).raw() == 34315);  // 34314.6
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> asin(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  FIXED_NEEDS_32_BITS(asin, number<Raw, Point, Rules>);
  return detail::FIXED_FUNCTIONS::triangle_angle<detail::triangle_side::sine,
                                                 number<Raw, Point, Rules>>(x, "asin");
}

/// The angle whose cosine is x, from 0 to pi. Outside -1 to 1, see asin().
///
///     static_assert(acos(q16_16(-1)) == pi_v<q16_16>);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> acos(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  FIXED_NEEDS_32_BITS(acos, number<Raw, Point, Rules>);
  return detail::FIXED_FUNCTIONS::triangle_angle<detail::triangle_side::cosine,
                                                 number<Raw, Point, Rules>>(x, "acos");
}

/// @cond
FIXED_REFUSED_PLAIN(atan)
FIXED_REFUSED_PLAIN(asin)
FIXED_REFUSED_PLAIN(acos)
FIXED_REFUSED_MIX(atan2)
/// @endcond

}  // namespace FIXED_FUNCTIONS
}  // namespace fixproof

/// \file
/// Angles of vectors in radians, correctly rounded for every operand of every format of at most 32
/// bits.
///
/// Each result is the number nearest to the exact angle, under every policy; there are no ties. A
/// result out of range, which a format with fewer than three bits before the point can have, throws
/// an overflow_error under overflow::trap; under every other policy it saturates.
///
/// fixed.hpp does not include this header.
#pragma once

#include <cstdint>
#include <limits>

#include "fixed/detail/arctangent.hpp"
#include "fixed/detail/overflow.hpp"
#include "fixed/detail/raise.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/number.hpp"

namespace fixproof {

namespace detail {

template <class Raw, int F, policy P, class... Operands>
constexpr number<Raw, F, P> angle_of(
    std::int64_t y, std::int64_t x, const char* function,
    Operands... operands) noexcept(number<Raw, F, P>::never_throws) {
  static_assert(bits_of<Raw> <= 32,
                "atan and atan2 need a format of at most 32 bits: convert, as in atan(q16_16(x))");
  constexpr overflow range = P.range == overflow::trap ? overflow::trap : overflow::saturate;
  return number<Raw, F, P>::from_raw(narrow<range, Raw>(
      nearest_angle<F>(y, x), [&] { raise_overflow<F>(function, operands...); }));
}

}  // namespace detail

/// The angle whose tangent is x, from -pi/2 to pi/2.
///
///     static_assert(atan(q16_16(1)).raw() == 51472);    // 51471.9
///     static_assert(atan(q16_16(-1)).raw() == -51472);
template <class Raw, int F, policy P>
[[nodiscard]] constexpr number<Raw, F, P> atan(number<Raw, F, P> x) noexcept(
    number<Raw, F, P>::never_throws) {
  return detail::angle_of<Raw, F, P>(x.raw(), std::int64_t{1} << F, "atan", x.raw());
}

/// The angle of the vector (x, y), from -pi to pi; 0 if both are 0.
///
///     static_assert(atan2(q16_16(1), q16_16(-1)).raw() == 154416);   // 154415.7
///     static_assert(atan2(q16_16(), q16_16(-1)) == pi_v<q16_16>);
template <class Raw, int F, policy P>
[[nodiscard]] constexpr number<Raw, F, P> atan2(number<Raw, F, P> y, number<Raw, F, P> x) noexcept(
    number<Raw, F, P>::never_throws) {
  return detail::angle_of<Raw, F, P>(y.raw(), x.raw(), "atan2", y.raw(), x.raw());
}

}  // namespace fixproof

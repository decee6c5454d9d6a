/// @file
/// Functions of `<cmath>` that are exact on numbers: remainders, parts, neighbours and signs.
/// fixed/math.hpp, exponential.hpp, trigonometry.hpp, angle.hpp and power.hpp have the others.
#pragma once

#include <concepts>
#include <cstdint>
#include <type_traits>

#include "fixed/detail/operands.hpp"
#include "fixed/detail/raise.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/math.hpp"
#include "fixed/number.hpp"

namespace fixproof {

namespace detail {

/// The magnitude of a stored integer.
template <class Raw>
constexpr std::uint64_t magnitude(Raw raw) noexcept {
  const auto bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(raw));
  return raw < 0 ? 0 - bits : bits;
}

/// x % y. Where that throws for a zero, the error names `function`.
template <class Raw, int Point, policy Rules>
constexpr number<Raw, Point, Rules> remainder_in(
    const char* function, number<Raw, Point, Rules> x,
    number<Raw, Point, Rules> y) noexcept(number<Raw, Point, Rules>::divide_never_throws) {
  if constexpr (!number<Raw, Point, Rules>::divide_never_throws) {
    if (y.raw() == 0) {
      raise<divide_error>("divide error", function, operand<Raw, Point>{x.raw()},
                          operand<Raw, Point>{y.raw()});
    }
  }
  return x % y;
}

/// remquo() in the name of `function`.
template <class Raw, int Point, policy Rules>
constexpr number<Raw, Point, Rules> nearest_remainder_in(
    const char* function, number<Raw, Point, Rules> x, number<Raw, Point, Rules> y,
    int* quotient) noexcept(number<Raw, Point, Rules>::divide_never_throws) {
  const number<Raw, Point, Rules> truncated = remainder_in(function, x, y);
  *quotient = 0;
  if (y.raw() == 0) return truncated;
  const std::uint64_t divisor = magnitude(y.raw());
  const std::uint64_t rest = magnitude(truncated.raw());
  std::uint64_t whole = magnitude(x.raw()) / divisor;
  const std::uint64_t missing = divisor - rest;
  const bool up = rest > missing || (rest == missing && whole % 2 != 0);
  if (up) ++whole;
  const int low = static_cast<int>(whole & 0x7FFFFFFF);
  *quotient = (x.raw() < 0) == (y.raw() < 0) ? low : -low;
  if (!up) return truncated;
  // At most half the divisor, on the other side of zero.
  const auto other = static_cast<std::int64_t>(missing);
  return number<Raw, Point, Rules>::from_raw(static_cast<Raw>(x.raw() < 0 ? other : -other));
}

}  // namespace detail

/// x % y: the remainder of the quotient truncated toward zero, with the sign of x. Exact.
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> fmod(
    number<Raw, Point, Rules> x,
    number<Raw, Point, Rules> y) noexcept(number<Raw, Point, Rules>::divide_never_throws) {
  return detail::remainder_in("fmod", x, y);
}

/// x - n * y, exact, where n is the integer nearest to x / y, ties to even. Sets *quotient to the
/// low 31 bits of n with its sign. Division by zero is an error where x % y makes it one; otherwise
/// the remainder and the quotient are 0. Signed formats only, because the remainder can be
/// negative.
///
///     int n = 0;
///     const q16_16 rest = remquo(q16_16(9.5), q16_16(2), &n);  // -0.5, and n is 5
template <class Raw, int Point, policy Rules>
requires(std::is_signed_v<Raw>) [[nodiscard]] constexpr number<Raw, Point, Rules> remquo(
    number<Raw, Point, Rules> x, number<Raw, Point, Rules> y,
    int* quotient) noexcept(number<Raw, Point, Rules>::divide_never_throws) {
  return detail::nearest_remainder_in("remquo", x, y, quotient);
}

/// The remainder of remquo().
///
///     static_assert(remainder(q16_16(9.5), q16_16(2)) == q16_16(-0.5));
template <class Raw, int Point, policy Rules>
requires(std::is_signed_v<Raw>) [[nodiscard]] constexpr number<Raw, Point, Rules> remainder(
    number<Raw, Point, Rules> x,
    number<Raw, Point, Rules> y) noexcept(number<Raw, Point, Rules>::divide_never_throws) {
  int quotient = 0;
  return detail::nearest_remainder_in("remainder", x, y, &quotient);
}

/// The fraction of x, with the sign of x. Sets *whole to trunc(x).
///
///     q16_16 whole;
///     const q16_16 rest = modf(q16_16(-12.25), &whole);  // -0.25, and whole is -12
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> modf(
    number<Raw, Point, Rules> x,
    number<Raw, Point, Rules>* whole) noexcept(number<Raw, Point, Rules>::never_throws) {
  *whole = trunc(x);
  return x - *whole;
}

/// The nearest whole number; ties go to the even one. The policy handles overflow.
///
///     static_assert(rint(q16_16(2.5)) == 2 && rint(q16_16(3.5)) == 4);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> rint(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::whole<rounding::half_even>(x, "rint");
}
/// rint(x).
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> nearbyint(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return rint(x);
}

/// x with the sign of `sign`; 0 counts as positive. The policy handles overflow, as in -x. Unsigned
/// numbers are unchanged.
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> copysign(
    number<Raw, Point, Rules> x,
    number<Raw, Point, Rules> sign) noexcept(number<Raw, Point, Rules>::never_throws) {
  return (x.raw() < 0) == (sign.raw() < 0) || x.raw() == 0 ? x : -x;
}

/// The number next to `from` in the direction of `toward`; `from` if they are equal.
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> nextafter(
    number<Raw, Point, Rules> from, number<Raw, Point, Rules> toward) noexcept {
  if (from == toward) return from;
  const int step = from < toward ? 1 : -1;
  return number<Raw, Point, Rules>::from_raw(static_cast<Raw>(from.raw() + static_cast<Raw>(step)));
}
/// nextafter(from, toward).
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> nexttoward(
    number<Raw, Point, Rules> from, number<Raw, Point, Rules> toward) noexcept {
  return nextafter(from, toward);
}

/// Whether x is negative.
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr bool(signbit)(number<Raw, Point, Rules> x) noexcept {
  return x.raw() < 0;
}
/// True: there are no infinities and no NaN.
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr bool(isfinite)(number<Raw, Point, Rules> /*x*/) noexcept {
  return true;
}
/// False.
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr bool(isinf)(number<Raw, Point, Rules> /*x*/) noexcept {
  return false;
}
/// False.
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr bool(isnan)(number<Raw, Point, Rules> /*x*/) noexcept {
  return false;
}
/// Whether x is not 0: every other number has the same precision.
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr bool(isnormal)(number<Raw, Point, Rules> x) noexcept {
  return x.raw() != 0;
}

/// @cond
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): declares functions
#define FIXED_NEEDS_SIGN(name)                                                                  \
  template <std::unsigned_integral Raw, int Point, policy Rules, class... Last>                 \
  number<Raw, Point, Rules> name(number<Raw, Point, Rules>, number<Raw, Point, Rules>, Last...) \
      FIXED_INSTEAD("a remainder can be negative: convert to a signed format, as in q48_16(x)");
FIXED_NEEDS_SIGN(remainder)
FIXED_NEEDS_SIGN(remquo)
#undef FIXED_NEEDS_SIGN
FIXED_REFUSED_MIX(fmod)
FIXED_REFUSED_MIX(remainder)
/// @endcond

}  // namespace fixproof

/// @file
/// Exponentials, logarithms, hyperbolic functions and their inverses, rounded to nearest, in every
/// format; docs/functions.md says what was compared.
///
/// Each result is the number nearest to the exact value, or a bound of it under policy::functions.
/// Only exp2 has ties. If the policy rounds products to nearest, ties follow that rule; otherwise
/// they go up. A result out of range throws an overflow_error under overflow::trap. Under every
/// other policy it saturates, because a logarithm or an exponential modulo 2^32 means nothing.
///
/// Inverse hyperbolic functions, exp10 and all functions in formats of more than 32 bits compute
/// with intervals (fixed/detail/interval_exponential.hpp).
#pragma once

#include <cstdint>
#include <limits>

#include "fixed/detail/function_kinds.hpp"
#include "fixed/detail/instead.hpp"
#include "fixed/detail/interval_exponential.hpp"
#include "fixed/detail/limited.hpp"
#include "fixed/detail/operands.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/detail/variant.hpp"
#include "fixed/number.hpp"

#if defined(FIXED_SMALL)
#include "fixed/detail/digit_exponential.hpp"
#else
#include "fixed/detail/exponential.hpp"
#include "fixed/detail/hyperbolic.hpp"
#endif

namespace fixproof {

namespace detail::FIXED_FUNCTIONS {

/// The operand in units of 2^-32, limited to +-64. Beyond that, every result is out of range or
/// constant.
template <class Number>
constexpr std::int64_t exponent_units(Number x) noexcept {
  constexpr std::int64_t limit = std::int64_t{64} << Number::fraction_bits;
  const std::int64_t raw{x.raw()};
  return (raw < -limit  ? -limit
          : raw > limit ? limit
                        : raw) *
         (std::int64_t{1} << (32 - Number::fraction_bits));
}

/// The exponential of x as a To, less `less`, which is 0 or 1.
template <exponential_base Base, class To, class Number>
constexpr To exponential(Number x, int less, const char* function) noexcept(To::never_throws) {
  if constexpr (Base == exponential_base::ten || needs_intervals<To, Number>) {
    return limited<To>(interval_exponential<Base, rounding_of<To>>(real_operand_of(x), less != 0,
                                                                   To::fraction_bits),
                       function, x);
  } else {
    return limited<To>(
        nearest_exponential<Base, rounding_of<To>>(exponent_units(x), To::fraction_bits) -
            (std::int64_t{less} << To::fraction_bits),
        function, x);
  }
}

/// The logarithm of x plus `more`, which is 0 or 1, as a To.
template <logarithm_base Base, class To, class Number>
constexpr To logarithm(Number x, int more, const char* function) noexcept(To::never_throws) {
  using limits = std::numeric_limits<typename To::raw_type>;
  if constexpr (needs_intervals<To, Number>) {
    const real_operand operand = real_operand_of(x);
    // Of a negative number, only the fraction is above -1.
    const bool is_outside = operand.magnitude == 0 ? more == 0
                            : operand.is_negative  ? more == 0 || operand.whole() != 0
                                                   : false;
    if (is_outside) return outside_domain<To>((limits::min)(), function, x);
    return limited<To>(
        interval_logarithm<Base, rounding_of<To>>(operand, more != 0, To::fraction_bits), function,
        x);
  } else {
    const std::int64_t sum = x.raw() + (std::int64_t{more} << Number::fraction_bits);
    if (sum <= 0) return outside_domain<To>((limits::min)(), function, x);
    return limited<To>(nearest_logarithm<Base>(static_cast<std::uint64_t>(sum),
                                               Number::fraction_bits, To::fraction_bits),
                       function, x);
  }
}
/// sinh or cosh of x, as a To.
template <hyperbola Function, class To, class Number>
constexpr To hyperbolic(Number x, const char* function) noexcept(To::never_throws) {
  if constexpr (needs_intervals<To, Number>) {
    return limited<To>(
        interval_hyperbolic<Function, rounding_of<To>>(real_operand_of(x), To::fraction_bits),
        function, x);
  } else {
    const std::int64_t units = exponent_units(x);
    const std::int64_t ulps =
        nearest_hyperbolic<Function>(units < 0 ? -units : units, To::fraction_bits);
    return limited<To>(Function == hyperbola::sine && units < 0 ? -ulps : ulps, function, x);
  }
}

/// tanh of x, as a To.
template <class To, class Number>
constexpr To hyperbolic_tangent(Number x) noexcept(To::never_throws) {
  if constexpr (needs_intervals<To, Number>) {
    return limited<To>(
        interval_hyperbolic_tangent<rounding_of<To>>(real_operand_of(x), To::fraction_bits), "tanh",
        x);
  } else {
    const std::int64_t units = exponent_units(x);
    const std::int64_t ulps =
        nearest_hyperbolic_tangent(units < 0 ? -units : units, To::fraction_bits);
    return limited<To>(units < 0 ? -ulps : ulps, "tanh", x);
  }
}

/// asinh or acosh of x, as a To. acosh of a number below 1 is 0, or a domain_error.
template <hyperbola Function, class To, class Number>
constexpr To inverse_hyperbolic(Number x, const char* function) noexcept(To::never_throws) {
  const real_operand operand = real_operand_of(x);
  if (Function == hyperbola::cosine && (operand.is_negative || operand.whole() == 0)) {
    return outside_domain<To>(0, function, x);
  }
  return limited<To>(
      interval_inverse_hyperbolic<Function, rounding_of<To>>(operand, To::fraction_bits), function,
      x);
}

/// atanh of x, as a To; 0 for |x| >= 1, or a domain_error.
template <class To, class Number>
constexpr To inverse_hyperbolic_tangent(Number x) noexcept(To::never_throws) {
  const real_operand operand = real_operand_of(x);
  if (operand.whole() != 0) return outside_domain<To>(0, "atanh", x);
  return limited<To>(
      interval_inverse_hyperbolic_tangent<rounding_of<To>>(operand, To::fraction_bits), "atanh", x);
}

}  // namespace detail::FIXED_FUNCTIONS

inline namespace FIXED_FUNCTIONS {

/// 2 to the power of x.
///
///     static_assert(exp2(q16_16(0.5)).raw() == 92682 && exp2(q16_16(-3)) == q16_16(0.125));
///     static_assert(exp2(q16_16(15)) == std::numeric_limits<q16_16>::max());  // out of range
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> exp2(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::exponential<detail::exponential_base::two,
                                              number<Raw, Point, Rules>>(x, 0, "exp2");
}

/// e to the power of x.
///
///     static_assert(exp(q16_16(1)).raw() == 178145 && exp(q16_16()) == 1);  // 178145.3
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> exp(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::exponential<detail::exponential_base::e,
                                              number<Raw, Point, Rules>>(x, 0, "exp");
}

/// e to the power of x, minus 1.
///
///     static_assert(expm1(q2_30(-1)).raw() == -678734282);  // -678734281.8
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> expm1(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::exponential<detail::exponential_base::e,
                                              number<Raw, Point, Rules>>(x, 1, "expm1");
}

/// The natural logarithm. For x <= 0 it throws a domain_error under overflow::trap, and is the
/// lowest number of the type under every other policy.
///
///     static_assert(log(q16_16(10)).raw() == 150902);  // 150902.2
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> log(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::logarithm<detail::logarithm_base::e, number<Raw, Point, Rules>>(
      x, 0, "log");
}

/// The natural logarithm of 1 + x. For x <= -1, see log().
///
///     static_assert(log1p(q16_16(9)) == log(q16_16(10)));
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> log1p(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::logarithm<detail::logarithm_base::e, number<Raw, Point, Rules>>(
      x, 1, "log1p");
}

/// The logarithm to base 2. For x <= 0, see log().
///
///     static_assert(log2(q16_16(0.125)) == -3);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> log2(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::logarithm<detail::logarithm_base::two, number<Raw, Point, Rules>>(
      x, 0, "log2");
}

/// The logarithm to base 10. For x <= 0, see log().
///
///     static_assert(log10(q16_16(1000)) == 3);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> log10(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::logarithm<detail::logarithm_base::ten, number<Raw, Point, Rules>>(
      x, 0, "log10");
}

/// The hyperbolic sine, (e^x - e^-x) / 2.
///
///     static_assert(sinh(q16_16(-1)).raw() == -77018);  // -77017.99
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> sinh(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::hyperbolic<detail::hyperbola::sine, number<Raw, Point, Rules>>(
      x, "sinh");
}

/// The hyperbolic cosine, (e^x + e^-x) / 2.
///
///     static_assert(cosh(q16_16(1)).raw() == 101127);  // 101127.3
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> cosh(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::hyperbolic<detail::hyperbola::cosine, number<Raw, Point, Rules>>(
      x, "cosh");
}

/// The hyperbolic tangent, sinh(x) / cosh(x).
///
///     static_assert(tanh(q16_16(1)).raw() == 49912);  // 49911.8
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> tanh(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::hyperbolic_tangent<number<Raw, Point, Rules>>(x);
}

/// 10 to the power of x.
///
///     static_assert(exp10(q16_16(-1)).raw() == 6554 && exp10(q16_16(3)) == 1000);  // 6553.6
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> exp10(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::exponential<detail::exponential_base::ten,
                                              number<Raw, Point, Rules>>(x, 0, "exp10");
}

/// The number whose hyperbolic sine is x.
///
///     static_assert(asinh(q16_16(-1)).raw() == -57762);  // -57761.7
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> asinh(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::inverse_hyperbolic<detail::hyperbola::sine,
                                                     number<Raw, Point, Rules>>(x, "asinh");
}

/// The number from 0 on whose hyperbolic cosine is x. For x < 1 it throws a domain_error under
/// overflow::trap, and is 0 under every other policy.
///
///     static_assert(acosh(q16_16(2)).raw() == 86308);  // 86307.9
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> acosh(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::inverse_hyperbolic<detail::hyperbola::cosine,
                                                     number<Raw, Point, Rules>>(x, "acosh");
}

/// The number whose hyperbolic tangent is x. For |x| >= 1 it throws a domain_error under
/// overflow::trap, and is 0 under every other policy.
///
///     static_assert(atanh(q16_16(0.5)).raw() == 35999);  // 35999.2
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> atanh(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::inverse_hyperbolic_tangent<number<Raw, Point, Rules>>(x);
}

/// @cond
FIXED_REFUSED_PLAIN(exp)
FIXED_REFUSED_PLAIN(exp2)
FIXED_REFUSED_PLAIN(expm1)
FIXED_REFUSED_PLAIN(log)
FIXED_REFUSED_PLAIN(log2)
FIXED_REFUSED_PLAIN(log10)
FIXED_REFUSED_PLAIN(log1p)
FIXED_REFUSED_PLAIN(sinh)
FIXED_REFUSED_PLAIN(cosh)
FIXED_REFUSED_PLAIN(tanh)
FIXED_REFUSED_PLAIN(exp10)
FIXED_REFUSED_PLAIN(asinh)
FIXED_REFUSED_PLAIN(acosh)
FIXED_REFUSED_PLAIN(atanh)
/// @endcond

}  // namespace FIXED_FUNCTIONS
}  // namespace fixproof

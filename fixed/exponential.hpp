/// \file
/// Exponentials and logarithms, correctly rounded for every operand of every format of at most 32
/// bits.
///
/// Each result is the number nearest to the exact value, under every policy. A tie, which only exp2
/// has, is rounded as the policy rounds products if that is to nearest, and up otherwise. A result
/// out of range throws an overflow_error under overflow::trap; under every other policy it
/// saturates, because a logarithm or an exponential modulo 2^32 means nothing.
///
/// fixed.hpp does not include this header.
#pragma once

#include <cstdint>
#include <limits>

#include "fixed/detail/exponential.hpp"
#include "fixed/detail/overflow.hpp"
#include "fixed/detail/raise.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/number.hpp"

namespace fixproof {

namespace detail {

/// The number of ulps as a number, or the nearest limit of its range.
template <class Number>
constexpr Number limited(std::int64_t ulps, const char* function,
                         Number x) noexcept(Number::never_throws) {
  using raw = typename Number::raw_type;
  constexpr overflow range =
      Number::rules.range == overflow::trap ? overflow::trap : overflow::saturate;
  return Number::from_raw(
      narrow<range, raw>(ulps, [&] { raise_overflow<Number::fraction_bits>(function, x.raw()); }));
}

template <exponential_base Base, class Number>
constexpr Number exponential(Number x, const char* function) noexcept(Number::never_throws) {
  static_assert(bits_of<typename Number::raw_type> <= 32,
                "exp and exp2 need a format of at most 32 bits: convert, as in exp(q16_16(x))");
  constexpr rounding ties =
      is_to_nearest<Number::rules.multiply> ? Number::rules.multiply : rounding::half_up;
  // Beyond 64, every result is out of range or rounds to zero.
  constexpr std::int64_t limit = std::int64_t{64} << Number::fraction_bits;
  const std::int64_t raw{x.raw()};
  const std::int64_t clamped = raw < -limit ? -limit : raw > limit ? limit : raw;
  return limited(nearest_exponential<Base, ties, Number::fraction_bits>(
                     clamped * (std::int64_t{1} << (32 - Number::fraction_bits))),
                 function, x);
}

template <logarithm_base Base, class Number>
constexpr Number logarithm(Number x, const char* function) noexcept(Number::never_throws) {
  using raw = typename Number::raw_type;
  static_assert(bits_of<raw> <= 32,
                "log, log2 and log10 need a format of at most 32 bits: convert, as in "
                "log(q16_16(x))");
  if (x.raw() <= 0) {
    if constexpr (Number::rules.range == overflow::trap) {
      raise<domain_error>("domain error", function, operand<raw, Number::fraction_bits>{x.raw()});
    }
    return Number::from_raw((std::numeric_limits<raw>::min)());
  }
  return limited(
      nearest_logarithm<Base, Number::fraction_bits>(static_cast<std::uint32_t>(x.raw())), function,
      x);
}

}  // namespace detail

/// 2 to the power of x.
///
///     static_assert(exp2(q16_16(0.5)).raw() == 92682 && exp2(q16_16(-3)) == q16_16(0.125));
///     static_assert(exp2(q16_16(15)) == std::numeric_limits<q16_16>::max());  // out of range
template <class Raw, int F, policy P>
[[nodiscard]] constexpr number<Raw, F, P> exp2(number<Raw, F, P> x) noexcept(
    number<Raw, F, P>::never_throws) {
  return detail::exponential<detail::exponential_base::two>(x, "exp2");
}

/// e to the power of x.
///
///     static_assert(exp(q16_16(1)).raw() == 178145 && exp(q16_16()) == 1);  // 178145.3
template <class Raw, int F, policy P>
[[nodiscard]] constexpr number<Raw, F, P> exp(number<Raw, F, P> x) noexcept(
    number<Raw, F, P>::never_throws) {
  return detail::exponential<detail::exponential_base::e>(x, "exp");
}

/// The natural logarithm. Unless x > 0 it throws a domain_error under overflow::trap, and is the
/// lowest number of the type under every other policy.
///
///     static_assert(log(q16_16(10)).raw() == 150902);  // 150902.2
template <class Raw, int F, policy P>
[[nodiscard]] constexpr number<Raw, F, P> log(number<Raw, F, P> x) noexcept(
    number<Raw, F, P>::never_throws) {
  return detail::logarithm<detail::logarithm_base::e>(x, "log");
}

/// The logarithm to base 2. Unless x > 0, as log().
///
///     static_assert(log2(q16_16(0.125)) == -3);
template <class Raw, int F, policy P>
[[nodiscard]] constexpr number<Raw, F, P> log2(number<Raw, F, P> x) noexcept(
    number<Raw, F, P>::never_throws) {
  return detail::logarithm<detail::logarithm_base::two>(x, "log2");
}

/// The logarithm to base 10. Unless x > 0, as log().
///
///     static_assert(log10(q16_16(1000)) == 3);
template <class Raw, int F, policy P>
[[nodiscard]] constexpr number<Raw, F, P> log10(number<Raw, F, P> x) noexcept(
    number<Raw, F, P>::never_throws) {
  return detail::logarithm<detail::logarithm_base::ten>(x, "log10");
}

}  // namespace fixproof

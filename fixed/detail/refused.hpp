/// @file
/// Operators that do not compile, functions of <cmath> that the type does not have, and what to write instead.
#pragma once

#include <concepts>
#include <type_traits>

#include "fixed/detail/instead.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/number.hpp"

namespace fixproof {

namespace detail {

/// Arithmetic types that do not mix with numbers: floating point, bool and the character types.
template <class T>
concept foreign = std::is_arithmetic_v<T> && !integer<T>;

}  // namespace detail

/// @cond
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): declares operators
#define FIXED_REFUSED_OPERATOR(op, formats)                                                   \
  template <class A, int FA, policy PA, class B, int FB, policy PB>                           \
  number<A, FA, PA> operator op(number<A, FA, PA>, number<B, FB, PB>) FIXED_INSTEAD(formats); \
  template <class Raw, int F, policy P, detail::foreign T>                                    \
  number<Raw, F, P> operator op(number<Raw, F, P>, T)                                         \
      FIXED_INSTEAD("only integers mix with numbers: convert, as in x " #op " q16_16(0.5)");  \
  template <detail::foreign T, class Raw, int F, policy P>                                    \
  number<Raw, F, P> operator op(T, number<Raw, F, P>)                                         \
      FIXED_INSTEAD("only integers mix with numbers: convert, as in q16_16(0.5) " #op " x");
FIXED_REFUSED_OPERATOR(+, "formats do not mix: name the result, as in add<q16_16>(a, b)")
FIXED_REFUSED_OPERATOR(-, "formats do not mix: name the result, as in subtract<q16_16>(a, b)")
FIXED_REFUSED_OPERATOR(*, "formats do not mix: name the result, as in multiply<q16_16>(a, b)")
FIXED_REFUSED_OPERATOR(/, "formats do not mix: name the result, as in divide<q16_16>(a, b)")
FIXED_REFUSED_OPERATOR(%, "formats do not mix: convert one, as in a % q16_16(b)")
FIXED_REFUSED_OPERATOR(==, "formats do not compare: convert one, as in a == q16_16(b)")
FIXED_REFUSED_OPERATOR(<=>, "formats do not compare: convert one, as in a < q16_16(b)")
#undef FIXED_REFUSED_OPERATOR

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): likewise
#define FIXED_REFUSED_BITS(op)                        \
  template <class Raw, int F, policy P, class T>      \
  number<Raw, F, P> operator op(number<Raw, F, P>, T) \
      FIXED_INSTEAD("bits are those of the stored integer: from_raw(x.raw() " #op " mask)");
FIXED_REFUSED_BITS(&)
FIXED_REFUSED_BITS(|)
FIXED_REFUSED_BITS(^)
#undef FIXED_REFUSED_BITS

template <class Raw, int F, policy P>
number<Raw, F, P> operator~(number<Raw, F, P>)
    FIXED_INSTEAD("bits are those of the stored integer: from_raw(~x.raw())");

template <detail::integer Int, class Raw, int F, policy P>
number<Raw, F, P> operator/(Int, number<Raw, F, P>)
    FIXED_INSTEAD("an integer cannot be divided by a number: write q16_16(1) / x");

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): likewise
#define FIXED_REFUSED_SHIFT(op)                                                    \
  template <class Raw, int F, policy P, class T>                                   \
  requires(std::floating_point<T> || detail::is_plain_number<T>) number<Raw, F, P> \
  operator op(number<Raw, F, P>, T)                                                \
      FIXED_INSTEAD("a shift counts whole places: x " #op " static_cast<int>(n)");
FIXED_REFUSED_SHIFT(<<)
FIXED_REFUSED_SHIFT(>>)
#undef FIXED_REFUSED_SHIFT

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): declares a function. One of the user's is a better
// match, because it has no pack.
#define FIXED_ABSENT(name, text)                      \
  template <class N, class... T>                      \
  requires detail::is_plain_number<N> N name(N, T...) \
  FIXED_INSTEAD(text);
FIXED_ABSENT(acosh, "no acosh: write log(x + sqrt(x * x - 1))")
FIXED_ABSENT(asinh, "no asinh: write log(x + hypot(x, q16_16(1))) for x >= 0")
FIXED_ABSENT(atanh, "no atanh: write (log1p(x) - log1p(-x)) / 2")
FIXED_ABSENT(exp10, "no exp10: write pow(q16_16(10), x)")
FIXED_ABSENT(fabs, "no fabs: write abs(x)")
FIXED_ABSENT(fdim, "no fdim: write max(x, y) - y")
FIXED_ABSENT(fma, "no fma: write mul_add(a, b, c), which rounds once, too")
FIXED_ABSENT(fmax, "no fmax: write max(x, y)")
FIXED_ABSENT(fmin, "no fmin: write min(x, y)")
FIXED_ABSENT(ilogb, "no ilogb: write std::bit_width of the positive x.raw(), - 1 - fraction_bits")
FIXED_ABSENT(ldexp, "no ldexp: write x << n, which rounds down if n is negative")
FIXED_ABSENT(llrint, "no llrint: write to_integer<rounding::half_even>(x)")
FIXED_ABSENT(llround, "no llround: write to_integer<rounding::half_away>(x)")
FIXED_ABSENT(logb, "no logb: write std::bit_width of the positive x.raw(), - 1 - fraction_bits")
FIXED_ABSENT(lrint, "no lrint: write to_integer<rounding::half_even>(x)")
FIXED_ABSENT(lround, "no lround: write to_integer<rounding::half_away>(x)")
FIXED_ABSENT(scalbln, "no scalbln: write x << n, which rounds down if n is negative")
FIXED_ABSENT(scalbn, "no scalbn: write x << n, which rounds down if n is negative")
#undef FIXED_ABSENT
/// @endcond

}  // namespace fixproof

/// @file
/// Operators that do not compile, functions of <cmath> that the type does not have, and what to
/// write instead.
#pragma once

#include <concepts>
#include <type_traits>

#include "fixed/detail/instead.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/number.hpp"

namespace fixproof {

namespace detail {

/// Whether the type is a number of any format and policy.
template <class Type>
inline constexpr bool is_plain_number = false;
template <class Raw, int Point, policy Rules>
inline constexpr bool is_plain_number<number<Raw, Point, Rules>> = true;

/// Arithmetic types that do not mix with numbers: floating point, bool and the character types.
template <class Type>
concept foreign = std::is_arithmetic_v<Type> && !integer<Type>;

}  // namespace detail

/// @cond
// An integer beside a number, while code is moved. NOLINTNEXTLINE(cppcoreguidelines-macro-usage)
#define FIXED_REFUSED_INTEGER(op, sign)                                                 \
  template <class Raw, int Point, policy Rules, detail::integer Int>                    \
  requires(Rules.moving) number<Raw, Point, Rules>                                      \
  operator op(number<Raw, Point, Rules>, Int)                                           \
      FIXED_INSTEAD("policy::moving: write x.raw() " sign " n, or x " sign              \
                    " N::from_raw(n), or for a value x " sign " N(2_q16_16)");          \
  template <detail::integer Int, class Raw, int Point, policy Rules>                    \
  requires(Rules.moving) number<Raw, Point, Rules>                                      \
  operator op(Int, number<Raw, Point, Rules>)                                           \
      FIXED_INSTEAD("policy::moving: write n " sign " x.raw(), or N::from_raw(n) " sign \
                    " x, or for a value N(2_q16_16) " sign " x");
FIXED_REFUSED_INTEGER(+, "+")
FIXED_REFUSED_INTEGER(-, "-")
FIXED_REFUSED_INTEGER(*, "*")
FIXED_REFUSED_INTEGER(/, "/")
FIXED_REFUSED_INTEGER(%, "%")
FIXED_REFUSED_INTEGER(==, "==")
FIXED_REFUSED_INTEGER(<=>, "<")
#undef FIXED_REFUSED_INTEGER

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): declares operators
#define FIXED_REFUSED_OPERATOR(op, formats)                                                  \
  template <class RawA, int FA, policy PA, class RawB, int FB, policy PB>                    \
  number<RawA, FA, PA> operator op(number<RawA, FA, PA>, number<RawB, FB, PB>)               \
      FIXED_INSTEAD(formats);                                                                \
  template <class Raw, int Point, policy Rules, detail::foreign Type>                        \
  number<Raw, Point, Rules> operator op(number<Raw, Point, Rules>, Type)                     \
      FIXED_INSTEAD("only integers mix with numbers: convert, as in x " #op " q16_16(0.5)"); \
  template <detail::foreign Type, class Raw, int Point, policy Rules>                        \
  number<Raw, Point, Rules> operator op(Type, number<Raw, Point, Rules>)                     \
      FIXED_INSTEAD("only integers mix with numbers: convert, as in q16_16(0.5) " #op " x");
FIXED_REFUSED_OPERATOR(+, "formats do not mix: name the result, as in add<q16_16>(a, b)")
FIXED_REFUSED_OPERATOR(-, "formats do not mix: name the result, as in subtract<q16_16>(a, b)")
FIXED_REFUSED_OPERATOR(*, "formats do not mix: name the result, as in multiply<q16_16>(a, b)")
FIXED_REFUSED_OPERATOR(/, "formats do not mix: name the result, as in divide<q16_16>(a, b)")
FIXED_REFUSED_OPERATOR(
    %, "formats do not mix: convert to one that has both, as in q48_16(a) % q48_16(b)")
FIXED_REFUSED_OPERATOR(
    ==, "formats do not compare: convert to one that has both, as in q48_16(a) == q48_16(b)")
FIXED_REFUSED_OPERATOR(
    <=>, "formats do not compare: convert to one that has both, as in q48_16(a) < q48_16(b)")
#undef FIXED_REFUSED_OPERATOR

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): likewise
#define FIXED_REFUSED_BITS(op)                                           \
  template <class Raw, int Point, policy Rules, class Type>              \
  number<Raw, Point, Rules> operator op(number<Raw, Point, Rules>, Type) \
      FIXED_INSTEAD("bits are those of the stored integer: from_raw(x.raw() " #op " mask)");
FIXED_REFUSED_BITS(&)
FIXED_REFUSED_BITS(|)
FIXED_REFUSED_BITS(^)
#undef FIXED_REFUSED_BITS

template <class Raw, int Point, policy Rules>
number<Raw, Point, Rules> operator~(number<Raw, Point, Rules>)
    FIXED_INSTEAD("bits are those of the stored integer: from_raw(~x.raw())");

template <detail::integer Int, class Raw, int Point, policy Rules>
requires(!Rules.moving) number<Raw, Point, Rules>
operator/(Int, number<Raw, Point, Rules>)
    FIXED_INSTEAD("an integer cannot be divided by a number: write q16_16(1) / x");

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): likewise
#define FIXED_REFUSED_SHIFT(op)                                                                  \
  template <class Raw, int Point, policy Rules, class Type>                                      \
  requires(std::floating_point<Type> || detail::is_plain_number<Type>) number<Raw, Point, Rules> \
  operator op(number<Raw, Point, Rules>, Type)                                                   \
      FIXED_INSTEAD("a shift counts whole places: x " #op " static_cast<int>(n)");
FIXED_REFUSED_SHIFT(<<)
FIXED_REFUSED_SHIFT(>>)
#undef FIXED_REFUSED_SHIFT

// One of the user's is a better match, because it has no pack.
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): declares a function
#define FIXED_ABSENT(name, text)                                        \
  template <class Number, class... Type>                                \
  requires detail::is_plain_number<Number> Number name(Number, Type...) \
  FIXED_INSTEAD(text);
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

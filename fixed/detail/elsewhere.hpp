/// @file
/// Functions of numbers that fixed/fixed.hpp does not have, and where they are or what to write
/// instead. Any other function that takes these operands is a better match, because it has no pack:
/// that of the other header, or one of the user's.
#pragma once

#include "fixed/detail/instead.hpp"
#include "fixed/detail/operands.hpp"
#include "fixed/number.hpp"

namespace fixproof {

/// @cond
// NOLINTBEGIN(cppcoreguidelines-macro-usage): declare functions
#define FIXED_REFUSED_NUMBER(name, text)              \
  template <class N, class... T>                      \
  requires detail::is_plain_number<N> N name(N, T...) \
  FIXED_INSTEAD(text);
#define FIXED_ELSEWHERE(header, name) \
  FIXED_REFUSED_NUMBER(name, #name ": include fixed/" #header ".hpp")
// NOLINTEND(cppcoreguidelines-macro-usage)
FIXED_ELSEWHERE(angle, acos)
FIXED_ELSEWHERE(angle, asin)
FIXED_ELSEWHERE(angle, atan)
FIXED_ELSEWHERE(angle, atan2)
FIXED_ELSEWHERE(exponential, cosh)
FIXED_ELSEWHERE(exponential, exp)
FIXED_ELSEWHERE(exponential, exp2)
FIXED_ELSEWHERE(exponential, expm1)
FIXED_ELSEWHERE(exponential, log)
FIXED_ELSEWHERE(exponential, log10)
FIXED_ELSEWHERE(exponential, log1p)
FIXED_ELSEWHERE(exponential, log2)
FIXED_ELSEWHERE(exponential, sinh)
FIXED_ELSEWHERE(exponential, tanh)
FIXED_ELSEWHERE(power, cbrt)
FIXED_ELSEWHERE(power, hypot)
FIXED_ELSEWHERE(power, pow)
FIXED_ELSEWHERE(power, reciprocal)
FIXED_ELSEWHERE(power, rsqrt)
FIXED_ELSEWHERE(trigonometry, cos)
FIXED_ELSEWHERE(trigonometry, cos_of_degrees)
FIXED_ELSEWHERE(trigonometry, cos_of_turns)
FIXED_ELSEWHERE(trigonometry, sin)
FIXED_ELSEWHERE(trigonometry, sin_cos)
FIXED_ELSEWHERE(trigonometry, sin_cos_of_degrees)
FIXED_ELSEWHERE(trigonometry, sin_cos_of_turns)
FIXED_ELSEWHERE(trigonometry, sin_of_degrees)
FIXED_ELSEWHERE(trigonometry, sin_of_turns)
FIXED_ELSEWHERE(trigonometry, tan)
FIXED_ELSEWHERE(trigonometry, tan_of_degrees)
FIXED_ELSEWHERE(trigonometry, tan_of_turns)
FIXED_REFUSED_NUMBER(acosh, "no acosh: write log(x + sqrt(x * x - 1))")
FIXED_REFUSED_NUMBER(asinh, "no asinh: write log(x + hypot(x, q16_16(1))) for x >= 0")
FIXED_REFUSED_NUMBER(atanh, "no atanh: write (log1p(x) - log1p(-x)) / 2")
FIXED_REFUSED_NUMBER(exp10, "no exp10: write pow(q16_16(10), x)")
#undef FIXED_ELSEWHERE
#undef FIXED_REFUSED_NUMBER
/// @endcond

}  // namespace fixproof

/// \file
/// Whether this translation unit may use hardware doubles for exact integer work.
#pragma once

#include <cfloat>
#include <limits>

#if __STDC_HOSTED__
#include <cmath>
#endif

namespace fixproof::detail {

/// True if double is IEEE binary64 and the compiler evaluates it as written, without excess
/// precision, reciprocals or reassociation. If false, integers give the same bits, so translation
/// units may differ.
///
/// Define FIXED_NO_HARDWARE_DOUBLE for targets without a floating-point unit, and for flags that
/// loosen floating point without defining a macro (clang's -fassociative-math). -ffreestanding
/// implies it.
#if !__STDC_HOSTED__ || defined(FIXED_NO_HARDWARE_DOUBLE) || defined(__FAST_MATH__) ||      \
    defined(__RECIPROCAL_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) || \
    FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD > 1
constexpr bool hardware_double = false;
#else
constexpr bool hardware_double =
    std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53;
#endif

// Not called if hardware_double is false; freestanding libraries may lack them.
#if __STDC_HOSTED__
using std::copysign;
using std::sqrt;
#else
double copysign(double magnitude, double sign) noexcept;
double sqrt(double x) noexcept;
#endif

}  // namespace fixproof::detail

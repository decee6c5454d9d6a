/// \file
/// Whether this translation unit may do exact integer work in hardware doubles.
#pragma once

#include <cfloat>
#include <limits>

#if __STDC_HOSTED__
#include <cmath>
#endif

namespace fixed::detail {

/// True if double is IEEE binary64 and the compiler evaluates what is written: neither in a wider
/// format nor with reciprocals, reassociation or the like. Otherwise integers do the work; results
/// are the same, to the bit, so translation units may differ.
///
/// Define FIXED_NO_HARDWARE_DOUBLE on targets without a floating-point unit, and with flags that
/// loosen floating point but announce themselves by no macro (clang's -fassociative-math). Under
/// -ffreestanding it is as if defined.
#if !__STDC_HOSTED__ || defined(FIXED_NO_HARDWARE_DOUBLE) || defined(__FAST_MATH__) ||      \
    defined(__RECIPROCAL_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) || \
    FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD > 1
constexpr bool hardware_double = false;
#else
constexpr bool hardware_double =
    std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53;
#endif

// Where hardware_double is false nothing calls these two, and freestanding libraries need not have
// them.
#if __STDC_HOSTED__
using std::copysign;
using std::sqrt;
#else
double copysign(double magnitude, double sign) noexcept;
double sqrt(double x) noexcept;
#endif

}  // namespace fixed::detail

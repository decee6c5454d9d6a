/// @file
/// Whether this translation unit may use hardware doubles for exact integer work, and whether it
/// divides in them.
#pragma once

#include <cfloat>
#include <concepts>
#include <limits>

#include "fixed/detail/gpu.hpp"

#if defined(_MSC_VER) && !defined(__clang__)
#include <cmath>
#endif

namespace fixproof::detail {

// Defined where the compiler calls a function for each operation on doubles, as far as its macros
// tell: a processor without a floating-point unit, or with one for float alone. Bit 3 of __ARM_FP
// is that of double. GCC defines _SOFT_FLOAT on x86, PowerPC and SPARC. Code for a GPU counts as
// such, too: its compilers contract a product and a sum, which changes bits.
#if defined(FIXED_GPU)
#define FIXED_SOFT_DOUBLE
#elif defined(__arm__)
#if !defined(__ARM_FP) || !(__ARM_FP & 8)
#define FIXED_SOFT_DOUBLE
#endif
#elif defined(__riscv)
#if !defined(__riscv_flen) || __riscv_flen < 64
#define FIXED_SOFT_DOUBLE
#endif
#elif defined(__m68k__)
#if !defined(__HAVE_68881__) && !defined(__mcffpu__)
#define FIXED_SOFT_DOUBLE
#endif
#elif defined(__sh__)
#if !defined(__SH_FPU_DOUBLE__)
#define FIXED_SOFT_DOUBLE
#endif
#elif defined(__SOFTFP__) || defined(_SOFT_FLOAT) || defined(_SOFT_DOUBLE) ||                     \
    defined(__NO_FPRS__) || defined(__mips_soft_float) || defined(__mips_single_float) ||         \
    defined(__loongarch_soft_float) || defined(__loongarch_single_float) || defined(__AVR__) ||   \
    defined(__MSP430__) || defined(__RL78__) || defined(__XTENSA__) || defined(__MICROBLAZE__) || \
    defined(__nios2__) || defined(__arc__)
#define FIXED_SOFT_DOUBLE
#endif

/// True if the processor has double, double is IEEE binary64, and the compiler evaluates it as
/// written, without excess precision, reciprocals or reassociation. If false, integers give the
/// same bits, so translation units may differ.
///
/// Define FIXED_NO_HARDWARE_DOUBLE for a processor without double that the list above lacks, and
/// for flags that loosen floating point without defining a macro (clang's -fassociative-math).
/// -ffreestanding, FIXED_SMALL and FIXED_COMPACT imply it.
#if !__STDC_HOSTED__ || defined(FIXED_NO_HARDWARE_DOUBLE) || defined(FIXED_SOFT_DOUBLE) ||     \
    defined(__FAST_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__ASSOCIATIVE_MATH__) || \
    defined(_M_FP_FAST) || defined(FIXED_SMALL) || defined(FIXED_COMPACT) ||                   \
    FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD > 1
constexpr bool hardware_double = false;
#else
constexpr bool hardware_double =
    std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53;
#endif

/// Whether operator/ takes a quotient from a division of doubles instead of integers. Both give the
/// same bits. Integers wait 2.5 to 3 times less for a quotient, but compilers do not vectorise
/// them.
///
/// Define FIXED_DIVIDE_IN_DOUBLE as 1 or 0 to choose. Otherwise integers divide if registers have
/// 64 bits, except for the x86-64 processors whose 64-bit divider is slow: Intel's from Ivy Bridge
/// to Cooper Lake and AMD's last ones before Zen have FSGSBASE but no SHA instructions.
/// Code compiled for any x86-64 processor divides integers.
#if defined(FIXED_DIVIDE_IN_DOUBLE)
constexpr bool divides_in_double = hardware_double && (FIXED_DIVIDE_IN_DOUBLE) != 0;
#elif defined(__x86_64__) && defined(__FSGSBASE__) && !defined(__SHA__)
constexpr bool divides_in_double = hardware_double;
#else
constexpr bool divides_in_double = hardware_double && sizeof(void*) < sizeof(double);
#endif

/// Whether operator/ takes a quotient from divisions of 32 bits: processors without double and
/// without registers of 64 bits call a function of a kilobyte for each longer division.
constexpr bool divides_in_words = !hardware_double && sizeof(void*) < sizeof(double);

// The compiler's, because <cmath> takes a seventh of the time to compile fixed.hpp. Not called if
// hardware_double is false. constexpr, because clang++ lets code for a GPU name only such
// functions, even where it does not call them. Templates, because no root is constant.
template <std::same_as<double> Double>
constexpr Double copysign(Double magnitude, Double sign) noexcept {
#if defined(_MSC_VER) && !defined(__clang__)
  return std::copysign(magnitude, sign);
#else
  return __builtin_copysign(magnitude, sign);
#endif
}
template <std::same_as<double> Double>
constexpr Double sqrt(Double x) noexcept {
#if defined(_MSC_VER) && !defined(__clang__)
  return std::sqrt(x);
#else
  return __builtin_sqrt(x);
#endif
}

}  // namespace fixproof::detail

/// @file
/// Attributes that say what compilers inline. A batch of few numbers takes about as long as its
/// calls, and compilers do not know which loops run often. Without optimisation, an operator takes
/// about as long as the calls of its helpers.
#pragma once

#include "fixed/detail/standard.hpp"

#if defined(__GNUC__) || defined(__clang__)
#define FIXED_INLINE __attribute__((always_inline))
#define FIXED_ALWAYS_INLINE FIXED_INLINE inline
#define FIXED_NOINLINE __attribute__((noinline))
#elif defined(_MSC_VER)
#define FIXED_INLINE
#define FIXED_ALWAYS_INLINE __forceinline
#define FIXED_NOINLINE __declspec(noinline)
#else
#define FIXED_INLINE
#define FIXED_ALWAYS_INLINE inline
#define FIXED_NOINLINE
#endif

/// Inlined without optimisation; with it, the compiler decides, because some copies are large.
#if defined(__OPTIMIZE__)
#define FIXED_INLINE_UNOPTIMISED
#else
#define FIXED_INLINE_UNOPTIMISED FIXED_ALWAYS_INLINE
#endif

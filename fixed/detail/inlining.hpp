/// \file
/// Attributes that say what compilers inline. A batch of few numbers takes about as long as its
/// calls, and compilers do not know which loops run often. Without optimisation, an operator takes
/// about as long as the calls of its helpers.
#pragma once

#if defined(__GNUC__)
#define FIXED_INLINE __attribute__((always_inline))
#define FIXED_ALWAYS_INLINE FIXED_INLINE inline
#define FIXED_NOINLINE __attribute__((noinline))
#else
#define FIXED_INLINE
#define FIXED_ALWAYS_INLINE inline
#define FIXED_NOINLINE
#endif

namespace fixproof::detail {

/// Keeps a copy in memory, from which compilers load it after a call. Else they save a register for
/// it at the start of the function, on the way without the call, too.
template <class T>
FIXED_ALWAYS_INLINE void keep_in_memory([[maybe_unused]] T& copy) noexcept {
#if defined(__GNUC__)
  asm("" : "+m"(copy));
#endif
}

}  // namespace fixproof::detail

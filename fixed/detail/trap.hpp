/// @file
/// Ends the program where nothing else can.
#pragma once

#include "fixed/detail/gpu.hpp"
#include "fixed/detail/inlining.hpp"

namespace fixproof::detail {

/// Executes a trap instruction. No constant expression may reach it. A template, because no call of
/// it is constant.
template <class = void>
[[noreturn]] FIXED_ALWAYS_INLINE constexpr void trap() noexcept {
#if defined(FIXED_GPU) && defined(__NVCC__)
  // nvcc drops __builtin_trap(), and what leads to it.
  asm("trap;");
  __builtin_unreachable();
#elif defined(_MSC_VER) && !defined(__clang__)
  __fastfail(7);  // FAST_FAIL_FATAL_APP_EXIT
#else
  __builtin_trap();
#endif
}

}  // namespace fixproof::detail

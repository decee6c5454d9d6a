/// @file
/// Compiler-specific parts of the model. The compiled run needs forced inlining: the machine is
/// kept in processor registers only if every function on its path is inlined.
#pragma once

#define X86MODEL_INLINE [[gnu::always_inline]] inline constexpr

namespace x86model::detail {

/// Whether the compiler optimises for size (-Os, -Oz). Handlers for common operands are then left
/// out: they make the interpreter faster and two and a half times as large.
#ifdef __OPTIMIZE_SIZE__
inline constexpr bool prefers_small_code = true;
#else
inline constexpr bool prefers_small_code = false;
#endif

}  // namespace x86model::detail

/// @file
/// Forced inlining for the compiled run: the machine is kept in processor registers only if every
/// function on its path is inlined.
#pragma once

#define X86MODEL_INLINE [[gnu::always_inline]] inline constexpr

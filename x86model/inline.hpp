/// @file
/// Inlining that the compiled run depends on: only with every function on its path inlined at once
/// does a machine dissolve into processor registers.
#pragma once

#define X86MODEL_INLINE [[gnu::always_inline]] inline constexpr

/// @file
/// Frames that name types of C: `long, int32_t* -> int`.
#pragma once

#include <optional>

#include "judge/code/frame.hpp"

namespace fixproof::judge {

/// Reads a frame whose places are types of C, such as `long, long -> long`. A pointer and an array,
/// such as `int32_t[2]`, have the operands that are next; after the operands, they receive the
/// results. A number is what the routine gets in every call.
/// @param bits 16, 32 or 64, the width of a pointer: it decides that of `int` and `long`
/// @return nothing for a frame that names no type
/// @throws support::UsageError naming a place that is no type or does not fit the operation
std::optional<Signature> signature_in_c(const FrameText& text, const cases::Variant& variant,
                                        int bits);

}  // namespace fixproof::judge

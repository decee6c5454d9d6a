/// @file
/// Recognises code for another mode of the processor.
#pragma once

#include "judge/code/image.hpp"

namespace fixproof::judge {

/// Tells whether the routine looks like 64-bit code: the prefix 48h to 4Fh, which is DEC in other
/// code, precedes instructions that 64-bit compilers use all the time. Needs ndisasm.
/// @throws support::UsageError if ndisasm cannot be run
bool looks_like_64_bits(const Image& image);

}  // namespace fixproof::judge

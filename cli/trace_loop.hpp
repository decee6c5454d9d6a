/// @file
/// The instructions of an inner loop, and what each changes.
#pragma once

#include <string>
#include <vector>

#include "x86model/loop.hpp"

namespace fixproof::cli {

/// Prints the trace of a loop.
/// @param words hexadecimal: pixels, value and step; of a texture also row and step
/// @throws UsageError for another number of words, or of pixels
void trace_loop(const x86model::LoopForm& form, const std::vector<std::string>& words);

}  // namespace fixproof::cli

/// @file
/// Traces the instructions of an inner loop and their effects.
#pragma once

#include <string>
#include <vector>

#include "x86model/loop.hpp"

namespace fixproof::cli {

/// @param words hexadecimal: pixels, value and step; for a texture also row and row step
/// @throws UsageError if the number of words or pixels is wrong
void trace_loop(const x86model::LoopForm& form, const std::vector<std::string>& words);

}  // namespace fixproof::cli

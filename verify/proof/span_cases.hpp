/// @file
/// Generates spans for an inner loop and tests a program on them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "x86model/call_loop.hpp"
#include "x86model/loop.hpp"

namespace fixproof::proof {

/// Returns the spans for `seed`: one for every length from 1 to loops::max_pixels (only even
/// lengths for words, and also 0 for unrolled loops). Words, places and colours vary from span to
/// span.
std::vector<x86model::LoopCall> span_cases(const x86model::LoopForm& form, std::uint64_t seed);

/// Runs `program` over the spans in memory full of noise until it differs from the source's
/// description of the loop: in pixels, depths or any other memory, in the registers that a caller
/// uses next (the place, the stepped words, EBP, SP), or by reading an undefined flag.
/// @return the number of spans run, including the one that differs; nothing if none does
std::optional<std::uint64_t> spans_to_kill(const x86model::LoopForm& form,
                                           const x86model::Program& program, std::uint64_t seed);

}  // namespace fixproof::proof

/// @file
/// Spans to judge an inner loop by: what notices a mistake in it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "x86model/call_loop.hpp"
#include "x86model/loop.hpp"

namespace fixproof::proof {

/// The spans, for `seed`: every length from 1 to loops::max_pixels (of words the even ones, and of
/// unrolled loops 0 too), with words, places and colours that differ from span to span.
std::vector<x86model::LoopCall> span_cases(const x86model::LoopForm& form, std::uint64_t seed);

/// Runs `program` in the place of the loop over the spans, in memory full of noise, until one shows
/// that it does not do what the source says: pixels, depths and all other memory, the registers
/// that a caller goes on with (the place, the stepped words, EBP, SP), no undefined flag.
/// @return how many spans were run, that one included; nothing where none shows it
std::optional<std::uint64_t> spans_to_kill(const x86model::LoopForm& form,
                                           const x86model::Program& program, std::uint64_t seed);

}  // namespace fixproof::proof

/// @file
/// The parties that run machine code, and any code in the place of a routine's.
#pragma once

#include <cstdint>
#include <span>

#include "parties/party.hpp"
#include "x86model/routine.hpp"

namespace fixproof::parties {

/// Whether there is machine code for a variant in this build.
bool has_machine_code(const cases::Variant& variant);

/// Answers a batch by calls of `code`, which stands in for the routine: a listing of this project,
/// or what a test makes of one. Nothing limits how long a call may take, so that code which does
/// not end is not to be given: the listings end, on every path that there is (`fixproof prove`).
/// Processor::absence(), or Emulator::absence(), has to be empty.
void answer_on_silicon(std::span<const std::uint8_t> code, x86model::Routine routine,
                       const Batch& batch);
void answer_on_unicorn(std::span<const std::uint8_t> code, x86model::Routine routine,
                       const Batch& batch);

}  // namespace fixproof::parties

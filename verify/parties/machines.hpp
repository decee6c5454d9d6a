/// @file
/// The parties that run machine code, and functions that run other code in place of a routine.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "verify/parties/party.hpp"
#include "x86model/routine.hpp"

namespace fixproof::parties {

/// Tells whether this build has machine code for a variant.
bool has_machine_code(const cases::Variant& variant);

/// Returns the processor's name from the operating system; `unknown` if it has none.
std::string processor_name();

/// Answers cases by calling `code` in place of the routine. `code` must end, because nothing
/// limits the time of a call; the listings end on every path (`fixproof prove`).
/// Processor::absence() or Emulator::absence() must be empty.
void answer_on_silicon(std::span<const std::uint8_t> code, x86model::Routine routine,
                       const Cases& asked);
void answer_on_unicorn(std::span<const std::uint8_t> code, x86model::Routine routine,
                       const Cases& asked);

}  // namespace fixproof::parties

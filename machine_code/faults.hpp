/// @file
/// Faults of 16-bit code, taken from the system's signals.
#pragma once

#include <cstdint>

#include "machine_code/enter_segment.hpp"

namespace fixproof::machine_code {

/// Catches the faults of every thread's segment from now on, once for the process; a fault anywhere
/// else goes on to whoever caught it before.
/// @throws std::system_error where the system refuses
void catch_segment_faults();

/// fixproof_enter_segment(), with the faults of this thread's segment caught.
/// @return the signal of the fault that ended the call; 0 if it came back by itself
int call_segment(SegmentCall& call);

/// The selectors that 64-bit code runs with here.
std::uint16_t code_selector_of_64_bits();
std::uint16_t stack_selector_of_64_bits();

}  // namespace fixproof::machine_code

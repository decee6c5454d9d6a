/// @file
/// Conversion of the system's signals to faults of 16-bit code.
#pragma once

#include <cstdint>

#include "verify/machine_code/call_ending.hpp"
#include "verify/machine_code/enter_segment.hpp"

namespace fixproof::machine_code {

/// Installs the handlers for faults in every thread's segment, once per process. They pass any
/// other fault to the previous handler.
/// @throws std::system_error if the system rejects a handler
void catch_segment_faults();

/// Calls fixproof_enter_segment() and catches faults in this thread's segment.
CallEnding call_segment(SegmentCall& call);

std::uint16_t code_selector_of_64_bits();
std::uint16_t stack_selector_of_64_bits();

}  // namespace fixproof::machine_code

/// @file
/// The calling convention of machine code: the frame of x86model/call.hpp, in a segment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "verify/machine_code/segment.hpp"
#include "x86model/routine.hpp"

namespace fixproof::machine_code {

/// The enter(), leave() and fill_results_with_junk() of x86model/call.hpp for one routine.
struct Frame {
  void (*enter)(SegmentMachine& m, std::span<const std::uint32_t> in);
  void (*leave)(const SegmentMachine& m, std::span<std::uint32_t> out);
  /// Fills the results in memory with words that count up from `junk`.
  void (*fill_results_with_junk)(SegmentMachine& m, std::uint32_t junk);
};

Frame frame_of(x86model::Routine routine);

/// Fills all flags, all registers except SP and the place of the results with bits that differ
/// between calls, because a routine must not rely on them. `call` is the number of the call.
void scramble(SegmentMachine& m, const Frame& frame, std::uint64_t call);

/// Tells whether a routine has preserved the state its caller relies on: SP has its value from
/// before the push of the return address, and BP, SI and DI are unchanged. Their upper halves
/// count, because a 386 caller uses them.
bool kept_for_caller(const x86model::Registers<16>& entered, const x86model::Registers<16>& left);

}  // namespace fixproof::machine_code

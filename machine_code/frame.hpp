/// @file
/// How machine code is called: the frame of x86model/call.hpp, in a segment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "machine_code/segment.hpp"
#include "x86model/routine.hpp"

namespace fixproof::machine_code {

/// A routine's way of taking operands and giving results: enter(), leave() and
/// fill_results_with_junk() of x86model/call.hpp.
struct Frame {
  void (*enter)(SegmentMachine& m, std::span<const std::uint32_t> in);
  void (*leave)(const SegmentMachine& m, std::span<std::uint32_t> out);
  /// Puts words that count up from `junk` where results in memory are to come.
  void (*fill_results_with_junk)(SegmentMachine& m, std::uint32_t junk);
};

Frame frame_of(x86model::Routine routine);

/// Fills all flags, all registers but SP and the place of the results with bits that differ from
/// call to call: a routine may rely on none of them. `call` counts the calls.
void scramble(SegmentMachine& m, const Frame& frame, std::uint64_t call);

/// Whether a routine has kept what its caller relies on: SP is as it was before the return address
/// was pushed; BP, SI and DI are as before, with their upper halves, which a caller for the 386
/// uses.
bool kept_for_caller(const x86model::Registers<16>& entered, const x86model::Registers<16>& left);

}  // namespace fixproof::machine_code

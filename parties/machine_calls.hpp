/// @file
/// The calls of machine code that answer a batch, whichever machine makes them.
#pragma once

#include <cstddef>

#include "machine_code/call_ending.hpp"
#include "machine_code/frame.hpp"
#include "parties/party.hpp"

namespace fixproof::parties {

/// What happens before and after each call of a routine. Every call begins with other noise in
/// registers, flags and the place of the results, and is held to what a C caller relies on.
class MachineCalls {
 public:
  MachineCalls(x86model::Routine routine, const Batch& batch);

  /// Sets up case `i`.
  void enter(std::size_t i, machine_code::SegmentMachine& m);
  /// Takes its answer.
  void leave(std::size_t i, const machine_code::SegmentMachine& m, machine_code::CallEnding ending);

 private:
  machine_code::Frame frame_;
  std::size_t in_;
  std::size_t out_;
  Batch batch_;
  x86model::Registers<16> entered_;
};

}  // namespace fixproof::parties

/// @file
/// The calls of machine code that answer a batch, whichever machine makes them.
#pragma once

#include <cstddef>

#include "verify/machine_code/call_ending.hpp"
#include "verify/machine_code/frame.hpp"
#include "verify/party.hpp"

namespace fixproof {

/// What happens before and after each call of a routine. Every call begins with other noise in
/// registers, flags and the place of the results, and is held to what a C caller relies on.
class MachineCalls {
 public:
  MachineCalls(x86model::Routine routine, const Batch& batch);

  /// Sets up case `i`.
  void enter(std::size_t i, SegmentMachine& m);
  /// Takes its answer.
  void leave(std::size_t i, const SegmentMachine& m, CallEnding ending);

 private:
  Frame frame_;
  std::size_t in_;
  std::size_t out_;
  Batch batch_;
  x86model::Registers<16> entered_;
};

}  // namespace fixproof

/// @file
/// The machine-code calls that answer cases, on any machine.
#pragma once

#include <cstddef>

#include "verify/machine_code/call_ending.hpp"
#include "verify/machine_code/frame.hpp"
#include "verify/parties/party.hpp"

namespace fixproof::parties {

/// Sets up each call of a routine and checks it afterwards. Each call starts with different junk in
/// the registers, flags and results, and must preserve what a C caller relies on.
class MachineCalls {
 public:
  MachineCalls(x86model::Routine routine, const Cases& asked);

  void enter(std::size_t i, machine_code::SegmentMachine& m);
  void leave(std::size_t i, const machine_code::SegmentMachine& m, machine_code::CallEnding ending);

 private:
  machine_code::Frame frame_;
  std::size_t in_;
  std::size_t out_;
  Cases asked_;
  x86model::Registers<16> entered_;
};

}  // namespace fixproof::parties

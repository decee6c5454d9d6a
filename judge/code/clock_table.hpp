/// @file
/// The clocks of single instructions of a user's code.
#pragma once

#include <cstdint>
#include <optional>

#include "judge/code/call.hpp"
#include "judge/code/timed_line.hpp"
#include "x86model/clocks.hpp"

namespace fixproof::judge {

/// One execution of an instruction.
struct TimedStep {
  const TimedLine* line = nullptr;
  const TimedLine* previous = nullptr;  ///< null at the first instruction
  const TimedLine* next = nullptr;      ///< null behind the routine: the caller's ADD SP,n
  bool taken = false;                   ///< of a jump
  Registers registers;                  ///< before it
  std::uint32_t memory = 0;             ///< what it reads from memory first
};

/// Returns the clocks by the rules of x86model/clocks.hpp, which has the forms of the listings; the
/// others are here.
/// @param code_bits 16 or 32
/// @return nothing if the processor lacks the instruction, or no figure is known
std::optional<x86model::Range> clocks_of(x86model::Cpu cpu, const TimedStep& step, int code_bits);

/// Tells whether the processor lacks the instruction because of 32-bit operands or code.
bool is_too_wide(x86model::Cpu cpu, const TimedLine& line, int code_bits);

}  // namespace fixproof::judge

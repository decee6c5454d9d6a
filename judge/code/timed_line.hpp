/// @file
/// What of an instruction decides how long it takes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "judge/code/call.hpp"
#include "judge/code/decoded.hpp"
#include "judge/code/listing.hpp"

namespace fixproof::judge {

struct TimedLine : Decoded {
  Line line;
  /// A letter for each operand: `r` register, `s` segment register, `m` memory, `i` immediate. A
  /// shift also has `1` (a count of one in the opcode) and `c` (CL), and IMUL `b` (an immediate
  /// byte). Any other operand is `?`.
  std::string shape;
  int bits = 0;                     ///< of the first register or memory operand; 0 without one
  std::vector<RegisterName> bases;  ///< of a memory operand, the index too
  std::uint32_t immediate = 0;      ///< the last one
};

TimedLine timed_line(const Line& line, const Decoded& decoded);

/// Tells whether a jump is taken, from the registers before it. Any other instruction is.
bool is_taken(const TimedLine& line, const Registers& before);

}  // namespace fixproof::judge

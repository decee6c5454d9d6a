/// @file
/// What of an instruction decides how long it takes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "judge/code/call.hpp"
#include "judge/code/listing.hpp"
#include "judge/code/operand.hpp"
#include "x86model/instruction.hpp"

namespace fixproof::judge {

struct TimedLine {
  Line line;
  std::string mnemonic;
  /// A letter for each operand: `r` register, `s` segment register, `m` memory, `i` immediate. A
  /// shift also has `1` (a count of one in the opcode) and `c` (CL), and IMUL `b` (an immediate
  /// byte). Any other operand is `?`.
  std::string shape;
  int bits = 0;                     ///< of the first register or memory operand; 0 without one
  int prefixes = 0;                 ///< of any kind
  int components = 0;               ///< as a 386 counts them at the target of a jump
  bool has_repeat = false;          ///< REP, REPE or REPNE
  bool overrides_segment = false;   ///< by a prefix
  bool needs_386 = false;           ///< its opcode, a prefix, or FS or GS
  bool uses_accumulator = false;    ///< the short form with AL, AX or EAX
  bool has_displacement = false;    ///< of a memory operand
  std::vector<RegisterName> bases;  ///< of a memory operand, the index too
  std::uint32_t immediate = 0;      ///< the last one
  std::uint8_t opcode = 0;          ///< the byte after the prefixes and 0F
  bool has_wide_addresses = false;  ///< 32 bits: LOOP counts in ECX
  /// The registers that it writes as an operand, for the next instruction's wait on a 486.
  unsigned writes = 0;
};

/// @param bytes those of the instruction
/// @param code_bits 16 or 32
TimedLine timed_line(const Line& line, std::span<const std::uint8_t> bytes, int code_bits);

/// Tells whether it is a conditional jump on flags.
bool is_conditional(const std::string& mnemonic);
/// Tells whether it is a jump that may not be taken.
bool may_pass(const std::string& mnemonic);
/// Tells whether a jump is taken, from the registers before it. Any other instruction is.
bool is_taken(const TimedLine& line, const Registers& before);

}  // namespace fixproof::judge

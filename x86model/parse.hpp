/// @file
/// Parses one line of assembly.
#pragma once

#include <optional>
#include <stdexcept>
#include <string_view>

#include "x86model/instruction.hpp"

namespace x86model {

/// The line is not an instruction; what() describes the error.
class ParseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Parses a mnemonic and its operands: registers of 8, 16 and 32 bits, immediates (decimal or 0x…,
/// from the smallest signed to the largest unsigned value of the first operand's size) and, for
/// jumps, labels. All names except labels are lower case.
///
/// @return nothing if the mnemonic or an operand is well formed but used by no routine, such as a
/// segment register or a memory operand
/// @throws ParseError if the line is not an instruction
std::optional<Instruction> parse(std::string_view line);

}  // namespace x86model

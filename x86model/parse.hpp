/// @file
/// One line of assembly as an instruction.
#pragma once

#include <optional>
#include <stdexcept>
#include <string_view>

#include "x86model/instruction.hpp"

namespace x86model {

/// A line that is no instruction; what() says what is wrong with it.
class ParseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Parses a mnemonic and its operands: registers of 8, 16 and 32 bits, immediates (decimal or 0x…,
/// from the smallest signed to the largest unsigned value of the first operand's size) and, for
/// jumps, labels. All names but labels are lower case.
///
/// @return nothing for a mnemonic or an operand that is well formed but that no routine has, such
/// as a segment register or a place in memory
/// @throws ParseError where the line is not an instruction
std::optional<Instruction> parse(std::string_view line);

}  // namespace x86model

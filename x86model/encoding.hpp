/// @file
/// The length of an instruction as machine code, and its parts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "x86model/instruction.hpp"
#include "x86model/instruction_table.hpp"

namespace x86model {

/// The parts of an instruction in 16-bit code, in bytes.
struct Encoding {
  int prefixes = 0;      ///< operand size, address size and segment prefixes
  int opcode = 1;        ///< 1 or 2
  int mod_rm = 0;        ///< 0 or 1; 2 with the SIB byte of a scaled index
  int displacement = 0;  ///< 0 to 4, for an address or a jump
  int immediate = 0;     ///< 0, 1, 2 or 4

  [[nodiscard]] constexpr int bytes() const {
    return prefixes + opcode + mod_rm + displacement + immediate;
  }
  /// The number of components that Intel counts for the target of a jump on a 386 (Programmer's
  /// Reference Manual 17.2.2.3): every byte, but a whole displacement or immediate as one.
  [[nodiscard]] constexpr int components() const {
    return prefixes + opcode + mod_rm + (displacement > 0 ? 1 : 0) + (immediate > 0 ? 1 : 0);
  }
};

/// The shortest encoding at full width, which NASM chooses. A jump is short unless the listing
/// calls it near. @pre the table has the form: that of every listing, and all that decode() and
/// mutants() make of them; any other instruction counts as one byte
Encoding encoding_of(const Instruction& instruction);

/// Whether an encoding has the operands of this instruction.
bool fits(Encoded encoded, const Instruction& instruction);

/// Whether a memory operand has a segment override prefix.
bool overrides_segment(const Instruction& instruction);

/// The position of the instruction that starts `offset` bytes after the first one, or the number of
/// instructions if none starts there.
std::size_t position_at(std::span<const Instruction> code, std::uint32_t offset);

}  // namespace x86model

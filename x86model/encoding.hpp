/// @file
/// How long an instruction is as machine code, and what parts it has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "x86model/instruction.hpp"

namespace x86model {

/// The parts of one instruction of 16-bit code, each in bytes.
struct Encoding {
  int prefixes = 0;      ///< of a dword operand, of a dword in an address, of a segment
  int opcode = 1;        ///< 1 or 2
  int mod_rm = 0;        ///< 0 or 1; 2 with the SIB byte of a scaled index
  int displacement = 0;  ///< 0 to 4, of an address or of a jump
  int immediate = 0;     ///< 0, 1, 2 or 4

  [[nodiscard]] constexpr int bytes() const {
    return prefixes + opcode + mod_rm + displacement + immediate;
  }
  /// What Intel counts where a jump ends on a 386 (Programmer's Reference Manual 17.2.2.3): every
  /// byte, but a displacement or an immediate as one whatever its length.
  [[nodiscard]] constexpr int components() const {
    return prefixes + opcode + mod_rm + (displacement > 0 ? 1 : 0) + (immediate > 0 ? 1 : 0);
  }
};

/// The shortest encoding at full width, which is the one that assemblers choose. A jump is short
/// unless the listing calls it near.
Encoding encoding_of(const Instruction& instruction);

/// Whether a prefix takes a memory operand from another segment.
bool overrides_segment(const Instruction& instruction);

/// The instruction that stands `offset` bytes behind the first one; the number of instructions
/// where none begins there.
std::size_t position_at(std::span<const Instruction> code, std::uint32_t offset);

}  // namespace x86model

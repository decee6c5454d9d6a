/// @file
/// How long an instruction is as machine code, and what parts it has.
#pragma once

#include "x86model/instruction.hpp"

namespace x86model {

/// The parts of one instruction of 16-bit code, each in bytes.
struct Encoding {
  int prefixes = 0;      ///< 0 or 1: the operand size prefix of a dword form
  int opcode = 1;        ///< 1 or 2
  int mod_rm = 0;        ///< 0 or 1
  int displacement = 0;  ///< 0 to 2, of an address or of a jump
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

/// The shortest encoding at full width, which is the one that assemblers choose. A jump is short:
/// in every routine each label is near enough.
Encoding encoding_of(const Instruction& instruction);

}  // namespace x86model

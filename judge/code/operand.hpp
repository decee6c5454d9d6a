/// @file
/// The operands of a disassembled instruction.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "judge/code/frame.hpp"
#include "judge/code/listing.hpp"

namespace fixproof::judge {

struct Operand {
  enum class Kind : std::uint8_t { reg, immediate, memory };

  Kind kind = Kind::immediate;
  RegisterName reg{};                          ///< if it is a register
  std::uint32_t value = 0;                     ///< immediate or displacement
  std::vector<RegisterName> bases{};           ///< registers; their sum with `value` is the address
  x86model::Size size = x86model::Size::none;  ///< of the instruction's operands
  int bits = 0;                                ///< the size in the text, or 0 if it has none
  int address_bits = 0;  ///< of a fixed address whose width the text has; else 0
};

/// Parses the operands after the mnemonic. Returns nothing if one is of another kind, such as a
/// segment register, a scaled index or a segment override.
std::optional<std::vector<Operand>> operands_of(const Line& line);

}  // namespace fixproof::judge

/// @file
/// Decodes machine code to instructions of the model.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>

#include "x86model/clocks.hpp"
#include "x86model/instruction.hpp"

namespace x86model {

struct Decoded {
  /// The value of a label operand is the distance from the next instruction.
  Instruction instruction;
  std::size_t length = 0;
};

/// Why bytes are no instruction of the model.
enum class Undecoded : std::uint8_t {
  cut_off,     ///< they end inside the instruction
  prefix,      ///< a prefix that no listing uses, or not with this instruction
  form,        ///< an instruction or operands that no listing uses
  addressing,  ///< an addressing mode that no listing uses, such as [BX+SI]
};

/// Decodes the first instruction of `bytes` as 16-bit real-mode code, by the encodings of
/// instruction_table.hpp. Only instructions, addressing modes and prefixes that some listing uses
/// are decoded: CS: before a memory operand, and, on the 386, 66h for doublewords and 67h for
/// addresses in 32-bit registers.
std::variant<Decoded, Undecoded> decode(std::span<const std::uint8_t> bytes, Cpu cpu);

}  // namespace x86model

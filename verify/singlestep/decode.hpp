/// @file
/// Decodes machine code to instructions of the model.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>

#include "x86model/clocks.hpp"
#include "x86model/instruction.hpp"

namespace fixproof::singlestep {

/// Reasons to skip a case.
enum class Skip : std::uint8_t {
  prefix,       ///< a prefix that no listing uses, or not with this instruction
  form,         ///< an instruction or operands that no listing uses
  addressing,   ///< an addressing mode that no listing uses, such as [BX+SI]
  direction,    ///< STOSB or STOSW with the direction flag set
  segment_end,  ///< an operand that crosses the end of its segment, a fault since the 286
};
inline constexpr std::size_t skip_count = 5;

std::string_view name_of(Skip reason);

struct Decoded {
  /// The value of a label operand is the distance from the next instruction.
  x86model::Instruction instruction;
  std::size_t length = 0;
};

/// Decodes the first instruction of `bytes` as 16-bit real-mode code. The encodings come from
/// Intel's manuals: the iAPX 86,88 User's Manual, table 4-14, the iAPX 286 Programmer's Reference
/// Manual, appendix B, and the 80386 Programmer's Reference Manual, appendix A. Only instructions,
/// addressing modes and prefixes that some listing uses are decoded: CS: before a memory operand,
/// and, on the 386, 66h for doublewords and 67h for addresses in 32-bit registers.
/// @throws UsageError if `bytes` ends inside the instruction
std::variant<Decoded, Skip> decode(std::span<const std::uint8_t> bytes, x86model::Cpu cpu);

}  // namespace fixproof::singlestep

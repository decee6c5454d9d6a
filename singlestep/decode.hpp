/// @file
/// Decodes machine code to instructions of the model.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>

#include "x86model/instruction.hpp"
#include "x86model/routine.hpp"

namespace fixproof::singlestep {

/// Reasons to skip a case, in the order in which decode() checks them.
enum class Skip : std::uint8_t { prefix, control_flow, not_modelled, byte_operand, memory_operand };
inline constexpr std::size_t skip_count = 5;

std::string_view name_of(Skip reason);

struct Decoded {
  x86model::Instruction instruction;
  std::size_t length = 0;
};

/// Decodes the first instruction of `bytes` as 16-bit real-mode code. The prefix 66h selects
/// doubleword operands on the 386. The encodings come from Intel's manuals: the iAPX 86,88 User's
/// Manual, table 4-14, for the 8088, and the 80386 Programmer's Reference Manual, appendix A. Only
/// instructions with register and immediate operands are decoded. PUSH and POP are skipped because
/// their stack operand is in memory, and all other prefixes are skipped too.
/// @throws UsageError if `bytes` ends inside the instruction
std::variant<Decoded, Skip> decode(std::span<const std::uint8_t> bytes, x86model::Target cpu);

}  // namespace fixproof::singlestep

/// @file
/// Machine code as instructions of the model.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>

#include "x86model/instruction.hpp"
#include "x86model/routine.hpp"

namespace fixproof::singlestep {

/// Why a case is not run, in the order in which they are looked for.
enum class Skip : std::uint8_t { prefix, control_flow, not_modelled, byte_operand, memory_operand };
inline constexpr std::size_t skip_count = 5;

std::string_view name_of(Skip reason);

/// One instruction, and how many bytes it takes.
struct Decoded {
  x86model::Instruction instruction;
  std::size_t length = 0;
};

/// Decodes the first instruction of `bytes`, 16-bit code as both processors run it in real mode;
/// 66h makes operands doublewords on the 386. Encodings are those of Intel's manuals: for the 8088
/// the iAPX 86,88 User's Manual (table 4-14), for the 386 its Programmer's Reference Manual
/// (appendix A). Only what has registers and immediates for operands becomes an instruction; PUSH
/// and POP have an operand in memory, the stack. All other prefixes are a reason to skip.
/// @throws UsageError where the bytes end inside the instruction
std::variant<Decoded, Skip> decode(std::span<const std::uint8_t> bytes, x86model::Target cpu);

}  // namespace fixproof::singlestep

/// @file
/// Compares the model with one captured case.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "verify/singlestep/read.hpp"
#include "x86model/clocks.hpp"

namespace fixproof::singlestep {

/// Reasons to skip a case. The first three are those of x86model::Undecoded.
enum class Skip : std::uint8_t {
  prefix,
  form,
  addressing,
  direction,    ///< STOSB or STOSW with the direction flag set
  segment_end,  ///< an operand that crosses the end of its segment, a fault since the 286
};
inline constexpr std::size_t skip_count = 5;

std::string_view name_of(Skip reason);

/// One entry per difference, such as `ax: model 0001, file 0002` or
/// `memory 1f0a2: model 00, file 80`; empty if model and case agree.
using Differences = std::vector<std::string>;

/// Executes the case's instruction in the model and compares everything that it leaves: whether a
/// divide error occurs, all registers including the instruction pointer, all flags except those
/// that Intel leaves undefined, every byte of memory that it writes, and that no other byte of the
/// case changes. In the sets of the 286 and 386 a HLT follows each instruction, so their
/// instruction pointer is one further.
///
/// A case has a divide error if its CS:IP is that of interrupt vector 0. The stack then holds
/// FLAGS, CS and the address of the next instruction on the 8088, of the divide itself since the
/// 286. The six arithmetic flags are undefined, but pushed as they are afterwards.
///
/// @throws UsageError if the bytes are not exactly one instruction
std::variant<Differences, Skip> judge(const Case& c, x86model::Cpu cpu);

}  // namespace fixproof::singlestep

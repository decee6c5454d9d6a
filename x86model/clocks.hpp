/// @file
/// How many clocks an instruction takes on an 8088, a 286, a 386 and a 486.
///
/// The counts are those of Intel's tables: real mode, near transfers, code already fetched, no wait
/// states, aligned words and every access of a 486 in its cache. A 486 waits a clock for an address
/// register that the instruction before has just written.
/// The 8088's MUL and DIV are not ranges but what its microcode takes for the operands. Real
/// machines are slower: an 8088 often waits for code, which bus.hpp counts.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "x86model/instruction.hpp"

namespace x86model {

/// The processors that have a table of clocks.
enum class Cpu : std::uint8_t { i8088, i286, i386, i486 };
inline constexpr int cpu_count = 4;

/// A number of clocks that is known within bounds, both included.
struct Range {
  std::uint64_t min = 0;
  std::uint64_t max = 0;

  constexpr Range& operator+=(Range other) {
    min += other.min;
    max += other.max;
    return *this;
  }
  friend constexpr Range operator+(Range a, Range b) { return a += b; }
  friend constexpr bool operator==(const Range&, const Range&) = default;
};

/// One instruction as it was executed.
struct Execution {
  Instruction instruction;
  /// Whether a jump was taken; a call and a return always are.
  bool taken = false;
  /// What is executed after a jump that was taken, and after any LOOP: on a 286 and a 386 its
  /// length counts. Null for
  /// the code of the routine's caller, taken to be ADD SP,n: C pops the arguments.
  const Instruction* next = nullptr;
  /// What was executed just before. Null where that is not known: then a 486 waits for nothing.
  const Instruction* previous = nullptr;
  /// Of a multiply or divide, before it, zero-extended: (E)AX, (E)DX and the operand.
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  std::uint32_t operand = 0;
};

/// @return nothing where `cpu` has no such instruction, or no routine or loop that it can run uses
/// this form (a register and a place in memory are one form).
std::optional<Range> clocks(Cpu cpu, const Execution& execution);

/// "8088", "286", "386" or "486".
std::string_view name_of(Cpu cpu);

}  // namespace x86model

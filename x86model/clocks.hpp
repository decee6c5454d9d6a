/// @file
/// The clocks that an instruction takes on an 8088, a 286, a 386 and a 486.
///
/// The counts are those of Intel's tables: real mode, near transfers, code already fetched, no wait
/// states, aligned words, and cache hits only on a 486. A 486 waits a clock for an address register
/// that the previous instruction has written. MUL and DIV on the 8088 are not ranges but the exact
/// counts of its microcode for the operands. Real machines are slower: an 8088 often waits for
/// code, which bus.hpp counts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "x86model/instruction.hpp"

namespace x86model {

/// The processors that have a table of clocks.
enum class Cpu : std::uint8_t { i8088, i286, i386, i486 };
inline constexpr int cpu_count = 4;

/// Inclusive bounds on a number of clocks.
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

/// One executed instruction.
struct Execution {
  Instruction instruction;
  /// Whether a jump was taken; always true for a call and a return.
  bool taken = false;
  /// The instruction executed after a taken jump, and after every LOOP: its length counts on a 286
  /// and a 386. Null for the code of the routine's caller, assumed to be ADD SP,n, because in C the
  /// caller pops the arguments.
  const Instruction* next = nullptr;
  /// The previous instruction, or null if unknown: then no wait of a 486 is counted.
  const Instruction* previous = nullptr;
  /// The inputs of a multiply or divide, zero-extended: (E)AX, (E)DX and the operand.
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  std::uint32_t operand = 0;
};

/// @return nothing if `cpu` has no such instruction, or if there is no figure for the form; of the
/// multiplies and divides, only those of the routines have one
std::optional<Range> clocks(Cpu cpu, const Execution& execution);

/// The operands as the rows of clock_rows.hpp name them, a letter each: `r` register, `m` memory,
/// `i` immediate or label, `1` a shift count of one.
std::string shape_of(const Instruction& instruction);

/// "8088", "286", "386" or "486".
std::string_view name_of(Cpu cpu);

}  // namespace x86model

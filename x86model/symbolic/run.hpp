/// @file
/// The symbolic run: every path through a program, for all operands at once.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "x86model/execute.hpp"
#include "x86model/symbolic/state.hpp"

namespace x86model::symbolic {

/// One path through a program.
struct Path {
  Term condition;  ///< on the operands that take this path
  /// A further assumption: every address in the cosine table is that of one of its words.
  Term in_table;
  Outcome outcome{};
  std::size_t position = 0;  ///< of the last instruction, or RunOptions::stop if it was reached
  State state;
};

/// Abstractions and limits of a run.
struct RunOptions {
  /// A call does not enter the procedure: DX:AX becomes `fixedmul` of its two arguments; BX, CX and
  /// the flags become unknown, as FixedMul leaves them.
  bool calls_are_fixed_mul = false;
  /// An operand of at most 16 bits. If a jump depends only on it, all its values are tried, and
  /// paths that no value takes are dropped.
  std::optional<Term> enumerated{};
  /// Memory is unconstrained: a read is an application of `databyte` or `dataword` to the address,
  /// and writes are recorded in State::stores, without immediate repetitions. A read of the data
  /// segment after a write to it ends the path as bad_address, because the addresses may be equal.
  /// The extra segment is separate.
  bool memory_is_open = false;
  /// The first instruction of the run.
  std::size_t first = 0;
  /// A path that reaches this position after its first instruction ends as proceeds.
  std::optional<std::size_t> stop{};
  /// The maximum number of jumps of a path at one position; one more ends it as step_limit.
  int max_jumps = 12;
  /// A thread that would branch when there are more paths than this ends as step_limit, because
  /// mutants may loop forever.
  std::size_t max_paths = 1000;
};

/// All paths through `code` from `start`. The caller sets up stack, arguments and SP; the return
/// address is that of x86model/run.hpp. Words of the cosine table are applications of `cosword` to
/// an offset in bytes.
std::vector<Path> run(Terms& terms, std::span<const Instruction> code, const State& start,
                      const RunOptions& options = {});

}  // namespace x86model::symbolic

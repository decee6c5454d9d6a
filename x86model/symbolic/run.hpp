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

/// One way through a program.
struct Path {
  Term condition;  ///< under which operands the program goes this way
  /// What must hold of them besides: every address in the cosine table is one of its words.
  Term in_table;
  Outcome outcome;
  std::size_t position;  ///< of the last instruction; of RunOptions::stop where it was reached
  State state;
};

/// What is left abstract on the way.
struct RunOptions {
  /// A call does not enter the procedure: DX:AX becomes `fixedmul` of its two arguments, BX, CX and
  /// the flags become unknown, as FixedMul leaves them.
  bool calls_are_fixed_mul = false;
  /// An operand of at most 16 bits whose values are tried one by one where a jump depends on it
  /// alone: ways that none of them takes are not followed.
  std::optional<Term> enumerated{};
  /// Memory holds anything: what is read is an application of `databyte` or `dataword` to the
  /// address, what is written is kept in State::stores, the same
  /// twice in succession once. To read the data segment after writing it
  /// ends a path as bad_address: the two places might be one. The extra segment is another.
  bool memory_is_open = false;
  /// Where the run begins.
  std::size_t first = 0;
  /// Where a path ends, as proceeds, when it comes there after its first instruction.
  std::optional<std::size_t> stop{};
  /// How often a path may jump at one place: one that would do so again ends as step_limit.
  int most_jumps = 12;
  /// With more ways than that before it, a thread ends as step_limit where it would branch: broken
  /// programs branch in circles.
  std::size_t most_paths = 1000;
};

/// All paths through `code` from `start`. Stack, arguments and SP are the caller's to set up, the
/// return address as in x86model/run.hpp. Words of the cosine table are applications of `cosword`
/// to an offset in bytes.
std::vector<Path> run(Terms& terms, std::span<const Instruction> code, const State& start,
                      const RunOptions& options = {});

}  // namespace x86model::symbolic

/// @file
/// Finds the first operation in which two runs differ.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "desync/log_file.hpp"
#include "desync/values.hpp"

namespace fixproof::desync {

/// What differs first.
enum class Verdict {
  equal,       ///< Nothing, as far as both logs go.
  block,       ///< A block; its records are not in both logs.
  input,       ///< A number that was read or converted from floating point.
  operands,    ///< The operands of the same operation: the states differ.
  arithmetic,  ///< The results of the same operation with the same operands.
  order,       ///< Two operations on one value come in another order.
  path,        ///< The operations are others: the programs take different ways.
  ended,       ///< Nothing until a block in which one run ended. If the records of the block are in
               ///< both logs, nothing in it either.
};

/// A side's place of the difference.
struct Place {
  word block = 0;
  Entry entry;
  std::vector<Record> records;       ///< Of it and the next one, if the log has them.
  std::optional<std::size_t> index;  ///< Of the record that differs; none if the block ends before.
};

/// What compare() finds.
struct Comparison {
  Verdict verdict = Verdict::equal;
  word blocks = 0;      ///< Blocks that both logs have; in rollbacks, frames.
  word operations = 0;  ///< Operations that are equal, if none differs.
  word steps = 0;       ///< Entries of one log that were compared with those of the other.
  Place a;
  Place b;
};

/// Compares two runs from the beginning: in a logarithmic number of steps, because the entry of a
/// block has a hash of everything before its end.
///
/// Compilers choose which operand of an operator they compute first, so the same operations in
/// another order, with the same operands and results, are no difference. Where the end of a block
/// comes between two such operations, its hashes differ, and those of later blocks do not.
Comparison compare(LogFile& a, LogFile& b);

/// Compares the last simulation of every frame, in the order of their numbers, up to the last frame
/// that both runs confirmed, if they did. For programs that go back and simulate frames again.
/// Reads all entries.
/// @throws support::UsageError if a log has no frames
Comparison compare_last_frames(LogFile& a, LogFile& b);

}  // namespace fixproof::desync

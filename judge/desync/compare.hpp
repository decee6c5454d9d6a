/// @file
/// Finds the first operation in which two runs differ.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "judge/desync/cause.hpp"
#include "judge/desync/log_file.hpp"

namespace fixproof::desync {

/// One run, at the difference.
struct Side {
  word block = 0;
  Entry entry;
  std::vector<Record> records;       ///< Of the block and the next one, if the log has them.
  bool ends_run = false;             ///< Whether the run ends after these records.
  std::optional<std::size_t> index;  ///< Of the record that differs, unless the block ends first.
};

/// What compare() finds.
struct Comparison {
  Verdict verdict = Verdict::equal;
  std::optional<Origin> origin;  ///< Where the operands that differ were computed.
  word blocks = 0;               ///< Blocks that both logs have; with rollback, frames.
  word operations = 0;           ///< Number of equal operations, if none differs.
  word steps = 0;                ///< Number of comparisons.
  Side a;
  Side b;
};

/// Compares two runs from their beginning. It takes a logarithmic number of steps, because the
/// entry of a block has a hash of everything up to its end.
///
/// Compilers choose which operand of an operator they compute first. So the same operations in a
/// different order, with the same operands and results, are no difference. If a block ends between
/// two such operations, its hash differs, and the hashes of later blocks are equal again.
Comparison compare(LogFile& a, LogFile& b);

/// Compares the last simulation of every frame, in the order of the frames, for programs that go
/// back and simulate frames again. Stops after the last frame that both runs confirmed, if both
/// confirmed any. Reads all entries.
/// @throws support::UsageError if a log has no frames
Comparison compare_last_frames(LogFile& a, LogFile& b);

}  // namespace fixproof::desync

/// @file
/// What is known after a run, whole or not: which chunks are done and what they found.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "cases/plan.hpp"

namespace fixproof::verify {

/// A case on which parties differ.
struct Mismatch {
  std::uint64_t chunk = 0;
  std::uint64_t index = 0;  ///< of the case in its stream
  std::vector<std::uint32_t> words;
  /// The simplest case found on which they still differ; empty until it has been sought.
  std::vector<std::uint32_t> smallest;
  /// Each party and what it says of the smallest case: words of hex digits, or how else it ended.
  std::vector<std::pair<std::string, std::string>> said;

  friend bool operator==(const Mismatch&, const Mismatch&) = default;
};

/// What was found in one row.
struct Findings {
  std::uint64_t cases = 0;       ///< each counted once, however many parties answered it
  std::uint64_t faults = 0;      ///< #DE, as the judged party has it
  std::uint64_t mismatches = 0;  ///< cases on which some party differs from the judged one
  std::vector<Mismatch> shown;   ///< the first of them, in the order of the plan

  /// Adds another part of the row, keeping the `most` first mismatches.
  void add(const Findings& other, std::size_t most);
  friend bool operator==(const Findings&, const Findings&) = default;
};

/// The state of a verification.
struct Report {
  Report(cases::Plan plan_, cases::Shard shard_, std::size_t max_shown_);

  cases::Plan plan;
  cases::Shard shard;
  std::size_t max_shown;           ///< mismatches kept for each row
  std::vector<bool> done;          ///< one for each chunk of the plan
  std::vector<Findings> findings;  ///< one for each row of the plan
  double seconds = 0;              ///< spent, over all runs

  [[nodiscard]] std::uint64_t chunks_done() const;
  /// Chunks of the shard.
  [[nodiscard]] std::uint64_t chunks_in_shard() const;
  [[nodiscard]] bool complete() const { return chunks_done() == chunks_in_shard(); }
  [[nodiscard]] std::uint64_t cases() const;
  [[nodiscard]] std::uint64_t mismatches() const;
};

}  // namespace fixproof::verify

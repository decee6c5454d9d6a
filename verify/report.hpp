/// @file
/// The state of a complete or partial run: which chunks are done, and their findings.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "verify/cases/plan.hpp"
#include "verify/maker.hpp"

namespace fixproof::verify {

/// The largest Report::max_shown.
inline constexpr std::uint64_t max_reports = 1000;

struct Mismatch {
  std::uint64_t chunk = 0;
  std::uint64_t index = 0;  ///< position of the case in its stream
  std::vector<std::uint32_t> words;
  /// The simplest case found on which they still differ; empty until shrink() has run.
  std::vector<std::uint32_t> smallest;
  /// Each party and its answer to the smallest case: words in hex digits, or how else it ended.
  std::vector<std::pair<std::string, std::string>> said;

  friend bool operator==(const Mismatch&, const Mismatch&) = default;
};

struct Findings {
  std::uint64_t cases = 0;       ///< each counted once, regardless of the number of parties
  std::uint64_t faults = 0;      ///< cases on which the judged party reports #DE
  std::uint64_t mismatches = 0;  ///< cases on which some party differs from the judged one
  std::vector<Mismatch> shown;   ///< the first mismatches, in the order of the plan

  /// Adds another part of the row and keeps the first `most` mismatches.
  void add(const Findings& other, std::size_t most);
  friend bool operator==(const Findings&, const Findings&) = default;
};

/// The findings of one chunk, and the digest of all answers that the parties gave in it.
struct ChunkFindings {
  Findings findings;
  std::uint64_t answers = 0;
};

/// What a report keeps of a finished chunk, so that running it again shows whether it is true.
struct ChunkResult {
  std::uint64_t faults = 0;
  std::uint64_t mismatches = 0;
  std::uint64_t answers = 0;

  friend bool operator==(const ChunkResult&, const ChunkResult&) = default;
};

struct Report {
  Report(cases::Plan plan_, cases::Shard shard_, std::size_t max_shown_);

  cases::Plan plan;
  cases::Shard shard;
  std::size_t max_shown;            ///< mismatches kept per row
  std::vector<bool> done;           ///< one flag per chunk of the plan
  std::vector<ChunkResult> chunks;  ///< one entry per chunk of the plan; zeros unless it is done
  std::vector<Findings> findings;   ///< one entry per row of the plan
  double seconds = 0;               ///< total over all runs
  std::vector<Maker> makers;        ///< what ran the chunks, without duplicates

  /// Adds a chunk that is not done yet.
  void add(std::uint64_t chunk, const ChunkFindings& found);
  void add(const Maker& maker);
  [[nodiscard]] std::uint64_t chunks_done() const;
  [[nodiscard]] std::uint64_t chunks_in_shard() const;
  [[nodiscard]] bool complete() const { return chunks_done() == chunks_in_shard(); }
  [[nodiscard]] std::uint64_t cases() const;
  [[nodiscard]] std::uint64_t mismatches() const;
};

}  // namespace fixproof::verify

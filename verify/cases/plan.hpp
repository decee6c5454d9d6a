/// @file
/// The plan of a verification: its rows, their jobs, and the chunks that threads work on.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "verify/cases/streams.hpp"
#include "verify/cases/variant.hpp"

namespace fixproof::cases {

/// One row of the table: a variant and the parties that answer it.
struct Row {
  Variant variant;
  /// The judged party, then its references. The row is compared only if it has at least two.
  std::vector<std::string> parties;

  [[nodiscard]] bool compared() const { return parties.size() >= 2; }
  friend bool operator==(const Row&, const Row&) = default;
};

struct Job {
  std::size_t row;
  Stream stream;
  std::uint64_t cases;
  std::uint64_t cases_per_chunk;
  std::uint64_t first_chunk;
};

/// Consecutive cases of one job, the unit of work of a thread.
struct Chunk {
  const Job* job;
  std::uint64_t first;
  std::uint64_t cases;
};

/// The jobs of all rows, cut into numbered chunks. Level, seed and rows determine the plan.
class Plan {
 public:
  /// Makes the jobs of `level` for each compared row.
  /// @throws std::invalid_argument for a level other than 1, 2 and 3
  Plan(int level, std::uint64_t seed, std::vector<Row> rows);

  [[nodiscard]] int level() const { return level_; }
  [[nodiscard]] std::uint64_t seed() const { return seed_; }
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
  [[nodiscard]] const std::vector<Job>& jobs() const { return jobs_; }
  [[nodiscard]] std::uint64_t chunks() const { return chunks_; }
  /// Returns chunk `number`, 0 ... chunks() - 1. It points into the plan.
  [[nodiscard]] Chunk chunk(std::uint64_t number) const;
  [[nodiscard]] std::uint64_t cases() const;

 private:
  void add_job(std::size_t row, Stream stream, std::uint64_t cases);

  int level_;
  std::uint64_t seed_;
  std::vector<Row> rows_;
  std::vector<Job> jobs_;
  std::uint64_t chunks_ = 0;
};

/// The chunks whose number is `index` - 1 modulo `count`.
struct Shard {
  std::uint64_t index = 1;  ///< 1 ... count
  std::uint64_t count = 1;

  [[nodiscard]] bool has(std::uint64_t chunk) const { return chunk % count == index - 1; }
  friend bool operator==(const Shard&, const Shard&) = default;
};

/// Parses `i/n` with 1 <= i <= n.
/// @throws UsageError for any other text
Shard parse_shard(const std::string& text);

/// Tells whether a variant has at most 2^32 cases.
bool can_be_exhausted(const Variant& variant);

/// Returns the form of `variant` that a level compares. Levels 1 and 2 compare it unchanged; level
/// 3 compares multiply and divide at half width. Level 3 enumerates operands, so it has no
/// transforms. It also skips chapter 52, whose half-width program is that of chapter 54.
std::optional<Variant> at_level(int level, const Variant& variant);

}  // namespace fixproof::cases

/// @file
/// What a verification runs: rows of the table, each with its jobs, all cut into one list of
/// chunks.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cases/streams.hpp"
#include "cases/variant.hpp"

namespace fixproof::cases {

/// One row of the table: a variant and who answers it.
struct Row {
  Variant variant;
  /// The party that is judged, then those it is judged against. With fewer than two nothing is
  /// compared.
  std::vector<std::string> parties;

  [[nodiscard]] bool compared() const { return parties.size() >= 2; }
  friend bool operator==(const Row&, const Row&) = default;
};

/// One stream of cases of one row.
struct Job {
  std::size_t row;
  Stream stream;
  std::uint64_t cases;
  std::uint64_t cases_per_chunk;
  std::uint64_t first_chunk;
};

/// A run of cases of one job: what a thread does at a time.
struct Chunk {
  const Job* job;
  std::uint64_t first;
  std::uint64_t cases;
};

/// Jobs for rows, cut into chunks that are numbered through. Two plans of the same level, seed and
/// rows are the same.
class Plan {
 public:
  /// The jobs that `level` has for each row that is compared.
  /// @throws std::invalid_argument for a level other than 1, 2 and 3
  Plan(int level, std::uint64_t seed, std::vector<Row> rows);

  [[nodiscard]] int level() const { return level_; }
  [[nodiscard]] std::uint64_t seed() const { return seed_; }
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
  [[nodiscard]] const std::vector<Job>& jobs() const { return jobs_; }
  [[nodiscard]] std::uint64_t chunks() const { return chunks_; }
  /// Chunk `number`, 0 ... chunks() - 1; it points into the plan.
  [[nodiscard]] Chunk chunk(std::uint64_t number) const;
  /// Cases of all jobs.
  [[nodiscard]] std::uint64_t cases() const;

 private:
  void add_job(std::size_t row, Stream stream, std::uint64_t cases);

  int level_;
  std::uint64_t seed_;
  std::vector<Row> rows_;
  std::vector<Job> jobs_;
  std::uint64_t chunks_ = 0;
};

/// A part of the chunks: those whose number is `index` - 1 modulo `count`.
struct Shard {
  std::uint64_t index = 1;  ///< 1 ... count
  std::uint64_t count = 1;

  [[nodiscard]] bool has(std::uint64_t chunk) const { return chunk % count == index - 1; }
  friend bool operator==(const Shard&, const Shard&) = default;
};

/// Reads `i/n` with 1 <= i <= n.
/// @throws UsageError for any other text
Shard parse_shard(const std::string& text);

/// The form of `variant` that a level compares: levels 1 and 2 take it as it is, level 3 takes
/// multiply and divide at half width. Empty where a level has no cases: level 3 samples nothing, so
/// that it leaves out the transforms; and at half width the two chapters have one program.
std::optional<Variant> at_level(int level, const Variant& variant);

}  // namespace fixproof::cases

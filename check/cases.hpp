/// @file
/// The cases that a subject is given: the streams of a verification one after another, or the lines
/// of a file.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstdint>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cases/plan.hpp"
#include "cases/variant.hpp"

namespace fixproof::check {

/// Which cases; `gen` and `check` take the same options, so that both have the same cases.
struct CaseOptions {
  std::uint64_t level = 1;
  std::uint64_t seed = 1994;
  std::string shard = "1/1";
  std::optional<std::uint64_t> cases;  ///< at most so many, evenly spread

  /// The command that writes them.
  [[nodiscard]] std::string command_line(cases::Operation operation) const;
};

/// Cases in their order.
class CaseSource : private boost::noncopyable {
 public:
  CaseSource() = default;
  virtual ~CaseSource() = default;

  /// The words of the next case; false where there is none.
  virtual bool next(std::span<std::uint32_t> words) = 0;
  /// The stream or the file of the last case, which lives as long as the source.
  [[nodiscard]] virtual std::string_view origin() const = 0;
  /// How many there are, where that is known before.
  [[nodiscard]] virtual std::optional<std::uint64_t> count() const { return std::nullopt; }
};

/// The cases that a verification of the operation has at that level, from its seed.
class GeneratedCases final : public CaseSource {
 public:
  /// @throws UsageError for a shard that is none
  GeneratedCases(cases::Operation operation, const CaseOptions& options);

  bool next(std::span<std::uint32_t> words) override;
  [[nodiscard]] std::string_view origin() const override { return origin_; }
  [[nodiscard]] std::optional<std::uint64_t> count() const override { return count_; }
  /// How many of them are of a stream.
  [[nodiscard]] std::uint64_t count_of(std::string_view stream) const;

 private:
  /// Cases of the whole plan before a chunk.
  [[nodiscard]] std::uint64_t cases_before(const cases::Chunk& chunk) const;
  /// Of the first `cases` of the plan, those that are taken.
  [[nodiscard]] std::uint64_t taken_of(std::uint64_t cases) const;
  bool fill();

  cases::Variant variant_;
  cases::Plan plan_;
  cases::Shard shard_;
  std::uint64_t seed_;
  std::uint64_t all_;     ///< cases of the plan
  std::uint64_t wanted_;  ///< of these
  std::uint64_t count_ = 0;
  std::uint64_t next_chunk_ = 0;
  std::optional<cases::Chunk> chunk_;
  std::uint64_t in_chunk_ = 0;  ///< cases of it that have been made
  std::uint64_t place_ = 0;     ///< in the plan, of the next case of the batch
  std::vector<std::uint32_t> batch_;
  std::span<const std::uint32_t> rest_;  ///< of the batch
  std::string_view origin_;
};

/// The cases of a file in the format of `gen`.
class FileCases final : public CaseSource {
 public:
  /// @throws UsageError if it cannot be read
  FileCases(cases::Operation operation, std::string path);

  /// @throws UsageError naming the line that is no case
  bool next(std::span<std::uint32_t> words) override;
  [[nodiscard]] std::string_view origin() const override { return path_; }

 private:
  cases::Variant variant_;
  std::string path_;
  std::ifstream file_;
  std::uint64_t line_ = 0;
};

}  // namespace fixproof::check

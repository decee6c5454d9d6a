/// @file
/// The sources of cases for a subject: the streams of a verification, or the lines of a file.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstdint>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "judge/check/operands.hpp"
#include "verify/cases/plan.hpp"
#include "verify/cases/variant.hpp"

namespace fixproof::check {

/// The selection of cases. `gen` and `check` take the same options, so both have the same cases.
struct CaseOptions {
  std::uint64_t level = 1;
  std::uint64_t seed = 1994;
  std::string shard = "1/1";
  std::optional<std::uint64_t> cases;  ///< the maximum number, evenly spread

  /// Returns the command that writes these cases.
  [[nodiscard]] std::string command_line(const cases::Variant& variant) const;
};

class CaseSource : private boost::noncopyable {
 public:
  CaseSource() = default;
  virtual ~CaseSource() = default;

  /// Reads the words of the next case, words_in(variant) of them; false at the end.
  virtual bool next(std::span<std::uint32_t> words) = 0;
  /// Reads the next case of a variant that is_judged_by_value(); empty at the end.
  virtual std::optional<ValuedCase> next_valued() = 0;
  /// The stream or the file of the last case. The text lives as long as the source.
  [[nodiscard]] virtual std::string_view origin() const = 0;
  /// The number of cases, if it is known in advance.
  [[nodiscard]] virtual std::optional<std::uint64_t> count() const { return std::nullopt; }
};

/// The cases of a verification of the operation in the format, at that level, with that seed.
class GeneratedCases final : public CaseSource {
 public:
  /// @throws UsageError for an invalid shard
  GeneratedCases(const cases::Variant& variant, const CaseOptions& options);

  bool next(std::span<std::uint32_t> words) override;
  std::optional<ValuedCase> next_valued() override;
  [[nodiscard]] std::string_view origin() const override { return origin_; }
  [[nodiscard]] std::optional<std::uint64_t> count() const override { return count_; }
  /// Returns the number of these cases that are from a stream.
  [[nodiscard]] std::uint64_t count_of(std::string_view stream) const;

 private:
  /// Returns the number of cases of the whole plan before a chunk.
  [[nodiscard]] std::uint64_t cases_before(const cases::Chunk& chunk) const;
  /// Returns how many of the first `cases` of the plan are selected.
  [[nodiscard]] std::uint64_t taken_of(std::uint64_t cases) const;
  bool fill();

  cases::Variant variant_;
  cases::Plan plan_;
  cases::Shard shard_;
  std::uint64_t seed_;
  std::uint64_t all_;     ///< cases of the plan
  std::uint64_t wanted_;  ///< selected cases of the plan
  std::uint64_t count_ = 0;
  std::uint64_t next_chunk_ = 0;
  std::optional<cases::Chunk> chunk_;
  std::uint64_t in_chunk_ = 0;  ///< cases of the chunk already made
  std::uint64_t place_ = 0;     ///< place in the plan of the next case of the batch
  std::vector<std::uint32_t> batch_;
  std::span<const std::uint32_t> rest_;  ///< unread words of the batch
  std::string_view origin_;
};

/// The cases of a file in the format of `gen`.
class FileCases final : public CaseSource {
 public:
  /// @throws UsageError if the file cannot be read
  FileCases(const cases::Variant& variant, std::string path);

  /// @throws UsageError naming the line that is not a case
  bool next(std::span<std::uint32_t> words) override;
  /// @throws UsageError naming the line that is not a case
  std::optional<ValuedCase> next_valued() override;
  [[nodiscard]] std::string_view origin() const override { return path_; }

 private:
  /// Reads the next line that is not a comment and passes it on; false at the end.
  template <class Parse>
  bool next_line(Parse parse);

  cases::Variant variant_;
  std::string path_;
  std::ifstream file_;
  std::uint64_t line_ = 0;
};

}  // namespace fixproof::check

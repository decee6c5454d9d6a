/// @file
/// The result of `fixproof step --singlestep` as JSON.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "support/json.hpp"
#include "verify/singlestep/judge.hpp"

namespace fixproof::cli {

/// The cases of one file, or of all.
struct StepCounts {
  std::uint64_t equal = 0;
  std::uint64_t differing = 0;
  std::array<std::uint64_t, singlestep::skip_count> skipped{};

  [[nodiscard]] std::uint64_t run() const { return equal + differing; }
  [[nodiscard]] std::uint64_t all_skipped() const;
  StepCounts& operator+=(const StepCounts& other);
};

/// A case whose state after the instruction is not the captured one.
struct DifferingStep {
  std::uint64_t index = 0;
  std::string name;
  singlestep::Differences differences;
};

/// What came of one file.
struct StepFile {
  std::string path;
  StepCounts counts;
  std::vector<DifferingStep> shown;
  std::string error;
};

support::Json singlestep_json(const std::vector<StepFile>& files, const StepCounts& total);

}  // namespace fixproof::cli

/// @file
/// The cases of a run, again and again.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "judge/check/cases.hpp"
#include "judge/check/judged_case.hpp"
#include "judge/program/relay.hpp"

namespace fixproof::program {

/// One way through the cases.
class Steps {
 public:
  Steps(const cases::Variant& variant, const check::CaseOptions& options, std::uint64_t stride);

  bool next();
  [[nodiscard]] std::span<const std::uint32_t> words() const { return words_; }
  /// Returns the case without its result.
  [[nodiscard]] check::JudgedCase judged() const;

 private:
  cases::Variant variant_;
  std::unique_ptr<check::GeneratedCases> cases_;
  std::uint64_t stride_;
  std::uint64_t to_skip_ = 0;
  std::vector<std::uint32_t> words_;
};

/// Every stride-th case that the options select.
struct Walk {
  cases::Variant variant;
  check::CaseOptions cases;
  std::uint64_t stride = 1;

  [[nodiscard]] Steps steps() const { return {variant, cases, stride}; }
  /// Returns the lines of the cases from `first` up to, but excluding, `end`.
  [[nodiscard]] NextCase lines(std::uint64_t first = 0,
                               std::uint64_t end = std::numeric_limits<std::uint64_t>::max()) const;
};

}  // namespace fixproof::program

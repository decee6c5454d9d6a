/// @file
/// Compares a subject with its rules, case by case, and counts.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "judge/check/common_traits.hpp"
#include "judge/check/curve.hpp"
#include "judge/check/exact_place.hpp"
#include "judge/check/idioms.hpp"
#include "judge/check/judged_case.hpp"
#include "judge/check/port_trial.hpp"
#include "judge/check/rules.hpp"
#include "judge/check/trial.hpp"

namespace fixproof::check {

struct KindTally {
  std::uint64_t cases = 0;
  std::uint64_t wrong = 0;
};

struct LargestError {
  double ulps = 0;
  JudgedCase at;
};

class Judge {
 public:
  /// `max_shown` is the number of wrong cases to keep.
  Judge(const Rules& rules, std::size_t max_shown);

  void add(const JudgedCase& one);

  [[nodiscard]] const Rules& rules() const { return rules_; }
  [[nodiscard]] std::uint64_t cases() const { return cases_; }
  /// The number of cases for which the rules accept any result.
  [[nodiscard]] std::uint64_t not_judged() const { return not_judged_; }
  [[nodiscard]] const FirstCases& wrong() const { return wrong_; }
  /// Returns the counts of a kind, of results below 0 only if `negative_alone`.
  [[nodiscard]] KindTally tally(CaseKind kind, bool negative_alone) const;
  /// Empty if the subject gave no result in range.
  [[nodiscard]] const std::optional<LargestError>& largest_error() const { return largest_error_; }
  [[nodiscard]] const RuleTrial& trial() const { return trial_; }
  [[nodiscard]] const PortTrial& ports() const { return ports_; }
  [[nodiscard]] const IdiomTrial& idioms() const { return idioms_; }
  [[nodiscard]] const CommonTraits& common() const { return common_; }
  /// Empty unless the operation is a function.
  [[nodiscard]] const std::optional<Curve>& curve() const { return curve_; }

 private:
  /// Adds a case, with `read` set if the rule needs it.
  void add_read(const JudgedCase& one);

  Rules rules_;
  std::uint64_t cases_ = 0;
  std::uint64_t not_judged_ = 0;
  FirstCases wrong_;
  /// By kind, then by sign.
  std::array<std::array<KindTally, 2>, case_kinds> tallies_{};
  std::optional<LargestError> largest_error_;
  RuleTrial trial_;
  PortTrial ports_;
  IdiomTrial idioms_;
  CommonTraits common_;
  std::optional<Curve> curve_;
};

}  // namespace fixproof::check

/// @file
/// Compares a subject with its rules, case by case, and counts.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

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
  /// The number of wrong results.
  [[nodiscard]] std::uint64_t wrong() const { return wrong_; }
  /// Returns the first wrong cases, of each kind in turn, in the order of their numbers.
  [[nodiscard]] std::vector<JudgedCase> shown() const;
  /// Tells whether every promise is kept: no result is wrong and, where the error is bounded, no
  /// pair of results is in the wrong order or breaks the symmetry.
  [[nodiscard]] bool is_right() const;
  /// Returns the counts of a kind, of results below 0 only if `negative_alone`.
  [[nodiscard]] KindTally tally(CaseKind kind, bool negative_alone) const;
  /// Empty if the subject gave no result in range.
  [[nodiscard]] const std::optional<LargestError>& largest_error() const { return largest_error_; }
  [[nodiscard]] const RuleTrial& trial() const { return trial_; }
  [[nodiscard]] const PortTrial& ports() const { return ports_; }
  [[nodiscard]] const IdiomTrial& idioms() const { return idioms_; }
  [[nodiscard]] const CommonTraits& common() const { return common_; }
  /// Returns k if every result in range is a multiple of 2^k units, though rounded results are not
  /// of 2^1; 0 if none is known.
  [[nodiscard]] int idle_bits() const;
  /// Empty unless the operation is a function.
  [[nodiscard]] const std::optional<Curve>& curve() const { return curve_; }

 private:
  /// Adds a case, with `read` set if the rule needs it.
  void add_read(const JudgedCase& one);

  Rules rules_;
  std::uint64_t cases_ = 0;
  std::uint64_t not_judged_ = 0;
  std::uint64_t wrong_ = 0;
  std::size_t max_shown_;
  std::array<FirstCases, case_kinds> first_wrong_;
  /// Every result in range, and every rounded one, as sets of bits.
  std::uint64_t said_bits_ = 0;
  std::uint64_t rounded_bits_ = 0;
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

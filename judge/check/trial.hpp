/// @file
/// Tests every rule on every case to find the rules that a subject follows.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "judge/check/judged_case.hpp"

namespace fixproof::check {

/// The number of cases that a rule applies to, and the cases where the subject breaks it.
struct RuleScore {
  std::uint64_t cases = 0;
  FirstCases exceptions;
  std::uint64_t negative_exceptions = 0;  ///< exceptions whose exact result is below 0
};

/// The rules with the fewest exceptions, as indices. Several tie if no case tells them apart.
struct BestRules {
  std::vector<std::size_t> rules;  ///< at least one
  RuleScore first;                 ///< of the first rule
};

class RuleTrial {
 public:
  explicit RuleTrial(const cases::Variant& variant) : variant_(variant) {}

  /// Adds a case. `negative` tells whether the exact result exists and is below 0.
  void add(const JudgedCase& one, bool negative);

  /// Returns the best of roundings(), judged on rounded results that fit a word.
  [[nodiscard]] BestRules rounding() const;
  /// Returns how many results in range are none of the two words around the exact result.
  [[nodiscard]] const RuleScore& faithful() const { return faithful_; }
  /// Returns how many of inexact results in range are the upper word.
  [[nodiscard]] std::uint64_t upper() const { return upper_; }
  [[nodiscard]] std::uint64_t inexact() const { return inexact_; }
  /// Returns the best of overflow_rules() of the format, judged on overflows under
  /// roundings()[rounding].
  [[nodiscard]] BestRules overflow(std::size_t rounding) const;
  /// Returns the best of no_result_rules() of the format, which must not be empty.
  [[nodiscard]] BestRules no_result(std::size_t rounding) const;

 private:
  static constexpr std::size_t rounding_count = 6;
  static constexpr std::size_t overflow_count = 6;
  static constexpr std::size_t max_no_result_count = 6;

  /// Adds a case to faithful().
  void add_faithful(const JudgedCase& one, bool negative);

  cases::Variant variant_;
  std::array<RuleScore, rounding_count> in_range_;
  RuleScore faithful_;
  std::uint64_t upper_ = 0;
  std::uint64_t inexact_ = 0;
  std::array<std::array<RuleScore, overflow_count>, rounding_count> overflows_;
  std::array<std::array<RuleScore, max_no_result_count>, rounding_count> no_results_;
};

}  // namespace fixproof::check

/// @file
/// Every rule tried on everything a subject says: which of them does it follow?
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "check/judged_case.hpp"

namespace fixproof::check {

/// How a rule does: on how many cases it has a say, and those on which the subject does not keep
/// it.
struct RuleScore {
  std::uint64_t cases = 0;
  FirstCases exceptions;
  std::uint64_t negative_exceptions = 0;  ///< of them, those whose exact result is below 0
};

/// The rules that a subject keeps best, by their places in the list of rules: several where the
/// cases cannot tell them apart, or tell as much against each.
struct BestRules {
  std::vector<std::size_t> rules;  ///< at least one
  RuleScore first;                 ///< of the first of them
};

class RuleTrial {
 public:
  explicit RuleTrial(cases::Operation operation);

  /// `negative`: whether there is an exact result and it is below 0.
  void add(const JudgedCase& one, bool negative);

  /// Of roundings(): judged by results that fit when rounded so.
  [[nodiscard]] BestRules rounding() const;
  /// Of overflow_rules(): judged by results that do not fit under a rounding of roundings().
  [[nodiscard]] BestRules overflow(std::size_t rounding) const;
  /// Of no_result_rules(), which must have any.
  [[nodiscard]] BestRules no_result(std::size_t rounding) const;

 private:
  static constexpr std::size_t rounding_count = 5;
  static constexpr std::size_t overflow_count = 6;
  static constexpr std::size_t most_no_result_count = 6;

  cases::Operation operation_;
  std::array<RuleScore, rounding_count> in_range_;
  std::array<std::array<RuleScore, overflow_count>, rounding_count> overflows_;
  std::array<std::array<RuleScore, most_no_result_count>, rounding_count> no_results_;
};

}  // namespace fixproof::check

#include "check/trial.hpp"

#include <algorithm>
#include <span>

namespace fixproof::check {

namespace {

void score(RuleScore& rule, bool kept, const JudgedCase& one, bool negative) {
  ++rule.cases;
  if (kept) return;
  rule.exceptions.add(one);
  if (negative) ++rule.negative_exceptions;
}

BestRules best_of(std::span<const RuleScore> scores) {
  const auto fewer = [](const RuleScore& a, const RuleScore& b) {
    return a.exceptions.count() < b.exceptions.count();
  };
  const auto best = std::min_element(scores.begin(), scores.end(), fewer);
  BestRules result{{}, *best};
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (!fewer(*best, scores[i])) result.rules.push_back(i);
  }
  return result;
}

}  // namespace

RuleTrial::RuleTrial(cases::Operation operation) : operation_(operation) {}

void RuleTrial::add(const JudgedCase& one, bool negative) {
  for (std::size_t r = 0; r < rounding_count; ++r) {
    const oracle::Rounding rounding = roundings()[r];
    const auto ulps = rounded_result(operation_, one.words, rounding);
    if (!ulps) {
      const auto rules = no_result_rules(operation_);
      for (std::size_t i = 0; i < rules.size(); ++i) {
        score(no_results_.at(r).at(i), keeps(rules[i], one.words, rounding, one.said), one,
              negative);
      }
    } else if (fits_word(*ulps)) {
      score(in_range_.at(r), one.said == static_cast<std::uint32_t>(*ulps), one, negative);
    } else {
      for (std::size_t i = 0; i < overflow_count; ++i) {
        score(overflows_.at(r).at(i), keeps(overflow_rules()[i], *ulps, one.said), one, negative);
      }
    }
  }
}

BestRules RuleTrial::rounding() const { return best_of(in_range_); }

BestRules RuleTrial::overflow(std::size_t rounding) const {
  return best_of(overflows_.at(rounding));
}

BestRules RuleTrial::no_result(std::size_t rounding) const {
  return best_of(std::span(no_results_.at(rounding)).first(no_result_rules(operation_).size()));
}

}  // namespace fixproof::check

#include "judge/check/trial.hpp"

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

RuleTrial::RuleTrial(cases::Operation operation, const cases::Format& format)
    : operation_(operation), format_(format) {}

void RuleTrial::add(const JudgedCase& one, bool negative) {
  const auto overflows = overflow_rules(format_);
  const auto no_results = no_result_rules(operation_, format_);
  for (std::size_t r = 0; r < rounding_count; ++r) {
    const oracle::Rounding rounding = roundings()[r];
    const auto rounded = rounded_result(operation_, format_, one.values(), rounding);
    if (!rounded) {
      for (std::size_t i = 0; i < no_results.size(); ++i) {
        score(no_results_.at(r).at(i),
              keeps(no_results[i], format_, one.values(), rounding, one.said), one, negative);
      }
    } else if (rounded->fits) {
      score(in_range_.at(r), one.said == rounded->word, one, negative);
    } else {
      for (std::size_t i = 0; i < overflows.size(); ++i) {
        score(overflows_.at(r).at(i), keeps(overflows[i], format_, *rounded, one.said), one,
              negative);
      }
    }
  }
}

BestRules RuleTrial::rounding() const { return best_of(in_range_); }

BestRules RuleTrial::overflow(std::size_t rounding) const {
  return best_of(std::span(overflows_.at(rounding)).first(overflow_rules(format_).size()));
}

BestRules RuleTrial::no_result(std::size_t rounding) const {
  return best_of(
      std::span(no_results_.at(rounding)).first(no_result_rules(operation_, format_).size()));
}

}  // namespace fixproof::check

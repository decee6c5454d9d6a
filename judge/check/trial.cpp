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

void RuleTrial::add_faithful(const JudgedCase& one, bool negative) {
  const auto down = rounded_result(variant_, one.values(), oracle::Rounding::floor);
  const auto up = rounded_result(variant_, one.values(), oracle::Rounding::ceiling);
  if (!down || !down->fits || !up->fits) return;
  score(faithful_, one.said == down->word || one.said == up->word, one, negative);
  if (down->word == up->word) return;
  ++inexact_;
  if (one.said == up->word) ++upper_;
}

void RuleTrial::add(const JudgedCase& one, bool negative) {
  const auto overflows = overflow_rules(variant_.format);
  const auto no_results = no_result_rules(variant_);
  for (std::size_t r = 0; r < rounding_count; ++r) {
    const oracle::Rounding rounding = roundings()[r];
    const auto rounded = rounded_result(variant_, one.values(), rounding);
    if (!rounded) {
      for (std::size_t i = 0; i < no_results.size(); ++i) {
        score(no_results_.at(r).at(i),
              keeps(no_results[i], variant_.format, one.values(), rounding, one.said), one,
              negative);
      }
    } else if (rounded->fits) {
      score(in_range_.at(r), one.said == rounded->word, one, negative);
    } else {
      for (std::size_t i = 0; i < overflows.size(); ++i) {
        score(overflows_.at(r).at(i), keeps(overflows[i], variant_.format, *rounded, one.said), one,
              negative);
      }
    }
  }
  add_faithful(one, negative);
}

BestRules RuleTrial::rounding() const {
  // A half that is added and then cut looks like ceiling on most negative results, so a ceiling
  // with many exceptions is no guess. It is the last rounding.
  const RuleScore& ceiling = in_range_.back();
  const bool is_kept = 100 * ceiling.exceptions.count() <= ceiling.cases;
  return best_of(std::span(in_range_).first(is_kept ? rounding_count : rounding_count - 1));
}

BestRules RuleTrial::overflow(std::size_t rounding) const {
  return best_of(std::span(overflows_.at(rounding)).first(overflow_rules(variant_.format).size()));
}

BestRules RuleTrial::no_result(std::size_t rounding) const {
  return best_of(std::span(no_results_.at(rounding)).first(no_result_rules(variant_).size()));
}

}  // namespace fixproof::check

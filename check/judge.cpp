#include "check/judge.hpp"

#include <cmath>

namespace fixproof::check {

Judge::Judge(const Rules& rules, std::size_t max_shown)
    : rules_(rules), wrong_(max_shown), trial_(rules.operation) {}

void Judge::add(const JudgedCase& one) {
  const auto ulps = rounded_result(rules_.operation, one.words, rules_.rounding);
  const ExactPlace place = exact_place(rules_.operation, one.words);
  const bool in_range = ulps && fits_word(*ulps);
  const bool right = keeps(rules_, one.words, one.said);

  ++cases_;
  if (!in_range && !expected_of(rules_, one.words).judged) ++not_judged_;
  const auto kind = static_cast<std::size_t>(place.kind(ulps && !in_range));
  KindTally& tally = tallies_.at(kind).at(place.negative ? 1 : 0);
  ++tally.cases;
  if (!right) {
    ++tally.wrong;
    wrong_.add(one);
  }
  if (in_range && one.said) {
    const std::int64_t above_floor = static_cast<std::int32_t>(*one.said) - place.floor;
    const double off = std::fabs(static_cast<double>(above_floor) - place.fraction);
    if (!largest_error_ || off > largest_error_->ulps) largest_error_ = {off, one};
  }
  trial_.add(one, place.has_result && place.negative);
}

KindTally Judge::tally(CaseKind kind, bool negative_alone) const {
  const auto& [other, negative] = tallies_.at(static_cast<std::size_t>(kind));
  if (negative_alone) return negative;
  return {other.cases + negative.cases, other.wrong + negative.wrong};
}

}  // namespace fixproof::check

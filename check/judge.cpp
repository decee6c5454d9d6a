#include "check/judge.hpp"

#include <cmath>

namespace fixproof::check {

Judge::Judge(const Rules& rules, std::size_t max_shown)
    : rules_(rules),
      wrong_(max_shown),
      trial_(rules.operation),
      idioms_(rules.operation),
      common_(rules.operation) {}

void Judge::add(const JudgedCase& one) {
  const auto ulps = rounded_result(rules_.operation, one.words, rules_.rounding);
  const ExactPlace place = exact_place(rules_.operation, one.words);
  const bool in_range = ulps && fits_word(*ulps);
  const bool right = keeps(rules_, one.words, one.said);

  ++cases_;
  const Expected expected = expected_of(rules_, one.words);
  const CaseKind kind = place.kind(ulps && !in_range);
  if (expected.judged) {
    common_.add({one.words, place, kind, expected.said, one.said}, right);
  } else {
    ++not_judged_;
  }
  KindTally& tally = tallies_.at(static_cast<std::size_t>(kind)).at(place.negative ? 1 : 0);
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
  if (in_range) idioms_.add(one, right);
  trial_.add(one, place.has_result && place.negative);
}

KindTally Judge::tally(CaseKind kind, bool negative_alone) const {
  const auto& [other, negative] = tallies_.at(static_cast<std::size_t>(kind));
  if (negative_alone) return negative;
  return {other.cases + negative.cases, other.wrong + negative.wrong};
}

}  // namespace fixproof::check

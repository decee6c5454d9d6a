#include "judge/check/judge.hpp"

#include <cmath>

namespace fixproof::check {

namespace {

/// Returns the value of a - b in ulps.
double difference(std::uint64_t a, std::uint64_t b, const cases::Format& format) {
  // With the sign bit inverted, the words of a signed format are in the order of their values.
  const std::uint64_t flip = format.is_signed ? sign_bit(format) : 0;
  const bool below = (a ^ flip) < (b ^ flip);
  const std::uint64_t size = below ? (b ^ flip) - (a ^ flip) : (a ^ flip) - (b ^ flip);
  return below ? -static_cast<double>(size) : static_cast<double>(size);
}

}  // namespace

Judge::Judge(const Rules& rules, std::size_t max_shown)
    : rules_(rules),
      wrong_(max_shown),
      trial_(rules.operation, rules.format),
      ports_(rules.operation, rules.format),
      idioms_(rules.operation, rules.format),
      common_(rules.operation, rules.format) {
  if (cases::is_function(rules.operation)) {
    curve_.emplace(rules.format, cases::words_in(rules.operation));
  }
}

void Judge::add(const JudgedCase& one) {
  if (rules_.port == nullptr || !rules_.port->has_signed_fraction) return add_read(one);
  JudgedCase read = one;
  read.read_by(rules_);
  add_read(read);
}

void Judge::add_read(const JudgedCase& one) {
  const Operands operands = one.operands();
  const auto rounded =
      rounded_result(rules_.operation, rules_.format, one.values(), rules_.rounding);
  const ExactPlace place = exact_place(rules_.operation, rules_.format, one.values());
  const bool in_range = rounded && rounded->fits;
  const bool right = keeps(rules_, operands, rounded, one.said);

  ++cases_;
  const Expected expected = expected_of(rules_, operands, rounded);
  const CaseKind kind = place.kind(rounded && !in_range);
  if (expected.judged) {
    common_.add({one.read.value_or(one.words), place, kind, expected.said, one.said, rules_.format},
                right);
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
    // The floor itself may lie below the range, so the distance is measured from the rounded
    // result.
    const double up = rounded->word == place.floor.word ? 0 : 1;
    const double off =
        std::fabs(difference(*one.said, rounded->word, rules_.format) + up - place.fraction);
    if (!largest_error_ || off > largest_error_->ulps) largest_error_ = {off, one};
    if (curve_) curve_->add(one, off, rounded->word);
  }
  if (in_range) idioms_.add(one, right);
  ports_.add(one);
  trial_.add(one, place.has_result && place.negative);
}

KindTally Judge::tally(CaseKind kind, bool negative_alone) const {
  const auto& [other, negative] = tallies_.at(static_cast<std::size_t>(kind));
  if (negative_alone) return negative;
  return {other.cases + negative.cases, other.wrong + negative.wrong};
}

}  // namespace fixproof::check

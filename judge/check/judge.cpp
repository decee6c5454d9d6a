#include "judge/check/judge.hpp"

#include <algorithm>
#include <bit>
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
      max_shown_(max_shown),
      trial_(rules.variant),
      ports_(rules.variant),
      idioms_(rules.variant),
      common_(rules.variant) {
  first_wrong_.fill(FirstCases(max_shown));
  if (cases::is_function(rules.variant.operation)) curve_.emplace(rules.variant);
}

void Judge::add(const JudgedCase& one) {
  if (rules_.port == nullptr || !rules_.port->has_signed_fraction) return add_read(one);
  JudgedCase read = one;
  read.read_by(rules_);
  add_read(read);
}

void Judge::add_read(const JudgedCase& one) {
  const cases::Format& format = rules_.variant.format;
  const Operands operands = one.operands();
  const auto rounded = rounded_result(rules_.variant, one.values(), rules_.rounding);
  const ExactPlace place = exact_place(rules_.variant, one.values());
  const bool in_range = rounded && rounded->fits;
  const bool right = keeps(rules_, operands, rounded, one.said);

  ++cases_;
  const Expected expected = expected_of(rules_, operands, rounded);
  const CaseKind kind = place.kind(rounded && !in_range);
  if (expected.judged) {
    common_.add({one.read.value_or(one.words), place, kind, expected.said, one.said, format,
                 operand_format(rules_.variant)},
                right);
  } else {
    ++not_judged_;
  }
  KindTally& tally = tallies_.at(static_cast<std::size_t>(kind)).at(place.negative ? 1 : 0);
  ++tally.cases;
  if (!right) {
    ++tally.wrong;
    ++wrong_;
    first_wrong_.at(static_cast<std::size_t>(kind)).add(one);
  }
  if (in_range && one.said && is_word(*one.said, format)) {
    said_bits_ |= *one.said;
    rounded_bits_ |= rounded->word;
    // The floor itself may lie below the range, so the distance is measured from the rounded
    // result.
    const double up = rounded->word == place.floor.word ? 0 : 1;
    const double off =
        std::fabs(difference(*one.said, rounded->word, format) + up - place.fraction);
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

std::vector<JudgedCase> Judge::shown() const {
  std::vector<const FirstCases*> kinds;
  for (const FirstCases& first : first_wrong_) {
    if (!first.shown().empty()) kinds.push_back(&first);
  }
  std::ranges::sort(kinds, {},
                    [](const FirstCases* first) { return first->shown().front().number; });
  std::vector<JudgedCase> cases;
  for (std::size_t i = 0; i < max_shown_ && cases.size() < max_shown_; ++i) {
    for (const FirstCases* first : kinds) {
      if (i < first->shown().size() && cases.size() < max_shown_) {
        cases.push_back(first->shown()[i]);
      }
    }
  }
  std::ranges::sort(cases, {}, &JudgedCase::number);
  return cases;
}

bool Judge::is_right() const {
  if (wrong_ != 0) return false;
  const auto figures = rules_.within && curve_ ? curve_->figures() : std::nullopt;
  return !figures || (figures->order.wrong == 0 && figures->symmetry.wrong == 0);
}

int Judge::idle_bits() const {
  // So few results are multiples by chance.
  constexpr std::uint64_t fewest = 20;
  const KindTally overflows = tally(CaseKind::overflow, false);
  const KindTally missing = tally(CaseKind::no_result, false);
  if (cases_ - overflows.cases - missing.cases < fewest || said_bits_ == 0 ||
      rounded_bits_ % 2 == 0) {
    return 0;
  }
  return std::countr_zero(said_bits_);
}

}  // namespace fixproof::check

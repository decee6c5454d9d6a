#include "judge/check/fitting.hpp"

namespace fixproof::check {

Rules fitting_rules(const Judge& guess) {
  Rules rules = guess.rules();
  const BestRules best = guess.trial().rounding();
  rules.rounding = roundings()[best.rules.front()];
  const auto ports = guess.ports().followed();
  const bool is_open = rules.overflow == Overflow::any && rules.no_result == NoResult::any;
  if (is_open && best.first.exceptions.count() > 0 && !ports.empty()) {
    return rules_of(*ports.front(), rules.variant.format);
  }
  return rules;
}

}  // namespace fixproof::check

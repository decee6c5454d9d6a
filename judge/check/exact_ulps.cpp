#include "judge/check/exact_ulps.hpp"

#include "verify/cases/exact_value.hpp"
#include "verify/cases/value.hpp"

namespace fixproof::check {

std::optional<oracle::Integer> exact_ulps(const cases::Variant& variant, const Operands& operands,
                                          oracle::Rounding rule) {
  const ValuedCase* valued = operands.valued();
  const auto value =
      valued != nullptr ? valued->value : cases::exact_value(variant, operands.words()).value;
  if (!value) return std::nullopt;
  return cases::to_ulps(*value, rule, variant.format);
}

}  // namespace fixproof::check

#include "judge/check/exact_ulps.hpp"

#include "judge/check/word.hpp"
#include "oracle/format.hpp"
#include "oracle/whole_function.hpp"

namespace fixproof::check {

std::optional<oracle::Integer> exact_ulps(const cases::Variant& variant, const Operands& operands,
                                          oracle::Rounding rule) {
  if (const Converted* converted = operands.converted()) {
    if (!converted->value) return std::nullopt;
    return to_ulps(*converted->value, rule, variant.format);
  }
  const auto words = operands.words();
  const auto wide = variant.format.as<oracle::Format>();
  switch (variant.operation) {
    case cases::Operation::mul:
      return oracle::exact_product(words[0], words[1], rule, wide);
    case cases::Operation::div:
      return oracle::exact_quotient(words[0], words[1], rule, wide);
    case cases::Operation::sqrt:
      return oracle::exact_root(words[0], rule, wide);
    case cases::Operation::add:
      return oracle::ulps(words[0], wide) + oracle::ulps(words[1], wide);
    case cases::Operation::sub:
      return oracle::ulps(words[0], wide) - oracle::ulps(words[1], wide);
    case cases::Operation::fmod:
      return oracle::truncated_remainder(oracle::ulps(words[0], wide),
                                         oracle::ulps(words[1], wide));
    case cases::Operation::remainder:
      return oracle::nearest_remainder(oracle::ulps(words[0], wide), oracle::ulps(words[1], wide));
    default:
      refuse_operation();
  }
}

}  // namespace fixproof::check

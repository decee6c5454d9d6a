/// @file
/// The exact values of operations whose operands and results have any formats, decimal scales among
/// them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "oracle/decimal.hpp"
#include "verify/cases/variant.hpp"

namespace fixproof::cases {

struct ExactValue {
  /// Empty without a result: a zero divisor, a negative radicand, outside a domain. An irrational
  /// value is off by at most 2^-200, and on the right side of every word and tie.
  std::optional<oracle::Ratio> value;
  /// Of a negative radicand: minus the root of its magnitude.
  std::optional<oracle::Ratio> mirrored{};
  /// Without a value: the sign of what is divided by zero, or of the radicand.
  int sign = 0;
};

/// Returns the exact value of an operation on words, other than a conversion of doubles or text.
/// @throws std::invalid_argument for an operation that is not judged
ExactValue exact_value(const cases::Variant& variant, std::span<const std::uint64_t> words);

}  // namespace fixproof::cases

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "oracle/unbounded.hpp"

/// Numbers from outside brought to ulps, and words written out, exactly. Every function throws
/// std::invalid_argument unless `fraction_bits` is 2 ... 16.
namespace oracle {

/// The number a text denotes, in ulps, rounded once from its exact value. The text is an optional
/// sign, digits and at most one point, with a digit on at least one side of it, and nothing else;
/// empty for any other text.
[[nodiscard]] std::optional<Integer> from_decimal(std::string_view text, Rounding rule,
                                                  int fraction_bits);

/// A double in ulps, rounded once from its exact value; empty for NaN and the infinities.
[[nodiscard]] std::optional<Integer> from_double(double value, Rounding rule, int fraction_bits);

/// The exact value of a word: a minus sign if negative, the whole part, and, unless the fraction is
/// 0, a point and its digits without trailing zeros.
[[nodiscard]] std::string to_decimal(Word word, int fraction_bits);

}  // namespace oracle

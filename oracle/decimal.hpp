#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "oracle/unbounded.hpp"

/// Exact conversion of numbers to ulps and of words to text. Every function throws
/// std::invalid_argument unless `fraction_bits` is 2 ... 16.
namespace oracle {

/// The number in a text, in ulps, rounded once. The text is an optional sign, digits and at most
/// one point, with a digit on at least one side of it; empty for any other text.
[[nodiscard]] std::optional<Integer> from_decimal(std::string_view text, Rounding rule,
                                                  int fraction_bits);

/// A double in ulps, rounded once; empty for NaN and the infinities.
[[nodiscard]] std::optional<Integer> from_double(double value, Rounding rule, int fraction_bits);

/// The exact value of a word: a minus sign if negative, the whole part and, unless the fraction is
/// 0, a point and the digits without trailing zeros.
[[nodiscard]] std::string to_decimal(Word word, int fraction_bits);

}  // namespace oracle

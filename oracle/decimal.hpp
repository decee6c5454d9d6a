#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "oracle/format.hpp"

/// Exact conversion of numbers to ulps and of words to text. Every function that takes
/// `fraction_bits` throws std::invalid_argument unless it is 2 ... 16.
namespace oracle {

/// An exact rational number.
struct Ratio {
  Integer numerator;
  Integer denominator = 1;  ///< above 0
};

/// The number in a text: an optional sign, digits and at most one point, with a digit on at least
/// one side of it; empty for any other text.
[[nodiscard]] std::optional<Ratio> decimal_value(std::string_view text);

/// The value of a double; empty for NaN and the infinities.
[[nodiscard]] std::optional<Ratio> double_value(double value);

/// A number in ulps of 2^-fraction_bits, rounded once, for 0 or more fraction bits.
[[nodiscard]] Integer to_ulps(const Ratio& value, Rounding rule, int fraction_bits);

/// The number in a text of decimal_value(), in ulps, rounded once; empty for any other text.
[[nodiscard]] std::optional<Integer> from_decimal(std::string_view text, Rounding rule,
                                                  int fraction_bits);

/// A double in ulps, rounded once; empty for NaN and the infinities.
[[nodiscard]] std::optional<Integer> from_double(double value, Rounding rule, int fraction_bits);

/// The exact value of a word: a minus sign if negative, the whole part and, unless the fraction is
/// 0, a point and the digits without trailing zeros.
[[nodiscard]] std::string to_decimal(Word word, int fraction_bits);

}  // namespace oracle

#pragma once

#include "oracle/rule.hpp"

/// oracle::sin and oracle::cos again, for sweeps of all 2^32 words. Neither pi nor a series: an
/// angle is the sum of its four bytes, so that its cosine and sine are the product of four complex
/// numbers, which stand in tables. Both functions throw std::invalid_argument unless
/// `fraction_bits` is 2 ... 16.
namespace oracle::fast {

/// The sine of an angle in radians, rounded to nearest.
[[nodiscard]] Word sin(Word angle, int fraction_bits);

/// The cosine of an angle in radians, rounded to nearest.
[[nodiscard]] Word cos(Word angle, int fraction_bits);

}  // namespace oracle::fast

#pragma once

#include "oracle/rule.hpp"

/// A faster oracle::sin and oracle::cos, for sweeps of all 2^32 words. Uses neither pi nor a
/// series: an angle is the sum of its four bytes, so its cosine and sine are the product of four
/// complex numbers from tables. Both functions throw std::invalid_argument unless `fraction_bits`
/// is 2 ... 16.
namespace oracle::fast {

/// The sine of an angle in radians, rounded to nearest.
[[nodiscard]] Word sin(Word angle, int fraction_bits);

/// The cosine of an angle in radians, rounded to nearest.
[[nodiscard]] Word cos(Word angle, int fraction_bits);

}  // namespace oracle::fast

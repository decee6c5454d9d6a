#pragma once

#include <cstdint>

#include "oracle/integer.hpp"
#include "oracle/rule.hpp"

/// Irrational results to any number of binary digits, for measuring errors far below one ulp. Each
/// is in ulps of 16.16 times 2^digits, rounded down; `digits` is 0 ... 60.
namespace oracle {

/// The square root of a non-negative word; throws std::domain_error for any other.
[[nodiscard]] Integer scaled_sqrt(Word x, int digits);

/// The cosine of an angle in tenths of a degree.
[[nodiscard]] Integer scaled_cos(std::int32_t angle_tenths, int digits);

/// The sine of an angle in radians, itself a 16.16 word.
[[nodiscard]] Integer scaled_sin_of_radians(Word angle, int digits);

/// The cosine of an angle in radians, itself a 16.16 word.
[[nodiscard]] Integer scaled_cos_of_radians(Word angle, int digits);

}  // namespace oracle

#pragma once

#include "oracle/integer.hpp"

namespace oracle {

/// The angle of the vector (x, y) in units of 2^-fraction_bits, from -pi to pi, rounded to nearest;
/// 0 for the vector 0.
/// @throws std::range_error if 168 bits cannot decide the rounding
[[nodiscard]] Integer nearest_angle(const Integer& y, const Integer& x, int fraction_bits);

}  // namespace oracle

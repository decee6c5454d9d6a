#pragma once

#include "oracle/function.hpp"
#include "oracle/integer.hpp"

namespace oracle {

/// Whether the function of x / 2^fraction_bits, or of that and y / 2^fraction_bits, is exactly
/// twice / 2 ulps. Decides with integers. False for a function that has no ties in any format.
/// @pre `twice` is odd, and the operands are in the domain
[[nodiscard]] bool is_tie(Function function, const Integer& x, const Integer& y,
                          const Integer& twice, int fraction_bits);

}  // namespace oracle

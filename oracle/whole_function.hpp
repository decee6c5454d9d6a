#pragma once

#include <optional>

#include "oracle/decimal.hpp"
#include "oracle/integer.hpp"
#include "oracle/rule.hpp"

/// Functions that integers decide: remainders, the quotient of a product, and the length of a
/// vector. Operands and results are ulps, and the same for every number of fraction bits, because
/// the unit cancels.
namespace oracle {

/// n - d * q, where q is n / d truncated toward zero. Empty if and only if d is 0.
[[nodiscard]] std::optional<Integer> truncated_remainder(const Integer& n, const Integer& d);

/// n - d * q, where q is the integer nearest to n / d, ties to even. Empty if and only if d is 0.
[[nodiscard]] std::optional<Integer> nearest_remainder(const Integer& n, const Integer& d);

/// a * b / c. Empty if and only if c is 0.
[[nodiscard]] std::optional<Integer> product_quotient(const Integer& a, const Integer& b,
                                                      const Integer& c, Rounding rule);

/// The square root of x^2 + y^2 + z^2, to nearest. There are no ties, because the square of a
/// half-integer is not an integer.
[[nodiscard]] Integer nearest_length(const Integer& x, const Integer& y, const Integer& z);

/// The same, not rounded if it is whole; otherwise rounded down to a multiple of 2^-220. For
/// operands of at most 64 bits, half-integers are farther than that from an irrational length.
[[nodiscard]] Ratio length_of(const Integer& x, const Integer& y, const Integer& z);

}  // namespace oracle

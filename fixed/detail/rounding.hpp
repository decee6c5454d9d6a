/// \file
/// The integer arithmetic of the rounding rules; nothing else implements them.
#pragma once

#include <limits>

#include "fixed/policy.hpp"

namespace fixproof::detail {

/// The bias to add before a floor division by `unit`, so that the quotient is rounded by rule R.
/// \param negative whether the value is below zero
/// \param unit     even and positive, so that a half is a whole number of parts
template <rounding R, class Int>
constexpr Int bias(bool negative, Int unit) noexcept {
  if constexpr (R == rounding::half_up) {
    return unit / 2;
  } else if constexpr (R == rounding::half_away) {
    return unit / 2 - Int{negative};
  } else if constexpr (R == rounding::truncate) {
    return negative ? unit - 1 : Int{0};
  } else {
    static_assert(R == rounding::floor);
    return 0;
  }
}

/// value / 2^bits, rounded by rule R. \pre value + 2^bits does not overflow
template <rounding R, class Int>
constexpr Int shift_right(Int value, int bits) noexcept {
  static_assert(std::numeric_limits<Int>::is_signed);
  return (value + bias<R>(value < 0, Int{1} << bits)) >> bits;
}

/// numerator / divisor toward -infinity, for a positive divisor.
template <class Int>
constexpr Int floor_divide(Int numerator, Int divisor) noexcept {
  return numerator / divisor - Int{numerator % divisor < 0};
}

}  // namespace fixproof::detail

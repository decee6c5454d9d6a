/// @file
/// Square roots in another unit.
#pragma once

#include <cstdint>

#include "fixed/detail/rounding.hpp"
#include "fixed/detail/square_root.hpp"
#include "fixed/detail/wide_integer.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// The integer nearest to sqrt(n), for 0 <= n < 2^Bits. @pre Wide has three bits more, and a sign
template <int Bits, class Wide>
constexpr Wide nearest_sqrt_below(const Wide& n) noexcept {
  if constexpr (Bits <= 64) {
    return static_cast<Wide>(nearest_sqrt_of_word(static_cast<std::uint64_t>(n)));
  } else {
    return nearest_sqrt_by_pairs<(Bits + 1) / 2>(n);
  }
}

/// sqrt(n 2^Shift) by rule Rounding, for 0 <= n < 2^Bits.
///
/// A left shift leaves an integer, whose root is no tie (see nearest_sqrt_in_words()). A right
/// shift is two places shorter, so that the root is in halves of the unit. It is rounded down. If
/// it is odd, the exact root is a half or more above the unit below. It is the half itself only if
/// the square of the rounded root has all bits of n.
/// @pre Wide has max(Shift, 1) + 3 bits more than n, and a sign
template <rounding Rounding, int Shift, int Bits, class Wide>
constexpr Wide rounded_scaled_sqrt(const Wide& n) noexcept {
  if constexpr (Shift >= 0) {
    const Wide scaled = n << Shift;
    return rounded_root<Rounding>(nearest_sqrt_below<Bits + Shift>(scaled), scaled);
  } else {
    constexpr int up = Shift == -1 ? 1 : 0;
    constexpr int down = larger(-Shift - 2, 0);
    const Wide quarters = n << up >> down;
    const Wide nearest = nearest_sqrt_below<larger(Bits + up - down, 1)>(quarters);
    const Wide square = nearest * nearest;
    const Wide halves = quarters < square ? nearest - Wide{1} : nearest;
    const Wide floor = halves >> 1;
    const bool is_exact = square == quarters && quarters << down == n << up;
    if constexpr (is_to_nearest<Rounding>) {
      const bool goes_up = !is_exact || Rounding != rounding::half_even || is_odd(floor);
      return floor + Wide{is_odd(halves) && goes_up};
    } else {
      return floor + Wide{Rounding == rounding::ceiling && (!is_exact || is_odd(halves))};
    }
  }
}

}  // namespace fixproof::detail

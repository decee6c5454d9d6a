/// @file
/// Rounds a result whose error has a bound.
#pragma once

#include <cstdint>

#include "fixed/detail/assert.hpp"

namespace fixproof::detail {

/// The highest number of fraction bits for which functions try a quick result with a larger error
/// first.
inline constexpr int quick_bits = 16;

/// The integers nearest to the ends of an interval. If they are equal, every value between rounds
/// to that integer.
struct nearest_ends {
  std::int64_t low;
  std::int64_t high;

  [[nodiscard]] constexpr bool agree() const noexcept { return low == high; }
};

/// Whether a sum has this half, less a bit, without an overflow of Int.
template <class Int>
constexpr bool has_room(const Int& half) noexcept {
  const Int top = half >> (8 * static_cast<int>(sizeof(Int)) - 2);
  return top == Int{0} || top == Int{-1};
}

/// The ends of value +- error in units of 2^-bits. @pre bits > 0, error >= 0; Int has both ends,
/// and std::int64_t has both in units of 2^(bits - 1)
template <class Int>
constexpr nearest_ends nearest_within(Int value, Int error, int bits) noexcept {
  FIXED_ASSERT(!(error < Int{0}) && has_room((value >> 1) + ((error >> 1) + Int{1})) &&
               has_room((value >> 1) - ((error >> 1) + Int{1})));
  const auto nearest = [bits](Int end) {
    const Int halves = end >> (bits - 1);
    FIXED_ASSERT(Int{static_cast<std::int64_t>(halves)} == halves);
    return (static_cast<std::int64_t>(halves) + 1) >> 1;
  };
  return {nearest(value - error), nearest(value + error)};
}

}  // namespace fixproof::detail

/// @file
/// Rounds a result whose error has a bound.
#pragma once

#include <cstdint>

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

/// The ends of value +- error in units of 2^-bits. @pre bits > 0
template <class Int>
constexpr nearest_ends nearest_within(Int value, Int error, int bits) noexcept {
  const auto nearest = [bits](Int end) {
    return (static_cast<std::int64_t>(end >> (bits - 1)) + 1) >> 1;
  };
  return {nearest(value - error), nearest(value + error)};
}

}  // namespace fixproof::detail

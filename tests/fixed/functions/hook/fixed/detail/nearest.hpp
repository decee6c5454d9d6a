/// @file
/// The rounding of fixed/detail/nearest.hpp, which also remembers how near the value is to a tie.
#pragma once

#include <cstdint>
#include <type_traits>

namespace fixproof::detail {

/// The highest number of fraction bits for which functions try a quick result with a larger error
/// first. It is 0 while the distance matters, because that of a quick result is not exact enough.
inline thread_local int quick_bits = 0;

/// The distance of the last value from a tie in units of 2^-40 ulps.
inline thread_local std::int64_t last_distance = 0;

struct nearest_ends {
  std::int64_t low;
  std::int64_t high;

  [[nodiscard]] constexpr bool agree() const noexcept { return low == high; }
};

template <class Int>
constexpr nearest_ends nearest_within(Int value, Int error, int bits) noexcept {
  const auto nearest = [bits](Int end) {
    return (static_cast<std::int64_t>(end >> (bits - 1)) + 1) >> 1;
  };
  if (!std::is_constant_evaluated()) {
    const Int tie = Int{1} << (bits - 1);
    const Int fraction = value - (value >> bits << bits);
    const Int distance = fraction < tie ? tie - fraction : fraction - tie;
    last_distance =
        static_cast<std::int64_t>(bits < 40 ? distance << (40 - bits) : distance >> (bits - 40));
  }
  return {nearest(value - error), nearest(value + error)};
}

}  // namespace fixproof::detail

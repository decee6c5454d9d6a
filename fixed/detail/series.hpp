/// @file
/// Polynomials by Horner's rule in fractions of 64 bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fixed/detail/wide_integer.hpp"

namespace fixproof::detail {

// Recursions, because compilers do not unroll every loop.

/// c0 + x (c1 + x (c2 + ...)) with the first `Terms` coefficients from `First` on, for x in units
/// of 2^-64. Each product is rounded down.
template <std::size_t Terms, std::size_t First = 0, std::size_t Size>
constexpr std::uint64_t sum_of_series(const std::array<std::uint64_t, Size>& c,
                                      std::uint64_t x) noexcept {
  if constexpr (First + 1 == Terms) {
    return c[First];
  } else {
    return c[First] + multiply_high(x, sum_of_series<Terms, First + 1>(c, x));
  }
}

/// c0 - x (c1 - x (c2 - ...)), as sum_of_series().
template <std::size_t Terms, std::size_t First = 0, std::size_t Size>
constexpr std::uint64_t sum_of_alternating_series(const std::array<std::uint64_t, Size>& c,
                                                  std::uint64_t x) noexcept {
  if constexpr (First + 1 == Terms) {
    return c[First];
  } else {
    return c[First] - multiply_high(x, sum_of_alternating_series<Terms, First + 1>(c, x));
  }
}

}  // namespace fixproof::detail

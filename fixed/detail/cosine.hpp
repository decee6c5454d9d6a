/// \file
/// A cosine with an error below 2^-56, in integers.
#pragma once

#include <cstdint>

#include "fixed/detail/wide_integer.hpp"

namespace fixproof::detail {

/// floor(a * b / 2^64).
constexpr std::uint64_t multiply_high(std::uint64_t a, std::uint64_t b) noexcept {
  return multiply_words(a, b).high;
}

/// pi/2 in units of 2^-62, to nearest.
inline constexpr std::uint64_t half_pi = 0x6487ed5110b4611a;

/// The cosine of an angle from 0 to pi/2, both in units of 2^-62. The error is below 2^-56 even if
/// the angle is 4 units off.
///
/// Horner's form of the Taylor series, 1 - x^2/(1*2) (1 - x^2/(3*4) (1 - ...)), for x^2 < 2.5.
/// Thirteen terms leave a remainder below 2^-65; each step loses less than 4 units, and x^2 is
/// within 4 + 4 pi.
constexpr std::int64_t cosine(std::uint64_t angle) noexcept {
  constexpr std::uint64_t one = std::uint64_t{1} << 62;
  const std::uint64_t square = multiply_high(angle, angle) << 2;
  std::uint64_t factor = one;
  for (std::uint64_t n = 25; n > 1; n -= 2) {
    const std::uint64_t term = (multiply_high(square, factor) << 2) / (n * (n + 1));
    factor = one - term;
  }
  return static_cast<std::int64_t>(one) -
         static_cast<std::int64_t>(multiply_high(square, factor) << 1);
}

}  // namespace fixproof::detail

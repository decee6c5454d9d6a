/// \file
/// Cosines of the first quadrant, computed by the compiler in integers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fixed/detail/storage.hpp"

namespace fixed::detail {

/// floor(a * b / 2^64).
constexpr std::uint64_t multiply_high(std::uint64_t a, std::uint64_t b) noexcept {
  constexpr std::uint64_t low_half = 0xffffffff;
  const std::uint64_t a0 = a & low_half;
  const std::uint64_t a1 = a >> 32;
  const std::uint64_t b0 = b & low_half;
  const std::uint64_t b1 = b >> 32;
  const std::uint64_t middle = a1 * b0 + (a0 * b0 >> 32);
  const std::uint64_t carry = ((middle & low_half) + a0 * b1) >> 32;
  return a1 * b1 + (middle >> 32) + carry;
}

/// cos(step / steps * pi / 2) in units of 2^-62, within 2^-56, for 0 <= step <= steps < 2^31.
///
/// Horner's form of the Taylor series, 1 - x^2/(1*2) (1 - x^2/(3*4) (1 - ...)), for x^2 < 2.5 in
/// units of 2^-62. Thirteen terms leave less than 2^-65 out; each step loses less than 4 units, and
/// x^2, from pi/2 in 62 bits, is within 12.
constexpr std::int64_t cosine(std::uint64_t step, std::uint64_t steps) noexcept {
  constexpr std::uint64_t one = std::uint64_t{1} << 62;
  constexpr std::uint64_t half_pi = 0x6487ed5110b4611a;  // pi/2 * 2^62, to nearest
  const std::uint64_t angle = half_pi / steps * step + half_pi % steps * step / steps;
  const std::uint64_t square = multiply_high(angle, angle) << 2;
  std::uint64_t factor = one;
  for (std::uint64_t n = 25; n > 1; n -= 2) {
    const std::uint64_t term = (multiply_high(square, factor) << 2) / (n * (n + 1));
    factor = one - term;
  }
  return static_cast<std::int64_t>(one) -
         static_cast<std::int64_t>(multiply_high(square, factor) << 1);
}

/// Not constexpr: a constant expression that comes here does not compile.
inline void cosine_is_not_precise_enough() {}

/// Entry i is cos(i / StepsPerDegree degrees), from 0 to 90 degrees, rounded to nearest. An entry
/// so near to a half that the error of cosine() could matter would not compile.
template <int FractionBits, int StepsPerDegree>
inline constexpr auto cosine_table = [] {
  constexpr std::size_t last = std::size_t{90} * StepsPerDegree;
  constexpr int dropped = 62 - FractionBits;
  constexpr std::int64_t half = std::int64_t{1} << (dropped - 1);
  constexpr std::int64_t error = std::int64_t{1} << (62 - 56);
  std::array<std::int32_t, last + 1> table{};
  for (std::size_t i = 0; i < last; ++i) {
    const std::int64_t exact = cosine(i, last);
    table[i] = static_cast<std::int32_t>((exact + half) >> dropped);
    if (((exact - error + half) >> dropped) != ((exact + error + half) >> dropped)) {
      cosine_is_not_precise_enough();
    }
  }
  return table;
}();

}  // namespace fixed::detail

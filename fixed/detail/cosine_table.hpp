/// @file
/// Sines and cosines of whole steps, computed at compile time in integers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fixed/detail/cosine.hpp"
#include "fixed/detail/gpu.hpp"
#include "fixed/detail/storage.hpp"

namespace fixproof::detail {

/// cos(step / steps * pi / 2) in units of 2^-62, for 0 <= step <= steps < 2^31. The error is below
/// 2^-56.
constexpr std::int64_t cosine(std::uint64_t step, std::uint64_t steps) noexcept {
  return cosine(half_pi / steps * step + half_pi % steps * step / steps);
}

/// Not constexpr, so that a constant expression that calls it does not compile.
inline void cosine_is_not_precise_enough() {}

/// Entry i is cos(i / StepsPerDegree degrees), from 0 to 90 degrees, rounded to nearest. Does not
/// compile if the error of cosine() could change the rounding of an entry.
template <int FractionBits, int StepsPerDegree>
FIXED_CONSTANT auto cosine_table = [] {
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

/// Entry i is sin(i / StepsPerDegree degrees), from 0 to 270 degrees, rounded to nearest. So entry
/// i and the one 90 degrees later are the sine and the cosine of half a turn.
template <int FractionBits, int StepsPerDegree>
FIXED_CONSTANT auto sine_table = [] {
  constexpr const auto& cosines = cosine_table<FractionBits, StepsPerDegree>;
  constexpr std::size_t quarter = cosines.size() - 1;
  std::array<std::int32_t, 3 * quarter + 1> table{};
  for (std::size_t i = 0; i <= quarter; ++i) {
    table[i] = cosines[quarter - i];
    table[quarter + i] = cosines[i];
    table[2 * quarter + i] = -cosines[quarter - i];
  }
  return table;
}();

}  // namespace fixproof::detail

/// @file
/// The cosine table that CosSin reads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace x86model {

namespace detail {

__extension__ typedef __int128 Wide;  // NOLINT(modernize-use-using): __extension__ needs typedef

/// Fraction bits of the series. The table needs 28 correct bits (one cosine lies within 0.0006 of a
/// tie); the series gives more than 55.
inline constexpr int series_bits = 61;

/// pi in units of 2^-61: its first 63 binary digits, rounded.
inline constexpr std::int64_t pi = 0x6487ED5110B4611A;

/// cos(x) for 0 <= x <= pi/2, in units of 2^-61, by the Taylor series.
constexpr std::int64_t cosine(std::int64_t x) {
  const auto times = [](std::int64_t a, std::int64_t b) {
    return static_cast<std::int64_t>((Wide{a} * b) >> series_bits);
  };
  const std::int64_t x_squared = times(x, x);
  std::int64_t term = std::int64_t{1} << series_bits;
  std::int64_t sum = term;
  for (std::int64_t n = 1; term != 0; n += 2) {
    term = -times(term, x_squared) / (n * (n + 1));
    sum += term;
  }
  return sum;
}

}  // namespace detail

/// Cosines of 0 to 90 degrees, each rounded to the nearest 16.16 value.
/// @tparam steps_per_degree entries per degree: 10 for CosSin
template <std::size_t steps_per_degree>
constexpr std::array<std::uint32_t, 90 * steps_per_degree + 1> make_cosine_table() {
  std::array<std::uint32_t, 90 * steps_per_degree + 1> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto angle =
        static_cast<std::int64_t>(detail::Wide{detail::pi} * static_cast<std::int64_t>(i) /
                                  (detail::Wide{180} * steps_per_degree));
    constexpr int surplus = detail::series_bits - 16;
    const std::int64_t half = std::int64_t{1} << (surplus - 1);
    table[i] = static_cast<std::uint32_t>((detail::cosine(angle) + half) >> surplus);
  }
  return table;
}

inline constexpr auto cosine_table = make_cosine_table<10>();

}  // namespace x86model

/// @file
/// The exact decimal text of stored integers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "fixed/detail/storage.hpp"
#include "fixed/detail/wide_integer.hpp"

namespace fixproof::detail {

/// floor(bits * log10(2)), for 0 <= bits <= 64.
constexpr int decimal_digits(int bits) noexcept { return bits * 30103 / 100000; }

/// The longest decimal text: sign, whole part, point, and one fraction digit per fraction bit.
template <class Raw, int FractionBits>
inline constexpr std::size_t max_decimal_chars =
    1 + decimal_digits(larger(bits_of<Raw> - FractionBits, 0)) + 1 + 1 + FractionBits;

/// Writes the exact value in its shortest form: "-0.5", "3", "0.0000152587890625".
/// @param out a buffer of max_decimal_chars
/// @return the end of the text
template <int FractionBits, class Raw>
constexpr char* write_decimal(char* out, Raw raw) noexcept {
  using word =
      std::conditional_t<(bits_of<Raw> <= 32 && FractionBits <= 28), std::uint32_t, std::uint64_t>;
  auto magnitude = static_cast<word>(raw);
  if (raw < 0) {
    *out++ = '-';
    magnitude = 0 - magnitude;
  }
  const auto digit = [&out](word value) { *out++ = static_cast<char>('0' + value); };
  constexpr bool has_whole = FractionBits < std::numeric_limits<word>::digits;
  // NOLINTNEXTLINE(bugprone-branch-clone): without fraction bits both are 0
  const word whole = has_whole ? magnitude >> (has_whole ? FractionBits : 0) : word{0};
  word power = 1;
  while (whole / power >= 10) power *= 10;
  for (; power != 0; power /= 10) digit(whole / power % 10);
  // NOLINTNEXTLINE(bugprone-branch-clone): likewise
  word fraction = magnitude - (has_whole ? whole << (has_whole ? FractionBits : 0) : word{0});
  if (fraction != 0) *out++ = '.';
  if constexpr (FractionBits + 4 <= std::numeric_limits<word>::digits) {
    constexpr word one = word{1} << FractionBits;
    for (; fraction != 0; fraction = fraction * 10 % one) digit(fraction * 10 / one);
  } else {
    for (fraction <<= 64 - FractionBits; fraction != 0; fraction *= 10) {
      digit(multiply_words(fraction, 10).high);
    }
  }
  return out;
}

}  // namespace fixproof::detail

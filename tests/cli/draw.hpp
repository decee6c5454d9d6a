/// @file
/// Operands for tests: as many near the edges as anywhere else.
#pragma once

#include <cstdint>
#include <random>

namespace cli {

/// A word of `bits` bits: a power of two or one beside it, or random bits of a random length;
/// either, half of the time, negated.
inline std::uint32_t draw_word(std::mt19937_64& random, std::uint32_t bits) {
  const std::uint32_t mask = 0xFFFFFFFFU >> (32 - bits);
  const auto place = static_cast<std::uint32_t>(random() % bits);
  auto word = (static_cast<std::uint32_t>(random()) & mask) >> place;
  if (random() % 3 == 0) word = (1U << place) + static_cast<std::uint32_t>(random() % 3) - 1;
  return (random() % 2 == 0 ? word : 0U - word) & mask;
}

}  // namespace cli

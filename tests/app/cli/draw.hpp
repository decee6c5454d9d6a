/// @file
/// Draws operands for tests, many of them near powers of two.
#pragma once

#include <cstdint>

namespace command {

/// A reproducible sequence of 64-bit numbers from a seed (SplitMix64): steps of 2^64 over the
/// golden ratio with mixed bits.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t operator()() {
    state_ += 0x9E3779B97F4A7C15;
    std::uint64_t mixed = (state_ ^ (state_ >> 30U)) * 0xBF58476D1CE4E5B9;
    mixed = (mixed ^ (mixed >> 27U)) * 0x94D049BB133111EB;
    return mixed ^ (mixed >> 31U);
  }

 private:
  std::uint64_t state_;
};

/// Draws a word of `bits` bits: a power of two or its neighbour, or random bits of a random length.
/// Negates half of the words.
inline std::uint32_t draw_word(Random& random, std::uint32_t bits) {
  const std::uint32_t mask = 0xFFFFFFFFU >> (32 - bits);
  const auto place = static_cast<std::uint32_t>(random() % bits);
  auto word = (static_cast<std::uint32_t>(random()) & mask) >> place;
  if (random() % 3 == 0) word = (1U << place) + static_cast<std::uint32_t>(random() % 3) - 1;
  return (random() % 2 == 0 ? word : 0U - word) & mask;
}

}  // namespace command

/// @file
/// Operands for the rules of programs, aimed at the places where rules differ.
#pragma once

#include <cstdint>
#include <limits>
#include <random>

namespace port_cases {

struct Pair {
  std::int32_t a;
  std::int32_t b;
};

/// Draws pairs by one of several ways each. The seed is fixed, so every run has the same.
class Pairs {
 public:
  Pair next() {
    const std::int32_t b = any();
    switch (random_() % 8) {
      case 0:
        return {any(), b};
      case 1:
        return {plain(), plain()};
      case 2:  // next to the guard of Doom: a = b * 2^14
        return {near(std::int64_t{b >> 14} * 16384), b >> 14};
      case 3:  // next to the ends of Allegro's range: a = b * 32767
        return {near(std::int64_t{b >> 15} * 32767), b >> 15};
      case 4:  // a quotient next to a whole number of ulps
        return {near((std::int64_t{any() >> 3} * b) >> 16), b};
      case 5:  // a product next to the end of the range
        return {b == 0 ? 0 : near((std::int64_t{1} << 47) / b), b};
      case 6:
        return {any(),
                static_cast<std::int32_t>(random_()) & static_cast<std::int32_t>(0x8000ffff)};
      default:
        return {edge(), random_() % 2 == 0 ? edge() : b};
    }
  }

 private:
  std::int32_t plain() { return static_cast<std::int32_t>(random_()); }
  /// A number of any magnitude.
  std::int32_t any() { return plain() >> (random_() % 32); }
  /// A number at most two ulps away, modulo 2^32.
  std::int32_t near(std::int64_t x) {
    return static_cast<std::int32_t>(x + static_cast<std::int64_t>(random_() % 5) - 2);
  }
  std::int32_t edge() {
    constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
    constexpr std::int32_t edges[]{0,     1,      -1,   32768, -32768,   65535,
                                   65536, -65536, most, -most, -most - 1};
    return edges[random_() % std::size(edges)];
  }

  std::mt19937 random_{1994};  // NOLINT(cert-msc51-cpp): the same cases in every run
};

}  // namespace port_cases

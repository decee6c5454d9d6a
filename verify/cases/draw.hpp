/// @file
/// A pseudo-random generator for the words of one case.
#pragma once

#include <cstdint>

namespace fixproof::cases {

/// The finaliser of splitmix64: a bijection in which every result bit depends on every bit of `x`.
constexpr std::uint64_t mix(std::uint64_t x) {
  x = (x ^ x >> 30U) * 0xbf58476d1ce4e5b9U;
  x = (x ^ x >> 27U) * 0x94d049bb133111ebU;
  return x ^ x >> 31U;
}

/// The random choices of one case. `key` and the number of the case seed a splitmix64 sequence, so
/// cases are independent of each other.
class Draw {
 public:
  constexpr Draw(std::uint64_t key, std::uint64_t index) : state_(mix(mix(key) + index)) {}

  constexpr std::uint64_t bits() { return mix(state_ += 0x9e3779b97f4a7c15U); }

  /// Returns 0 ... count-1, for 1 <= count <= 2^32. The bias is below count / 2^32.
  constexpr std::uint64_t below(std::uint64_t count) { return (bits() >> 32U) * count >> 32U; }

  /// Returns first ... last.
  constexpr int between(int first, int last) {
    return first + static_cast<int>(below(static_cast<std::uint64_t>(last - first) + 1));
  }

  constexpr bool coin() { return bits() >> 63U != 0; }

  /// Returns a magnitude of 0 ... `widest` bits, for a `widest` of 0 ... 62. Every width is equally
  /// likely, so small and large numbers are equally common.
  constexpr std::int64_t magnitude(int widest) {
    const std::uint64_t width = below(static_cast<std::uint64_t>(widest) + 1);
    if (width == 0) return 0;
    const std::uint64_t top = std::uint64_t{1} << (width - 1);
    return static_cast<std::int64_t>(top | (bits() & (top - 1)));
  }

  constexpr std::int64_t either_sign(std::int64_t value) { return coin() ? -value : value; }

 private:
  std::uint64_t state_;
};

}  // namespace fixproof::cases

/// @file
/// FixedMul and FixedDiv from docs/semantics.md in 128-bit integers, written for clarity and not
/// for speed.
#pragma once

#include <cstdint>
#include <optional>

namespace semantics {

__extension__ typedef __int128 Integer;  // NOLINT(modernize-use-using): __extension__ needs typedef

inline constexpr Integer one = 65536;

constexpr Integer value_of(std::uint32_t word) { return static_cast<std::int32_t>(word); }
constexpr Integer magnitude(Integer n) { return n < 0 ? -n : n; }

/// The floor of n / d, for d > 0.
constexpr Integer floor_divide(Integer n, Integer d) {
  Integer quotient = n / d;
  while (quotient * d > n) --quotient;
  return quotient;
}

/// A result modulo 2^32.
constexpr std::uint32_t word_of(Integer n) {
  return static_cast<std::uint32_t>(n - floor_divide(n, one * one) * one * one);
}

constexpr std::uint32_t mul(std::uint32_t a, std::uint32_t b, bool is_386, bool round) {
  const Integer product = value_of(a) * value_of(b);
  const Integer half = round ? one / 2 : 0;
  if (is_386) return word_of(floor_divide(product + half, one));
  const Integer size = (magnitude(product) + half) / one;
  return word_of(product < 0 ? -size : size);
}

/// Returns no value for a divide error.
constexpr std::optional<std::uint32_t> div(std::uint32_t n, std::uint32_t d, bool is_386,
                                           bool round) {
  const bool negative = (value_of(n) < 0) != (value_of(d) < 0);
  // The 8088 divides by the whole part, so both operands lose 16 fraction bits.
  const Integer divisor = is_386 ? magnitude(value_of(d)) : magnitude(value_of(d)) / one;
  const Integer dividend = magnitude(value_of(n)) * (is_386 ? one : 1);
  if (divisor == 0) return std::nullopt;
  const Integer quotient = dividend / divisor;
  const bool up = round && 2 * (dividend % divisor) >= divisor;
  const Integer result = (negative ? -1 : 1) * (quotient + (up ? 1 : 0));
  if (is_386 && round && quotient >= one * one) return std::nullopt;
  if (is_386 && !round && (result < -one * one / 2 || result >= one * one / 2)) {
    return std::nullopt;
  }
  return word_of(result);
}

}  // namespace semantics

#pragma once

#include <bit>
#include <cstdint>
#include <optional>

#include "oracle/format.hpp"

/// A faster implementation of format.hpp for words of at most 32 bits: signs and magnitudes in
/// 64-bit integers, rounded half up. Products of magnitudes and magnitudes scaled by 2^32 do not
/// exceed 64 bits.
namespace oracle::fast {

/// A number of ulps of at most 65 bits.
struct Signed {
  bool negative;
  std::uint64_t magnitude;
};

[[nodiscard]] constexpr Signed signed_ulps(LongWord word, const Format& format) {
  const std::uint64_t ones = ~std::uint64_t{0} >> (64 - format.bits);
  const bool negative = format.is_signed && (word >> (format.bits - 1) & 1U) != 0;
  return {negative, (negative ? 0 - word : word) & ones};
}

/// The low bits of a number of ulps.
[[nodiscard]] constexpr LongWord wrap(const Signed& value, const Format& format) {
  const std::uint64_t ones = ~std::uint64_t{0} >> (64 - format.bits);
  return (value.negative ? 0 - value.magnitude : value.magnitude) & ones;
}

/// n / d with the sign of `negative`, half up; d > 0.
[[nodiscard]] constexpr Signed half_up(bool negative, std::uint64_t n, std::uint64_t d) {
  const std::uint64_t rest = n % d;
  // A negative tie rounds toward zero.
  const bool up = negative ? rest > d - rest : rest >= d - rest;
  return {negative, n / d + (up ? 1 : 0)};
}

/// a * b.
[[nodiscard]] constexpr LongWord mul(LongWord a, LongWord b, const Format& format) {
  const Signed x = signed_ulps(a, format);
  const Signed y = signed_ulps(b, format);
  return wrap(half_up(x.negative != y.negative, x.magnitude * y.magnitude,
                      std::uint64_t{1} << format.fraction_bits),
              format);
}

/// n / d; empty if and only if d is 0.
[[nodiscard]] constexpr std::optional<LongWord> quotient(LongWord n, LongWord d,
                                                         const Format& format) {
  const Signed x = signed_ulps(n, format);
  const Signed y = signed_ulps(d, format);
  if (y.magnitude == 0) return std::nullopt;
  return wrap(half_up(x.negative != y.negative, x.magnitude << format.fraction_bits, y.magnitude),
              format);
}

/// The square root, rounded to nearest; empty for a negative operand.
[[nodiscard]] constexpr std::optional<LongWord> sqrt(LongWord word, const Format& format) {
  const Signed x = signed_ulps(word, format);
  if (x.negative) return std::nullopt;
  // One bit of the root at a time; `rest` is the radicand minus the square of the root.
  std::uint64_t rest = x.magnitude << format.fraction_bits;
  std::uint64_t root = 0;
  const int top = (64 - std::countl_zero(rest | 1)) / 2;
  for (int bit = top < 31 ? top : 31; bit >= 0; --bit) {
    // (root + digit)^2 - root^2, with root a multiple of twice the digit
    const std::uint64_t step = (2 * root << bit) + (std::uint64_t{1} << 2 * bit);
    if (rest < step) continue;
    rest -= step;
    root += std::uint64_t{1} << bit;
  }
  return root + (rest > root ? 1 : 0);
}

/// The same, faster if the root is `guess` or one more, as in sweeps. Sets `guess` to the root.
[[nodiscard]] constexpr std::optional<LongWord> sqrt(LongWord word, const Format& format,
                                                     LongWord& guess) {
  const Signed x = signed_ulps(word, format);
  if (x.negative) return std::nullopt;
  const std::uint64_t n = x.magnitude << format.fraction_bits;
  constexpr std::uint64_t highest = 0xFFFFFFFF;
  // r is nearest if (r - 1/2)^2 < n < (r + 1/2)^2, in integers r^2 - r < n <= r^2 + r.
  for (std::uint64_t r = guess; r <= guess + 1 && r > 0 && r < highest; ++r) {
    if (r * r - r < n && n <= r * r + r) return guess = r;
  }
  return guess = *sqrt(word, format);
}

}  // namespace oracle::fast

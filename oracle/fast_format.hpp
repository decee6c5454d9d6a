#pragma once

#include <bit>
#include <cmath>
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

/// The remainder of n / d truncated toward zero; empty if and only if d is 0.
[[nodiscard]] constexpr std::optional<LongWord> truncated_remainder(LongWord n, LongWord d,
                                                                    const Format& format) {
  const Signed x = signed_ulps(n, format);
  const Signed y = signed_ulps(d, format);
  if (y.magnitude == 0) return std::nullopt;
  return wrap(Signed{x.negative, x.magnitude % y.magnitude}, format);
}

/// The remainder of the integer nearest to n / d, ties to even; empty if and only if d is 0.
[[nodiscard]] constexpr std::optional<LongWord> nearest_remainder(LongWord n, LongWord d,
                                                                  const Format& format) {
  const Signed x = signed_ulps(n, format);
  const Signed y = signed_ulps(d, format);
  if (y.magnitude == 0) return std::nullopt;
  const std::uint64_t rest = x.magnitude % y.magnitude;
  const std::uint64_t twice = 2 * rest;
  const bool is_odd = x.magnitude / y.magnitude % 2 != 0;
  if (twice < y.magnitude || (twice == y.magnitude && !is_odd)) {
    return wrap(Signed{x.negative, rest}, format);
  }
  return wrap(Signed{!x.negative, y.magnitude - rest}, format);
}

/// a * b / c; empty if and only if c is 0.
[[nodiscard]] constexpr std::optional<LongWord> product_quotient(LongWord a, LongWord b, LongWord c,
                                                                 const Format& format) {
  const Signed x = signed_ulps(a, format);
  const Signed y = signed_ulps(b, format);
  const Signed z = signed_ulps(c, format);
  if (z.magnitude == 0) return std::nullopt;
  return wrap(
      half_up((x.negative != y.negative) != z.negative, x.magnitude * y.magnitude, z.magnitude),
      format);
}

/// The length of (x, y, z) in ulps, to nearest. It has at most 33 bits.
[[nodiscard]] inline std::uint64_t nearest_length(LongWord x, LongWord y, LongWord z,
                                                  const Format& format) {
  // The sum of the squares may exceed 64 bits. A double tells the root within an ulp, so the sum
  // minus the square of the guess is small, and right modulo 2^64.
  std::uint64_t sum = 0;
  double estimate = 0;
  for (const LongWord word : {x, y, z}) {
    const std::uint64_t size = signed_ulps(word, format).magnitude;
    sum += size * size;
    estimate += static_cast<double>(size) * static_cast<double>(size);
  }
  auto root = static_cast<std::uint64_t>(std::sqrt(estimate));
  const auto above = [&] { return static_cast<std::int64_t>(sum - root * root); };
  // Root r is nearest if r^2 - r < sum <= r^2 + r.
  while (above() > static_cast<std::int64_t>(root)) ++root;
  while (root > 0 && above() <= -static_cast<std::int64_t>(root)) --root;
  return root;
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

#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>

#include "oracle/rule.hpp"

/// A faster implementation of format.hpp and exact.hpp for words of at most 32 bits, for sweeps:
/// signs and magnitudes in 64-bit integers, where the remainder decides the rounding. Products of
/// magnitudes and magnitudes scaled by 2^32 do not exceed 64 bits. Calls are qualified, because
/// argument-dependent lookup on the rules would find the functions of namespace oracle.
namespace oracle::fast {

/// A number of ulps of at most 65 bits.
struct Signed {
  bool negative;
  std::uint64_t magnitude;

  /// The number, if its magnitude is below 2^63.
  [[nodiscard]] constexpr std::int64_t value() const {
    const auto size = static_cast<std::int64_t>(magnitude);
    return negative ? -size : size;
  }
};

/// A word in ulps.
[[nodiscard]] constexpr Signed signed_ulps(LongWord word, const Format& format) {
  const std::uint64_t ones = ~std::uint64_t{0} >> (64 - format.bits);
  const bool negative = format.is_signed && (word >> (format.bits - 1) & 1U) != 0;
  return {negative, (negative ? 0 - word : word) & ones};
}

/// The low bits of a number of ulps.
[[nodiscard]] constexpr LongWord wrap(std::uint64_t value, const Format& format) {
  return value & ~std::uint64_t{0} >> (64 - format.bits);
}
[[nodiscard]] constexpr LongWord wrap(const Signed& value, const Format& format) {
  return fast::wrap(value.negative ? 0 - value.magnitude : value.magnitude, format);
}

namespace detail {

/// Whether the rule rounds a magnitude that lies `rest` / `divisor` above `floor` away from zero.
[[nodiscard]] constexpr bool rounds_away(std::uint64_t floor, std::uint64_t rest,
                                         std::uint64_t divisor, bool negative, Rounding rule) {
  switch (rule) {
    case Rounding::half_up:
      // A negative tie rounds toward zero.
      return negative ? rest > divisor - rest : rest >= divisor - rest;
    case Rounding::half_away:
      return rest >= divisor - rest;
    case Rounding::half_even:
      return rest > divisor - rest || (rest == divisor - rest && floor % 2 != 0);
    case Rounding::floor:
      return negative && rest != 0;
    case Rounding::truncate:
      return false;
    case Rounding::ceiling:
      return !negative && rest != 0;
  }
  throw std::invalid_argument("no such rounding");
}

/// n / d with the sign of `negative`, rounded; d > 0.
[[nodiscard]] constexpr Signed divide(bool negative, std::uint64_t n, std::uint64_t d,
                                      Rounding rule) {
  const std::uint64_t floor = n / d;
  return {negative, floor + (rounds_away(floor, n % d, d, negative, rule) ? 1 : 0)};
}

}  // namespace detail

/// a + b in ulps, before reduction to a word.
[[nodiscard]] constexpr std::int64_t exact_sum(LongWord a, LongWord b, const Format& format) {
  return signed_ulps(a, format).value() + signed_ulps(b, format).value();
}

/// a - b in ulps, before reduction to a word.
[[nodiscard]] constexpr std::int64_t exact_difference(LongWord a, LongWord b,
                                                      const Format& format) {
  return signed_ulps(a, format).value() - signed_ulps(b, format).value();
}

/// a * b in ulps, before reduction to a word.
[[nodiscard]] constexpr Signed exact_product(LongWord a, LongWord b, Rounding rule,
                                             const Format& format) {
  const Signed x = signed_ulps(a, format);
  const Signed y = signed_ulps(b, format);
  const bool negative = x.negative != y.negative;
  const std::uint64_t product = x.magnitude * y.magnitude;
  const std::uint64_t one = std::uint64_t{1} << format.fraction_bits;
  const std::uint64_t floor = product >> format.fraction_bits;
  const bool away = detail::rounds_away(floor, product & (one - 1), one, negative, rule);
  return {negative, floor + (away ? 1 : 0)};
}

/// n / d in ulps, before reduction to a word; empty if and only if d is 0.
[[nodiscard]] constexpr std::optional<Signed> exact_quotient(LongWord n, LongWord d, Rounding rule,
                                                             const Format& format) {
  const Signed x = signed_ulps(n, format);
  const Signed y = signed_ulps(d, format);
  if (y.magnitude == 0) return std::nullopt;
  return detail::divide(x.negative != y.negative, x.magnitude << format.fraction_bits, y.magnitude,
                        rule);
}

/// a * b.
[[nodiscard]] constexpr LongWord mul(LongWord a, LongWord b, Rounding rule, const Format& format) {
  return fast::wrap(fast::exact_product(a, b, rule, format), format);
}

/// n / d as in mathematics; empty if and only if d is 0.
[[nodiscard]] constexpr std::optional<LongWord> quotient(LongWord n, LongWord d, Rounding rule,
                                                         const Format& format) {
  const auto exact = fast::exact_quotient(n, d, rule, format);
  if (!exact) return std::nullopt;
  return fast::wrap(*exact, format);
}

/// n / d as a divide of FIXED.ASM; empty for #DE. The fault conditions use the operands, not the
/// quotient.
[[nodiscard]] constexpr std::optional<LongWord> div(LongWord n, LongWord d, DivideRule rule,
                                                    const Format& format) {
  const Signed x = signed_ulps(n, format);
  const Signed y = signed_ulps(d, format);
  const bool negative = x.negative != y.negative;
  switch (rule) {
    case DivideRule::i386_rounded:
      if (y.magnitude <= x.magnitude >> format.fraction_bits) return std::nullopt;
      return fast::quotient(n, d, Rounding::half_away, format);
    case DivideRule::i386_unrounded: {
      // The first magnitude that does not fit: 2^(2F-1), or one more for a negative quotient.
      const std::uint64_t limit = (std::uint64_t{1} << (format.bits - 1)) + (negative ? 1 : 0);
      if (x.magnitude << format.fraction_bits >= limit * y.magnitude) return std::nullopt;
      return fast::quotient(n, d, Rounding::truncate, format);
    }
    case DivideRule::i8088_rounded:
    case DivideRule::i8088_unrounded: {
      const std::uint64_t whole = y.magnitude >> format.fraction_bits;
      if (whole == 0) return std::nullopt;
      const auto rounding =
          rule == DivideRule::i8088_rounded ? Rounding::half_away : Rounding::truncate;
      return fast::wrap(detail::divide(negative, x.magnitude, whole, rounding), format);
    }
  }
  throw std::invalid_argument("no such divide rule");
}

/// The remainder of n / d truncated toward zero; empty if and only if d is 0.
[[nodiscard]] constexpr std::optional<LongWord> truncated_remainder(LongWord n, LongWord d,
                                                                    const Format& format) {
  const Signed x = signed_ulps(n, format);
  const Signed y = signed_ulps(d, format);
  if (y.magnitude == 0) return std::nullopt;
  return fast::wrap(Signed{x.negative, x.magnitude % y.magnitude}, format);
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
    return fast::wrap(Signed{x.negative, rest}, format);
  }
  return fast::wrap(Signed{!x.negative, y.magnitude - rest}, format);
}

/// a * b / c; empty if and only if c is 0.
[[nodiscard]] constexpr std::optional<LongWord> product_quotient(LongWord a, LongWord b, LongWord c,
                                                                 Rounding rule,
                                                                 const Format& format) {
  const Signed x = signed_ulps(a, format);
  const Signed y = signed_ulps(b, format);
  const Signed z = signed_ulps(c, format);
  if (z.magnitude == 0) return std::nullopt;
  return fast::wrap(detail::divide((x.negative != y.negative) != z.negative,
                                   x.magnitude * y.magnitude, z.magnitude, rule),
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

/// The square root in ulps, below 2^32; empty for a negative operand.
[[nodiscard]] constexpr std::optional<std::uint64_t> exact_root(LongWord word, Rounding rule,
                                                                const Format& format) {
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
  if (rule == Rounding::floor || rule == Rounding::truncate) return root;
  if (rule == Rounding::ceiling) return root + (rest > 0 ? 1 : 0);
  // The radicand exceeds (root + 1/2)^2 when the rest exceeds root + 1/4.
  return root + (rest > root ? 1 : 0);
}

/// The square root, rounded to nearest; empty for a negative operand. Faster if it is `guess` or
/// one more, as in sweeps. Sets `guess` to the root.
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
  return guess = *fast::exact_root(word, Rounding::half_up, format);
}

/// A transformed point, as oracle::xform_vec.
[[nodiscard]] constexpr std::array<Word, 3> xform_vec(std::span<const Word, 12> m,
                                                      std::span<const Word, 3> v, Rounding rule,
                                                      const Format& format) {
  std::array<Word, 3> result{};
  for (std::size_t row = 0; row < 3; ++row) {
    const auto r = m.subspan(4 * row, 4);
    const LongWord sum = fast::mul(r[0], v[0], rule, format) + fast::mul(r[1], v[1], rule, format) +
                         fast::mul(r[2], v[2], rule, format) + r[3];
    result[row] = static_cast<Word>(fast::wrap(sum, format));
  }
  return result;
}

/// The product of two 3x4 transforms, as oracle::concat.
[[nodiscard]] constexpr std::array<Word, 12> concat(std::span<const Word, 12> first,
                                                    std::span<const Word, 12> second, Rounding rule,
                                                    TranslationRule translation,
                                                    const Format& format) {
  std::array<Word, 12> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto row = first.subspan(i / 4 * 4, 4);
    const std::size_t column = i % 4;
    const bool translated = column == 3 || translation == TranslationRule::every;
    const Word moved = translated ? row[3] : 0;
    LongWord sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      sum += fast::mul(row[k], second[4 * k + column], rule, format);
    }
    const Word one = Word{1} << format.fraction_bits;
    const bool parted = translated && translation == TranslationRule::fourth_in_parts;
    const bool carries = sum % one + moved % one >= one;
    result[i] = static_cast<Word>(fast::wrap(sum + moved - (parted && carries ? one : 0), format));
  }
  return result;
}

}  // namespace oracle::fast

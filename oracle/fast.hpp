#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>

#include "oracle/rule.hpp"

/// A faster implementation of exact.hpp and unbounded.hpp for sweeps: floor division in 64-bit
/// integers, where the remainder decides the rounding. Nothing overflows: a product of two words is
/// below 2^63 in magnitude, a dividend scaled by 2^16 below 2^48. Every function that takes
/// `fraction_bits` throws std::invalid_argument unless it is 2 ... 16. Calls are qualified, because
/// argument-dependent lookup on the rules would find the functions of namespace oracle.
namespace oracle::fast {

namespace detail {

/// The bits of a 32-bit word that the format does not use.
[[nodiscard]] constexpr int unused_bits(int fraction_bits) {
  if (fraction_bits < 2 || fraction_bits > 16) {
    throw std::invalid_argument("fraction_bits must be 2 ... 16");
  }
  return 32 - 2 * fraction_bits;
}

/// The operand in ulps; sign-extends by shifting to the top of the word and back.
[[nodiscard]] constexpr std::int64_t ulps(Word word, int fraction_bits) {
  const int unused = unused_bits(fraction_bits);
  return static_cast<std::int32_t>(word << unused) >> unused;
}

[[nodiscard]] constexpr std::int64_t magnitude(std::int64_t value) {
  return value < 0 ? -value : value;
}

/// Whether the rule rounds a value that lies `remainder` / `divisor` above the floor up.
[[nodiscard]] constexpr bool rounds_up(std::int64_t floor, std::int64_t remainder,
                                       std::int64_t divisor, bool negative, Rounding rule) {
  switch (rule) {
    case Rounding::half_up:
      return remainder >= divisor - remainder;
    case Rounding::half_away:
      return negative ? remainder > divisor - remainder : remainder >= divisor - remainder;
    case Rounding::half_even:
      return remainder > divisor - remainder ||
             (remainder == divisor - remainder && floor % 2 != 0);
    case Rounding::floor:
      return false;
    case Rounding::truncate:
      return negative && remainder != 0;
  }
  throw std::invalid_argument("no such rounding");
}

/// n / d rounded, for d != 0, |n| < 2^62 and |d| < 2^32.
[[nodiscard]] constexpr std::int64_t divide(std::int64_t n, std::int64_t d, Rounding rule) {
  if (d < 0) {
    n = -n;
    d = -d;
  }
  std::int64_t floor = n / d;
  std::int64_t remainder = n % d;
  if (remainder < 0) {
    --floor;
    remainder += d;
  }
  return floor + (rounds_up(floor, remainder, d, n < 0, rule) ? 1 : 0);
}

}  // namespace detail

/// `value` modulo 2^2F.
[[nodiscard]] constexpr Word wrap(std::int64_t value, int fraction_bits) {
  return static_cast<Word>(value) & (~Word{0} >> detail::unused_bits(fraction_bits));
}

/// a + b in ulps, before reduction to a word.
[[nodiscard]] constexpr std::int64_t exact_sum(Word a, Word b, int fraction_bits) {
  return detail::ulps(a, fraction_bits) + detail::ulps(b, fraction_bits);
}

/// a - b in ulps, before reduction to a word.
[[nodiscard]] constexpr std::int64_t exact_difference(Word a, Word b, int fraction_bits) {
  return detail::ulps(a, fraction_bits) - detail::ulps(b, fraction_bits);
}

/// a * b in ulps, before reduction to a word.
[[nodiscard]] constexpr std::int64_t exact_product(Word a, Word b, Rounding rule,
                                                   int fraction_bits) {
  const std::int64_t product = detail::ulps(a, fraction_bits) * detail::ulps(b, fraction_bits);
  const std::int64_t one = std::int64_t{1} << fraction_bits;
  const std::int64_t floor = product >> fraction_bits;
  const bool up = detail::rounds_up(floor, product & (one - 1), one, product < 0, rule);
  return floor + (up ? 1 : 0);
}

/// n / d in ulps, before reduction to a word; empty if and only if d is 0.
[[nodiscard]] constexpr std::optional<std::int64_t> exact_quotient(Word n, Word d, Rounding rule,
                                                                   int fraction_bits) {
  const std::int64_t divisor = detail::ulps(d, fraction_bits);
  if (divisor == 0) return std::nullopt;
  const std::int64_t scaled = detail::ulps(n, fraction_bits) * (std::int64_t{1} << fraction_bits);
  return detail::divide(scaled, divisor, rule);
}

/// a * b.
[[nodiscard]] constexpr Word mul(Word a, Word b, Rounding rule, int fraction_bits) {
  return wrap(fast::exact_product(a, b, rule, fraction_bits), fraction_bits);
}

/// n / d as in mathematics; empty if and only if d is 0.
[[nodiscard]] constexpr std::optional<Word> quotient(Word n, Word d, Rounding rule,
                                                     int fraction_bits) {
  const auto exact = fast::exact_quotient(n, d, rule, fraction_bits);
  if (!exact) return std::nullopt;
  return wrap(*exact, fraction_bits);
}

/// n / d as a divide of FIXED.ASM; empty for #DE. The fault conditions use the operands, not the
/// quotient.
[[nodiscard]] constexpr std::optional<Word> div(Word n, Word d, DivideRule rule,
                                                int fraction_bits) {
  const std::int64_t dividend = detail::ulps(n, fraction_bits);
  const std::int64_t divisor = detail::ulps(d, fraction_bits);
  const std::int64_t size = detail::magnitude(divisor);
  switch (rule) {
    case DivideRule::i386_rounded:
      if (size <= detail::magnitude(dividend) >> fraction_bits) return std::nullopt;
      return fast::quotient(n, d, Rounding::half_away, fraction_bits);
    case DivideRule::i386_unrounded: {
      // The first magnitude that does not fit: 2^(2F-1), or one more for a negative quotient.
      const bool negative = (dividend < 0) != (divisor < 0);
      const std::int64_t limit = (std::int64_t{1} << (2 * fraction_bits - 1)) + (negative ? 1 : 0);
      const std::int64_t scaled = detail::magnitude(dividend) << fraction_bits;
      if (scaled >= limit * size) return std::nullopt;
      return fast::quotient(n, d, Rounding::truncate, fraction_bits);
    }
    case DivideRule::i8088_rounded:
    case DivideRule::i8088_unrounded: {
      const std::int64_t whole = size >> fraction_bits;
      if (whole == 0) return std::nullopt;
      const auto rounding =
          rule == DivideRule::i8088_rounded ? Rounding::half_away : Rounding::truncate;
      return wrap(detail::divide(dividend, divisor < 0 ? -whole : whole, rounding), fraction_bits);
    }
  }
  throw std::invalid_argument("no such divide rule");
}

/// The square root in ulps, below 2^24; empty for a negative operand.
[[nodiscard]] constexpr std::optional<std::int64_t> exact_root(Word x, Rounding rule,
                                                               int fraction_bits) {
  const std::int64_t value = detail::ulps(x, fraction_bits);
  if (value < 0) return std::nullopt;
  // Computes the root one bit at a time; `rest` is the radicand minus the square of the root.
  std::int64_t rest = value << fraction_bits;
  std::int64_t root = 0;
  for (std::int64_t digit = std::int64_t{1} << 24; digit != 0; digit >>= 1) {
    const std::int64_t step = (2 * root + digit) * digit;
    if (rest >= step) {
      rest -= step;
      root += digit;
    }
  }
  if (rule == Rounding::floor || rule == Rounding::truncate) return root;
  // The radicand exceeds (root + 1/2)^2 when the rest exceeds root + 1/4.
  return root + (rest > root ? 1 : 0);
}

/// The square root, rounded to nearest; empty for a negative operand.
[[nodiscard]] constexpr std::optional<Word> sqrt(Word x, int fraction_bits) {
  const auto root = fast::exact_root(x, Rounding::half_up, fraction_bits);
  if (!root) return std::nullopt;
  return wrap(*root, fraction_bits);
}

/// A transformed point, as oracle::xform_vec.
[[nodiscard]] constexpr std::array<Word, 3> xform_vec(std::span<const Word, 12> m,
                                                      std::span<const Word, 3> v, Rounding rule,
                                                      int fraction_bits) {
  std::array<Word, 3> result{};
  for (std::size_t row = 0; row < 3; ++row) {
    const auto r = m.subspan(4 * row, 4);
    const Word sum = fast::mul(r[0], v[0], rule, fraction_bits) +
                     fast::mul(r[1], v[1], rule, fraction_bits) +
                     fast::mul(r[2], v[2], rule, fraction_bits) + r[3];
    result[row] = wrap(sum, fraction_bits);
  }
  return result;
}

/// The product of two 3x4 transforms, as oracle::concat.
[[nodiscard]] constexpr std::array<Word, 12> concat(std::span<const Word, 12> first,
                                                    std::span<const Word, 12> second, Rounding rule,
                                                    TranslationRule translation,
                                                    int fraction_bits) {
  std::array<Word, 12> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto row = first.subspan(i / 4 * 4, 4);
    const std::size_t column = i % 4;
    const bool translated = column == 3 || translation == TranslationRule::every;
    const Word moved = translated ? row[3] : 0;
    Word sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      sum += fast::mul(row[k], second[4 * k + column], rule, fraction_bits);
    }
    const Word one = Word{1} << fraction_bits;
    const bool parted = translated && translation == TranslationRule::fourth_in_parts;
    const bool carries = sum % one + moved % one >= one;
    result[i] = wrap(sum + moved - (parted && carries ? one : 0), fraction_bits);
  }
  return result;
}

}  // namespace oracle::fast

#pragma once

#include <optional>
#include <span>

#include "oracle/integer.hpp"
#include "oracle/rule.hpp"

/// Results before reduction to a word: integers of any size in ulps, for judging wrapping,
/// saturating and trapping types. Every function that takes `fraction_bits` throws
/// std::invalid_argument unless it is 2 ... 16.
namespace oracle {

/// numerator / denominator rounded to an integer. The denominator may have either sign; throws
/// std::domain_error if it is 0.
[[nodiscard]] Integer rounded(const Integer& numerator, const Integer& denominator, Rounding rule);

/// The bits of a word in this format, 2F.
[[nodiscard]] int word_bits(int fraction_bits);

/// 1.0 in ulps, 2^F.
[[nodiscard]] Integer one(int fraction_bits);

/// The signed value of a word, in ulps.
[[nodiscard]] Integer ulps(Word word, int fraction_bits);

/// `value` modulo 2^bits, 1 <= bits <= 32.
[[nodiscard]] Word wrap(const Integer& value, int bits);

/// `value` saturated to the `bits`-bit (1 ... 32) two's complement range, as a word.
[[nodiscard]] Word saturate(const Integer& value, int bits);

/// Whether `value` lies in -2^(bits-1) ... 2^(bits-1) - 1, 1 <= bits <= 32.
[[nodiscard]] bool fits(const Integer& value, int bits);

/// a * b.
[[nodiscard]] Integer exact_product(Word a, Word b, Rounding rule, int fraction_bits);

/// n / d; empty if and only if d is 0.
[[nodiscard]] std::optional<Integer> exact_quotient(Word n, Word d, Rounding rule,
                                                    int fraction_bits);

/// The square root of x; empty if and only if x is negative. There are no ties (the square of a
/// half-integer is not an integer), so only two rules differ: to nearest, and down.
[[nodiscard]] std::optional<Integer> exact_root(Word x, Rounding rule, int fraction_bits);

/// a * b + c, rounded once.
[[nodiscard]] Integer exact_mul_add(Word a, Word b, Word c, Rounding rule, int fraction_bits);

/// The sum of a[i] * b[i], rounded once; throws std::invalid_argument if the lengths differ.
[[nodiscard]] Integer exact_dot(std::span<const Word> a, std::span<const Word> b, Rounding rule,
                                int fraction_bits);

/// a + (b - a) * t, with b - a unreduced and one rounding.
[[nodiscard]] Integer exact_lerp(Word a, Word b, Word t, Rounding rule, int fraction_bits);

}  // namespace oracle

#pragma once

#include <optional>
#include <span>

#include "oracle/integer.hpp"
#include "oracle/rule.hpp"

/// Results before they are brought into a word: integers of any size, counted in ulps, with which
/// wrapping, saturating and trapping types can all be judged. Every function that takes
/// `fraction_bits` throws std::invalid_argument unless it is 2 ... 16.
namespace oracle {

/// numerator / denominator rounded to an integer. The denominator may have either sign;
/// std::domain_error if it is 0.
[[nodiscard]] Integer rounded(const Integer& numerator, const Integer& denominator, Rounding rule);

/// The bits of a word in this format, 2F.
[[nodiscard]] int word_bits(int fraction_bits);

/// 1.0 in ulps, 2^F.
[[nodiscard]] Integer one(int fraction_bits);

/// The signed integer a word stands for: the operand in ulps.
[[nodiscard]] Integer ulps(Word word, int fraction_bits);

/// `value` modulo 2^bits, 1 <= bits <= 32.
[[nodiscard]] Word wrap(const Integer& value, int bits);

/// The value of the `bits`-bit (1 ... 32) two's complement range nearest to `value`, as a word.
[[nodiscard]] Word saturate(const Integer& value, int bits);

/// Whether `value` lies in -2^(bits-1) ... 2^(bits-1) - 1, 1 <= bits <= 32.
[[nodiscard]] bool fits(const Integer& value, int bits);

/// a * b.
[[nodiscard]] Integer exact_product(Word a, Word b, Rounding rule, int fraction_bits);

/// n / d; empty exactly when d is 0.
[[nodiscard]] std::optional<Integer> exact_quotient(Word n, Word d, Rounding rule,
                                                    int fraction_bits);

/// The square root of x; empty exactly when x is negative. A root is never halfway between two ulps
/// (the square of a half-integer is no integer), so that the rules are two: to nearest, and down.
[[nodiscard]] std::optional<Integer> exact_root(Word x, Rounding rule, int fraction_bits);

/// a * b + c, rounded once.
[[nodiscard]] Integer exact_mul_add(Word a, Word b, Word c, Rounding rule, int fraction_bits);

/// The sum of a[i] * b[i], rounded once; std::invalid_argument if the lengths differ.
[[nodiscard]] Integer exact_dot(std::span<const Word> a, std::span<const Word> b, Rounding rule,
                                int fraction_bits);

/// a + (b - a) * t, with b - a not reduced and the whole rounded once.
[[nodiscard]] Integer exact_lerp(Word a, Word b, Word t, Rounding rule, int fraction_bits);

}  // namespace oracle

#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "oracle/rule.hpp"

/// What each operation returns, to the bit: the exact result, rounded by a named rule, checked
/// against the range where the rule has one, then taken modulo 2^2F. Every function that takes
/// `fraction_bits` throws std::invalid_argument unless it is 2 ... 16.
namespace oracle {

/// a * b.
[[nodiscard]] Word mul(Word a, Word b, Rounding rule, int fraction_bits);

/// n / d as a divide of FIXED.ASM gives it; empty for #DE.
[[nodiscard]] std::optional<Word> div(Word n, Word d, DivideRule rule, int fraction_bits);

/// n / d as mathematics gives it; empty exactly when d is 0.
[[nodiscard]] std::optional<Word> quotient(Word n, Word d, Rounding rule, int fraction_bits);

/// a * b + c, rounded once.
[[nodiscard]] Word mul_add(Word a, Word b, Word c, Rounding rule, int fraction_bits);

/// The sum of a[i] * b[i], rounded once; std::invalid_argument if the lengths differ.
[[nodiscard]] Word dot(std::span<const Word> a, std::span<const Word> b, Rounding rule,
                       int fraction_bits);

/// a + (b - a) * t, with b - a not reduced and the whole rounded once.
[[nodiscard]] Word lerp(Word a, Word b, Word t, Rounding rule, int fraction_bits);

/// The square root, rounded to nearest (a root is never halfway between two ulps: the square of a
/// half-integer is no integer); empty for a negative operand.
[[nodiscard]] std::optional<Word> sqrt(Word x, int fraction_bits);

/// The sine of an angle in radians, rounded to nearest. Neither it nor the cosine is ever halfway
/// between two ulps: of a rational angle other than 0 both are transcendental (Lindemann).
[[nodiscard]] Word sin(Word angle, int fraction_bits);

/// The cosine of an angle in radians, rounded to nearest.
[[nodiscard]] Word cos(Word angle, int fraction_bits);

/// A point moved by a 3x4 transform given row by row: m[i][0] x + m[i][1] y + m[i][2] z + m[i][3],
/// every product rounded on its own, sums modulo 2^2F.
[[nodiscard]] std::array<Word, 3> xform_vec(std::span<const Word, 12> m, std::span<const Word, 3> v,
                                            Rounding rule, int fraction_bits);

/// The transform that applies `second`, then `first`: the product of two 3x4 transforms, row by
/// row, whose missing bottom rows are 0 0 0 1. Every product is rounded on its own, sums are modulo
/// 2^2F, and `translation` says how they receive the fourth column of `first`.
[[nodiscard]] std::array<Word, 12> concat(std::span<const Word, 12> first,
                                          std::span<const Word, 12> second, Rounding rule,
                                          TranslationRule translation, int fraction_bits);

/// Cosine and sine of an angle in tenths of a degree, any value, each the nearest 16.16 value.
[[nodiscard]] CosSin cos_sin(std::int16_t angle_tenths);

/// The cosines of 0 to 90 degrees inclusive, each the nearest value: 90 * steps_per_degree + 1 of
/// them. std::invalid_argument unless steps_per_degree is positive.
[[nodiscard]] std::vector<Word> cosine_table(int steps_per_degree, int fraction_bits = 16);

}  // namespace oracle

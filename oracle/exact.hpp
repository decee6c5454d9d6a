#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "oracle/format.hpp"
#include "oracle/rule.hpp"

/// The bit-exact result of each operation in words of at most 32 bits: the exact value, rounded by
/// a rule, checked against the range if the rule requires it, then reduced modulo 2^bits. The
/// routines of FIXED.ASM are defined in the formats of their words.
namespace oracle {

/// a + b.
[[nodiscard]] Word add(Word a, Word b, const Format& format);

/// a - b.
[[nodiscard]] Word sub(Word a, Word b, const Format& format);

/// a * b.
[[nodiscard]] Word mul(Word a, Word b, Rounding rule, const Format& format);

/// n / d as a divide of FIXED.ASM; empty for #DE.
[[nodiscard]] std::optional<Word> div(Word n, Word d, DivideRule rule, const Format& format);

/// n / d as in mathematics; empty if and only if d is 0.
[[nodiscard]] std::optional<Word> quotient(Word n, Word d, Rounding rule, const Format& format);

/// a * b + c, rounded once.
[[nodiscard]] Word mul_add(Word a, Word b, Word c, Rounding rule, const Format& format);

/// The sum of a[i] * b[i], rounded once; std::invalid_argument if the lengths differ.
[[nodiscard]] Word dot(std::span<const Word> a, std::span<const Word> b, Rounding rule,
                       const Format& format);

/// a + (b - a) * t, with b - a unreduced and one rounding.
[[nodiscard]] Word lerp(Word a, Word b, Word t, Rounding rule, const Format& format);

/// The square root, rounded to nearest; empty for a negative operand. There are no ties, because
/// the square of a half-integer is not an integer.
[[nodiscard]] std::optional<Word> sqrt(Word x, const Format& format);

/// The sine of an angle in radians, rounded to nearest. There are no ties for sine and cosine: both
/// are transcendental for a nonzero rational angle (Lindemann).
[[nodiscard]] Word sin(Word angle, const Format& format);

/// The cosine of an angle in radians, rounded to nearest.
[[nodiscard]] Word cos(Word angle, const Format& format);

/// A point transformed by a 3x4 matrix in row-major order: m[i][0] x + m[i][1] y + m[i][2] z +
/// m[i][3]. Each product is rounded; sums are modulo 2^2F.
[[nodiscard]] std::array<Word, 3> xform_vec(std::span<const Word, 12> m, std::span<const Word, 3> v,
                                            Rounding rule, const Format& format);

/// The transform that applies `second`, then `first`: the product of two row-major 3x4 transforms
/// with implied bottom rows 0 0 0 1. Each product is rounded, sums are modulo 2^2F, and
/// `translation` says how they receive the fourth column of `first`.
[[nodiscard]] std::array<Word, 12> concat(std::span<const Word, 12> first,
                                          std::span<const Word, 12> second, Rounding rule,
                                          TranslationRule translation, const Format& format);

/// Cosine and sine of any angle in tenths of a degree, each the nearest 16.16 value.
[[nodiscard]] CosSin cos_sin(std::int16_t angle_tenths);

/// The cosines of 0 to 90 degrees, each rounded to nearest: 90 * steps_per_degree + 1 entries.
/// Throws std::invalid_argument unless steps_per_degree is positive.
[[nodiscard]] std::vector<Word> cosine_table(int steps_per_degree, const Format& format = {});

}  // namespace oracle

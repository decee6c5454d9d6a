#pragma once

#include <optional>
#include <span>
#include <type_traits>

#include "oracle/integer.hpp"
#include "oracle/rule.hpp"

/// Results before reduction to a word: integers in ulps, for judging wrapping, saturating and
/// trapping types. Every function that takes `fraction_bits` throws std::invalid_argument unless it
/// is 2 ... 16.
///
/// `Int` is Integer, which has any size, or Wide, which is faster and throws if an intermediate
/// result does not fit. Every intermediate result of words fits. A word has at most 2^31 ulps, and
/// 1.0 has at most 2^16. The largest intermediate result is that of a product:
/// 2 |a b| + 1.0 <= 2^63 + 2^16.
namespace oracle {

/// numerator / denominator rounded to an integer. The denominator may have either sign; throws
/// std::domain_error if it is 0. The largest intermediate result is 2 |numerator| + |denominator|
/// or 2 |denominator|.
template <class Int = Integer>
[[nodiscard]] Int rounded(const std::type_identity_t<Int>& numerator,
                          const std::type_identity_t<Int>& denominator, Rounding rule);

/// The bits of a word in this format, 2F.
[[nodiscard]] int word_bits(int fraction_bits);

/// 1.0 in ulps, 2^F.
template <class Int = Integer>
[[nodiscard]] Int one(int fraction_bits);

/// The signed value of a word, in ulps.
template <class Int = Integer>
[[nodiscard]] Int ulps(Word word, int fraction_bits);

/// `value` modulo 2^bits, 1 <= bits <= 32.
template <class Int = Integer>
[[nodiscard]] Word wrap(const std::type_identity_t<Int>& value, int bits);

/// `value` saturated to the `bits`-bit (1 ... 32) two's complement range, as a word.
[[nodiscard]] Word saturate(const Integer& value, int bits);

/// Whether `value` lies in -2^(bits-1) ... 2^(bits-1) - 1, 1 <= bits <= 32.
template <class Int = Integer>
[[nodiscard]] bool fits(const std::type_identity_t<Int>& value, int bits);

/// a * b.
template <class Int = Integer>
[[nodiscard]] Int exact_product(Word a, Word b, Rounding rule, int fraction_bits);

/// n / d; empty if and only if d is 0.
template <class Int = Integer>
[[nodiscard]] std::optional<Int> exact_quotient(Word n, Word d, Rounding rule, int fraction_bits);

/// The square root of x; empty if and only if x is negative. There are no ties (the square of a
/// half-integer is not an integer), so only two rules differ: to nearest, and down.
template <class Int = Integer>
[[nodiscard]] std::optional<Int> exact_root(Word x, Rounding rule, int fraction_bits);

/// a * b + c, rounded once.
[[nodiscard]] Integer exact_mul_add(Word a, Word b, Word c, Rounding rule, int fraction_bits);

/// The sum of a[i] * b[i], rounded once; throws std::invalid_argument if the lengths differ.
[[nodiscard]] Integer exact_dot(std::span<const Word> a, std::span<const Word> b, Rounding rule,
                                int fraction_bits);

/// a + (b - a) * t, with b - a unreduced and one rounding.
[[nodiscard]] Integer exact_lerp(Word a, Word b, Word t, Rounding rule, int fraction_bits);

}  // namespace oracle

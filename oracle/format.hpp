#pragma once

#include <optional>
#include <span>
#include <type_traits>

#include "oracle/integer.hpp"
#include "oracle/rule.hpp"

/// Words of any format up to 64 bits, and the exact results of their operations before reduction to
/// a word: integers in ulps, for judging wrapping, saturating and trapping types.
///
/// `Int` is Integer, which has any size, or Wide, which is faster and throws if an intermediate
/// result does not fit. With words of at most 32 bits every one fits: the largest is that of a
/// product, 2 |a b| + 1.0 <= 2^65 + 2^32.
namespace oracle {

/// numerator / denominator rounded to an integer. The denominator may have either sign; throws
/// std::domain_error if it is 0. The largest intermediate result is 2 |numerator| + |denominator|
/// or 2 |denominator|.
template <class Int = Integer>
[[nodiscard]] Int rounded(const std::type_identity_t<Int>& numerator,
                          const std::type_identity_t<Int>& denominator, Rounding rule);

/// 1.0 in ulps, 2^F, for 0 <= F <= bits. Only functions that need it require such a format.
template <class Int = Integer>
[[nodiscard]] Int one(const Format& format);

/// The value of a word, in ulps.
template <class Int = Integer>
[[nodiscard]] Int ulps(LongWord word, const Format& format);

[[nodiscard]] Integer lowest(const Format& format);
[[nodiscard]] Integer highest(const Format& format);
template <class Int = Integer>
[[nodiscard]] bool fits(const std::type_identity_t<Int>& value, const Format& format);

/// `value` modulo 2^bits.
template <class Int = Integer>
[[nodiscard]] LongWord wrap(const std::type_identity_t<Int>& value, const Format& format);

/// The word nearest to `value`.
[[nodiscard]] LongWord saturate(const Integer& value, const Format& format);

/// a * b.
template <class Int = Integer>
[[nodiscard]] Int exact_product(LongWord a, LongWord b, Rounding rule, const Format& format);

/// n / d; empty if and only if d is 0.
template <class Int = Integer>
[[nodiscard]] std::optional<Int> exact_quotient(LongWord n, LongWord d, Rounding rule,
                                                const Format& format);

/// The square root of x; empty if and only if x is negative. Rounded down by floor and truncate, up
/// by ceiling, to nearest by the other rules; there are no ties, because the square of a
/// half-integer is not an integer.
template <class Int = Integer>
[[nodiscard]] std::optional<Int> exact_root(LongWord x, Rounding rule, const Format& format);

/// a * b + c, rounded once.
[[nodiscard]] Integer exact_mul_add(LongWord a, LongWord b, LongWord c, Rounding rule,
                                    const Format& format);

/// The sum of a[i] * b[i], rounded once; throws std::invalid_argument if the lengths differ.
[[nodiscard]] Integer exact_dot(std::span<const Word> a, std::span<const Word> b, Rounding rule,
                                const Format& format);

/// a + (b - a) * t, with b - a unreduced and one rounding.
[[nodiscard]] Integer exact_lerp(LongWord a, LongWord b, LongWord t, Rounding rule,
                                 const Format& format);

/// A number of ulps of `from` in ulps of `to`.
[[nodiscard]] Integer converted(const Integer& value, const Format& from, const Format& to,
                                Rounding rule);

}  // namespace oracle

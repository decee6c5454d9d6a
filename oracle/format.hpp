#pragma once

#include <cstdint>
#include <optional>

#include "oracle/integer.hpp"
#include "oracle/rule.hpp"

/// Words of any format up to 64 bits, and the exact results of their operations before reduction to
/// a word: integers of any size in ulps.
namespace oracle {

/// A word of a format as bits, zero-extended. Bits of an operand above the format's are ignored;
/// those of a result are 0.
using LongWord = std::uint64_t;

/// A word with raw integer n has the value n ulps, and an ulp is 2^-fraction_bits.
struct Format {
  int bits = 32;           ///< 1 ... 64
  int fraction_bits = 16;  ///< 0 ... bits
  bool is_signed = true;   ///< two's complement; otherwise unsigned
};

/// The value of a word, in ulps.
[[nodiscard]] Integer ulps(LongWord word, const Format& format);

[[nodiscard]] Integer lowest(const Format& format);
[[nodiscard]] Integer highest(const Format& format);
[[nodiscard]] bool fits(const Integer& value, const Format& format);

/// `value` modulo 2^bits.
[[nodiscard]] LongWord wrap(const Integer& value, const Format& format);

/// The word nearest to `value`.
[[nodiscard]] LongWord saturate(const Integer& value, const Format& format);

/// a * b.
[[nodiscard]] Integer exact_product(LongWord a, LongWord b, Rounding rule, const Format& format);

/// n / d; empty if and only if d is 0.
[[nodiscard]] std::optional<Integer> exact_quotient(LongWord n, LongWord d, Rounding rule,
                                                    const Format& format);

/// The square root of x; empty if and only if x is negative. Rounded down by floor and truncate,
/// to nearest by the other rules; there are no ties, because the square of a half-integer is not an
/// integer.
[[nodiscard]] std::optional<Integer> exact_root(LongWord x, Rounding rule, const Format& format);

/// A number of ulps of `from` in ulps of `to`.
[[nodiscard]] Integer converted(const Integer& value, const Format& from, const Format& to,
                                Rounding rule);

}  // namespace oracle

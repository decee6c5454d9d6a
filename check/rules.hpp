/// @file
/// The rounding, overflow and no-result rules that third-party 16.16 arithmetic can follow.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "cases/variant.hpp"
#include "oracle/rule.hpp"

namespace fixproof::check {

/// A subject's result: a word, or empty for a divide error.
using Said = std::optional<std::uint32_t>;

/// The result for a rounded value outside -2^31 ... 2^31 - 1 ulps.
enum class Overflow : std::uint8_t {
  any,        ///< every result is accepted
  wrap,       ///< modulo 2^32
  saturate,   ///< 7fffffff; 80000000 if negative
  symmetric,  ///< 7fffffff; 80000001 if negative
  maximum,    ///< 7fffffff whatever the sign
  minimum,    ///< 80000000 whatever the sign
  error,      ///< DE
};

/// The result for a zero divisor or for the root of a negative number. The sign is that of the
/// dividend. Rules that depend on the sign also accept 0 for 0 / 0.
enum class NoResult : std::uint8_t {
  any,        ///< every result is accepted
  error,      ///< DE
  saturate,   ///< 7fffffff; 80000000 if negative
  symmetric,  ///< 7fffffff; 80000001 if negative
  maximum,    ///< 7fffffff whatever the sign
  minimum,    ///< 80000000 whatever the sign
  zero,       ///< 0
  mirror,     ///< roots only: minus the root of the magnitude, in the subject's rounding
};

struct Rules {
  cases::Operation operation = cases::Operation::mul;  ///< one that is_judged()
  oracle::Rounding rounding = oracle::Rounding::half_up;
  Overflow overflow = Overflow::wrap;
  NoResult no_result = NoResult::error;
};

constexpr bool is_judged(cases::Operation operation) {
  using enum cases::Operation;
  return operation == mul || operation == div || operation == sqrt || operation == add ||
         operation == sub;
}

/// Tells whether results are rounded. Sums and differences of words are exact.
constexpr bool is_rounded(cases::Operation operation) {
  return operation != cases::Operation::add && operation != cases::Operation::sub;
}

/// The names on the command line.
std::string_view name_of(oracle::Rounding rule);
std::string_view name_of(Overflow rule);
std::string_view name_of(NoResult rule);

/// Every rounding, for options and for guesses.
std::span<const oracle::Rounding> roundings();
/// Every overflow rule except `any`.
std::span<const Overflow> overflow_rules();
/// Every rule except `any` that applies to the operation; empty if it has a result for all
/// operands.
std::span<const NoResult> no_result_rules(cases::Operation operation);

/// The rounded result in ulps before overflow handling; empty for x / 0 and negative radicands.
std::optional<std::int64_t> rounded_result(cases::Operation operation,
                                           std::span<const std::uint32_t> words,
                                           oracle::Rounding rule);

constexpr bool fits_word(std::int64_t ulps) {
  return ulps >= -(std::int64_t{1} << 31) && ulps < (std::int64_t{1} << 31);
}

constexpr bool is_negative(std::uint32_t word) { return word >> 31U != 0; }
constexpr std::uint32_t magnitude(std::uint32_t word) {
  return is_negative(word) ? 0U - word : word;
}

/// Tells whether `said` is the rule's result for an overflow.
bool keeps(Overflow rule, std::int64_t ulps, Said said);

/// Tells whether `said` is the rule's result for operands without one; `rounding` is the subject's.
bool keeps(NoResult rule, std::span<const std::uint32_t> words, oracle::Rounding rounding,
           Said said);

/// The expected result of a case. `judged` is false if the rules accept every result.
struct Expected {
  bool judged = true;
  Said said;
};
Expected expected_of(const Rules& rules, std::span<const std::uint32_t> words);

bool keeps(const Rules& rules, std::span<const std::uint32_t> words, Said said);

}  // namespace fixproof::check

/// @file
/// What somebody else's 16.16 arithmetic does, by names: how it rounds, what it makes of a result
/// that does not fit, and of an operand that has no result.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "cases/variant.hpp"
#include "oracle/rule.hpp"

namespace fixproof::check {

/// What a subject says of a case: a word, or nothing for a divide error.
using Said = std::optional<std::uint32_t>;

/// What becomes of a rounded result outside -2^31 ... 2^31 - 1 ulps.
enum class Overflow : std::uint8_t {
  any,        ///< whatever it is, it is accepted
  wrap,       ///< modulo 2^32
  saturate,   ///< 7fffffff; 80000000 if negative
  symmetric,  ///< 7fffffff; 80000001 if negative
  maximum,    ///< 7fffffff whatever the sign
  minimum,    ///< 80000000 whatever the sign
  error,      ///< DE
};

/// What is said where mathematics has no result: of a zero divisor, of the root of a negative
/// number. Signs are those of the dividend; 0 / 0 may also be 0 where a rule goes by the sign.
enum class NoResult : std::uint8_t {
  any,        ///< whatever it is, it is accepted
  error,      ///< DE
  saturate,   ///< 7fffffff; 80000000 if negative
  symmetric,  ///< 7fffffff; 80000001 if negative
  maximum,    ///< 7fffffff whatever the sign
  minimum,    ///< 80000000 whatever the sign
  zero,       ///< 0
  mirror,     ///< of roots: minus the root of the magnitude, rounded by the subject's rule
};

/// What a subject is held to.
struct Rules {
  cases::Operation operation = cases::Operation::mul;  ///< mul, div or sqrt
  oracle::Rounding rounding = oracle::Rounding::half_up;
  Overflow overflow = Overflow::wrap;
  NoResult no_result = NoResult::error;
};

/// The names on the command line.
std::string_view name_of(oracle::Rounding rule);
std::string_view name_of(Overflow rule);
std::string_view name_of(NoResult rule);

/// Every rule by its name, for options and for guesses.
std::span<const oracle::Rounding> roundings();
/// All but `any`.
std::span<const Overflow> overflow_rules();
/// All but `any` that make sense of the operation; none for mul.
std::span<const NoResult> no_result_rules(cases::Operation operation);

/// The result before it is brought into a word, in ulps; nothing for a zero divisor, a negative
/// radicand.
std::optional<std::int64_t> rounded_result(cases::Operation operation,
                                           std::span<const std::uint32_t> words,
                                           oracle::Rounding rule);

constexpr bool fits_word(std::int64_t ulps) {
  return ulps >= -(std::int64_t{1} << 31) && ulps < (std::int64_t{1} << 31);
}

/// Whether `said` is what the rule makes of a result that does not fit.
bool keeps(Overflow rule, std::int64_t ulps, Said said);

/// Whether `said` is what the rule makes of operands that have no result; `rounding` is that of the
/// subject.
bool keeps(NoResult rule, std::span<const std::uint32_t> words, oracle::Rounding rounding,
           Said said);

/// What is right for a case, as far as one word says it: nothing where the rules accept anything.
struct Expected {
  bool judged = true;
  Said said;
};
Expected expected_of(const Rules& rules, std::span<const std::uint32_t> words);

/// Whether `said` is right.
bool keeps(const Rules& rules, std::span<const std::uint32_t> words, Said said);

}  // namespace fixproof::check

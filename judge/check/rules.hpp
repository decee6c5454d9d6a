/// @file
/// The rounding, overflow and no-result rules that third-party fixed-point arithmetic can follow.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "judge/check/operands.hpp"
#include "judge/check/word.hpp"
#include "oracle/rule.hpp"
#include "verify/cases/variant.hpp"

namespace fixproof::check {

/// The result for a rounded value that does not fit a word. A negative value does not fit an
/// unsigned word.
enum class Overflow : std::uint8_t {
  any,        ///< every result is accepted
  wrap,       ///< modulo 2^word_bits
  saturate,   ///< highest(); lowest() if negative
  symmetric,  ///< highest(); minus_highest() if negative
  maximum,    ///< highest() whatever the sign
  minimum,    ///< lowest() whatever the sign
  error,      ///< DE
  word,       ///< Rules::overflow_word
};

/// The result for a zero divisor, for the root of a negative number, for NaN and the infinities,
/// and outside the domain of a function. The sign is that of the dividend, of the product in
/// mul_div, or of the infinity. Rules that depend on the sign also accept 0 for 0 / 0 and NaN.
enum class NoResult : std::uint8_t {
  any,        ///< every result is accepted
  error,      ///< DE
  saturate,   ///< highest(); lowest() if negative
  symmetric,  ///< highest(); minus_highest() if negative
  maximum,    ///< highest() whatever the sign
  minimum,    ///< lowest() whatever the sign
  zero,       ///< 0
  mirror,     ///< roots only: minus the root of the magnitude, in the subject's rounding
  word,       ///< Rules::no_result_word
};

struct PortRule;

/// The largest error that a subject promises for results in range.
struct Within {
  oracle::Ratio bound{};  ///< in ulps, or as a share of the exact result
  bool is_relative = false;
  std::string text{};  ///< as the user wrote it: `2`, `0.5%`
};

struct Rules {
  cases::Variant variant{};  ///< an operation that is_judged(), and its formats
  oracle::Rounding rounding = oracle::Rounding::half_up;
  Overflow overflow = Overflow::wrap;
  NoResult no_result = NoResult::error;
  bool faithful = false;             ///< either neighbour of an inexact result is right
  std::optional<Within> within{};    ///< replaces the rounding
  std::uint64_t overflow_word = 0;   ///< for Overflow::word
  std::uint64_t no_result_word = 0;  ///< for NoResult::word
  const PortRule* port = nullptr;    ///< replaces the rules above, but for sorting cases
};

constexpr bool is_judged(cases::Operation operation) {
  using enum cases::Operation;
  return operation == mul || operation == div || operation == sqrt || operation == add ||
         operation == sub || cases::is_conversion(operation) || cases::is_function(operation) ||
         cases::is_quotient_function(operation) || cases::is_sum(operation);
}

/// Tells whether the operation is a remainder.
constexpr bool is_remainder(cases::Operation operation) {
  return operation == cases::Operation::fmod || operation == cases::Operation::remainder;
}

/// Tells whether an exact result can lie between two words. Sums, differences and remainders of
/// words are exact unless results have a coarser unit; products are in units of 1. The text of a
/// word need only read as that word.
bool is_rounded(const cases::Variant& variant);

/// Tells whether a result can lie outside the range of words. A root can if the format lacks 1.0:
/// rounded up, that of the highest word is beyond it, and sqrt(0.49) in q0_8 is.
constexpr bool can_overflow(const cases::Variant& v) {
  if (v.operation == cases::Operation::to_decimal) return false;
  if (v.from) return true;
  if (is_remainder(v.operation)) return false;
  const bool has_one = v.format.fraction_bits < 0 || whole_one(v.format);
  return v.operation != cases::Operation::sqrt || !has_one;
}

/// Tells whether some operands have no result: a zero divisor, a negative radicand, a double that
/// is not finite, or an operand outside the domain of a function.
constexpr bool can_lack_result(const cases::Variant& v) {
  return cases::divides(v.operation) || v.operation == cases::Operation::from_binary64 ||
         (v.operation == cases::Operation::sqrt && operand_format(v).is_signed) ||
         cases::is_function(v.operation);
}

/// Tells whether operands without a result can be negative: words with a sign, and doubles.
constexpr bool has_sign_without_result(const cases::Variant& v) {
  return v.operation == cases::Operation::from_binary64 || operand_format(v).is_signed;
}

/// The names on the command line.
std::string_view name_of(oracle::Rounding rule);
std::string_view name_of(Overflow rule);
std::string_view name_of(NoResult rule);

/// The text of --rounding for Rules::faithful.
inline constexpr std::string_view faithful = "faithful";
/// What results in range should be: a rounding, `faithful`, `exact`, or a bound on the error.
std::string text_of_rounding(const Rules& rules);
/// The rule's name, or the word that it names.
std::string text_of_overflow(const Rules& rules);
std::string text_of_no_result(const Rules& rules);

/// Every rounding, for options and for guesses.
std::span<const oracle::Rounding> roundings();
/// Every overflow rule with a name except `any`, for options.
std::span<const Overflow> overflow_rules();
/// Every rule with a name except `any` that applies to the operation, for options; empty if it has
/// a result for all operands.
std::span<const NoResult> no_result_rules(cases::Operation operation);
/// Those that differ, for guesses. An unsigned word has no lowest word but 0, and an operand
/// without a sign cannot decide by it.
std::span<const Overflow> overflow_rules(const cases::Format& format);
std::span<const NoResult> no_result_rules(const cases::Variant& variant);

/// A rounded result before overflow handling.
struct Rounded {
  std::uint64_t word = 0;  ///< modulo 2^word_bits
  bool fits = true;
  bool negative = false;
};
/// The rounded result; empty for operands without one.
std::optional<Rounded> rounded_result(const cases::Variant& variant, const Operands& operands,
                                      oracle::Rounding rule);

/// Tells whether `said` is the rule's result for an overflow.
bool keeps(Overflow rule, const cases::Format& format, const Rounded& rounded, Said said);

/// Tells whether `said` is the rule's result for operands without one; `rounding` is the subject's.
bool keeps(NoResult rule, const cases::Format& format, const Operands& operands,
           oracle::Rounding rounding, Said said);

/// Tells whether a word is no farther from the exact result, which must exist, than the bound.
bool is_within(const Within& within, const cases::Variant& variant, const Operands& operands,
               std::uint64_t said);

/// The expected result of a case, the nearest of several. `judged` is false if the rules accept
/// every result.
struct Expected {
  bool judged = true;
  Said said;
};
Expected expected_of(const Rules& rules, const Operands& operands);
bool keeps(const Rules& rules, const Operands& operands, Said said);

/// The same, given the rounded result of the case.
Expected expected_of(const Rules& rules, const Operands& operands,
                     const std::optional<Rounded>& rounded);
bool keeps(const Rules& rules, const Operands& operands, const std::optional<Rounded>& rounded,
           Said said);

}  // namespace fixproof::check

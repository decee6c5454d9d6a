/// @file
/// The rounding, overflow and no-result rules that third-party fixed-point arithmetic can follow.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
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
};

struct PortRule;

struct Rules {
  cases::Operation operation = cases::Operation::mul;  ///< one that is_judged()
  oracle::Rounding rounding = oracle::Rounding::half_up;
  Overflow overflow = Overflow::wrap;
  NoResult no_result = NoResult::error;
  cases::Format format{};
  cases::Format from = cases::q16_16;  ///< of the operands of convert
  const PortRule* port = nullptr;      ///< replaces the rules above, but for sorting cases
};

constexpr bool is_judged(cases::Operation operation) {
  using enum cases::Operation;
  return operation == mul || operation == div || operation == sqrt || operation == add ||
         operation == sub || cases::is_conversion(operation) || cases::is_function(operation) ||
         cases::is_quotient_function(operation);
}

/// Tells whether the operation is a remainder.
constexpr bool is_remainder(cases::Operation operation) {
  return operation == cases::Operation::fmod || operation == cases::Operation::remainder;
}

/// Tells whether results are rounded. Sums, differences and remainders of words are exact, and the
/// text of a word need only read as that word.
constexpr bool is_rounded(cases::Operation operation) {
  using enum cases::Operation;
  return operation != add && operation != sub && operation != to_decimal &&
         !is_remainder(operation);
}

/// Tells whether a result can lie outside the range of words. A root does if a signed word has no
/// bit before the point: sqrt(0.49) in q0_8.
constexpr bool can_overflow(cases::Operation operation, const cases::Format& format) {
  if (operation == cases::Operation::to_decimal || is_remainder(operation)) return false;
  return operation != cases::Operation::sqrt ||
         (format.is_signed && format.fraction_bits == format.word_bits);
}

/// Tells whether some operands have no result: a zero divisor, a negative radicand, a double that
/// is not finite, or an operand outside the domain of a function.
constexpr bool can_lack_result(cases::Operation operation, const cases::Format& format) {
  return cases::divides(operation) || operation == cases::Operation::from_binary64 ||
         (operation == cases::Operation::sqrt && format.is_signed) || cases::is_function(operation);
}

/// The names on the command line.
std::string_view name_of(oracle::Rounding rule);
std::string_view name_of(Overflow rule);
std::string_view name_of(NoResult rule);

/// Every rounding, for options and for guesses.
std::span<const oracle::Rounding> roundings();
/// Every overflow rule except `any`, for options.
std::span<const Overflow> overflow_rules();
/// Every rule except `any` that applies to the operation, for options; empty if it has a result for
/// all operands.
std::span<const NoResult> no_result_rules(cases::Operation operation);
/// Those that differ in the format, for guesses. An unsigned word has no sign to decide by.
std::span<const Overflow> overflow_rules(const cases::Format& format);
std::span<const NoResult> no_result_rules(cases::Operation operation, const cases::Format& format);

/// A rounded result before overflow handling.
struct Rounded {
  std::uint64_t word = 0;  ///< modulo 2^word_bits
  bool fits = true;
  bool negative = false;
};
/// The rounded result; empty for operands without one.
std::optional<Rounded> rounded_result(cases::Operation operation, const cases::Format& format,
                                      const Operands& operands, oracle::Rounding rule);

/// Tells whether `said` is the rule's result for an overflow.
bool keeps(Overflow rule, const cases::Format& format, const Rounded& rounded, Said said);

/// Tells whether `said` is the rule's result for operands without one; `rounding` is the subject's.
bool keeps(NoResult rule, const cases::Format& format, const Operands& operands,
           oracle::Rounding rounding, Said said);

/// The expected result of a case. `judged` is false if the rules accept every result.
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

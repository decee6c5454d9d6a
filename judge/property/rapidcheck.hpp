/// @file
/// A RapidCheck property for a function, with operands from judge/property/generator.hpp, which
/// shrinks failing ones.
#pragma once

#include <rapidcheck.h>

#include <array>
#include <cstdint>
#include <string>

#include "fixed/number.hpp"
#include "judge/property/generator.hpp"
#include "judge/property/gtest.hpp"
#include "judge/property/subject.hpp"

namespace fixproof::property {

/// Whether the function satisfies its rules for random operands; prints the smallest failing ones.
/// The operands are of Number, which is also the subject's.
template <class Number = fixproof::q16_16>
bool property_holds(const Subject& subject) {
  const auto check = [&](std::span<const std::uint64_t> words) {
    if (holds(subject, words)) return;
    check::JudgedCase kept{1, "RapidCheck", {}, subject.ask(words)};
    std::copy(words.begin(), words.end(), kept.words.begin());
    RC_FAIL(check::text_of(kept, subject.rules));
  };
  const auto word = [](Number x) { return *detail::word_of(x.raw()); };
  if (cases::words_in(subject.rules.variant.operation) == 1) {
    return rc::check(subject.name, [&](Number a) { check(std::array{word(a)}); });
  }
  return rc::check(subject.name, [&](Number a, Number b) { check(std::array{word(a), word(b)}); });
}

/// Registers the test `Fixproof_NAME.property`.
template <class Number = fixproof::q16_16>
bool register_property(const Subject& subject, const char* file, int line) {
  return register_test(subject.name, "property", file, line, [subject]() -> std::string {
    return property_holds<Number>(subject) ? "" : "RapidCheck has found a case, see above";
  });
}

}  // namespace fixproof::property

// NOLINTBEGIN(cppcoreguidelines-macro-usage): function names become test names
#define FIXPROOF_PROPERTY_IN(number, function, operation, rounding, overflow, no_result)   \
  [[maybe_unused]] static const bool fixproof_property_##operation##_##function =          \
      ::fixproof::property::register_property<number>(                                     \
          FIXPROOF_SUBJECT_IN(number, function, operation, rounding, overflow, no_result), \
          __FILE__, __LINE__);
#define FIXPROOF_PROPERTY_MUL_IN(number, function, rounding, overflow) \
  FIXPROOF_PROPERTY_IN(number, function, mul, rounding, overflow, any)
#define FIXPROOF_PROPERTY_DIV_IN(number, function, rounding, overflow, zero_divisor) \
  FIXPROOF_PROPERTY_IN(number, function, div, rounding, overflow, zero_divisor)
#define FIXPROOF_PROPERTY_SQRT_IN(number, function, rounding, negative_operand) \
  FIXPROOF_PROPERTY_IN(number, function, sqrt, rounding, any, negative_operand)
#define FIXPROOF_PROPERTY(function, operation, rounding, overflow, no_result) \
  FIXPROOF_PROPERTY_IN(::fixproof::q16_16, function, operation, rounding, overflow, no_result)
#define FIXPROOF_PROPERTY_MUL(function, rounding, overflow) \
  FIXPROOF_PROPERTY(function, mul, rounding, overflow, any)
#define FIXPROOF_PROPERTY_DIV(function, rounding, overflow, zero_divisor) \
  FIXPROOF_PROPERTY(function, div, rounding, overflow, zero_divisor)
#define FIXPROOF_PROPERTY_SQRT(function, rounding, negative_operand) \
  FIXPROOF_PROPERTY(function, sqrt, rounding, any, negative_operand)
// NOLINTEND(cppcoreguidelines-macro-usage)

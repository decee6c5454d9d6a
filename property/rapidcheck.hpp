/// @file
/// A RapidCheck property for a function, with operands from property/generator.hpp, which shrinks
/// failing ones.
#pragma once

#include <rapidcheck.h>

#include <array>
#include <cstdint>
#include <string>

#include "fixed/number.hpp"
#include "property/generator.hpp"
#include "property/gtest.hpp"
#include "property/subject.hpp"

namespace fixproof::property {

/// Whether the function satisfies its rules for random operands; prints the smallest failing ones.
inline bool property_holds(const Subject& subject) {
  using Number = fixproof::q16_16;
  const auto check = [&](std::span<const std::uint32_t> words) {
    if (holds(subject, words)) return;
    check::JudgedCase kept{1, "RapidCheck", {}, subject.ask(words)};
    std::copy(words.begin(), words.end(), kept.words.begin());
    RC_FAIL(check::text_of(kept, subject.rules));
  };
  const auto word = [](Number x) { return static_cast<std::uint32_t>(x.raw()); };
  if (cases::words_in(subject.rules.operation) == 1) {
    return rc::check(subject.name, [&](Number a) { check(std::array{word(a)}); });
  }
  return rc::check(subject.name, [&](Number a, Number b) { check(std::array{word(a), word(b)}); });
}

/// Registers the test `Fixproof_NAME.property`.
inline bool register_property(const Subject& subject, const char* file, int line) {
  return register_test(subject.name, "property", file, line, [subject]() -> std::string {
    return property_holds(subject) ? "" : "RapidCheck has found a case, see above";
  });
}

}  // namespace fixproof::property

// NOLINTBEGIN(cppcoreguidelines-macro-usage): function names become test names
#define FIXPROOF_PROPERTY(function, operation, rounding, overflow, no_result)             \
  [[maybe_unused]] static const bool fixproof_property_##operation##_##function =         \
      ::fixproof::property::register_property(                                            \
          FIXPROOF_SUBJECT(function, operation, rounding, overflow, no_result), __FILE__, \
          __LINE__);
#define FIXPROOF_PROPERTY_MUL(function, rounding, overflow) \
  FIXPROOF_PROPERTY(function, mul, rounding, overflow, any)
#define FIXPROOF_PROPERTY_DIV(function, rounding, overflow, zero_divisor) \
  FIXPROOF_PROPERTY(function, div, rounding, overflow, zero_divisor)
#define FIXPROOF_PROPERTY_SQRT(function, rounding, negative_operand) \
  FIXPROOF_PROPERTY(function, sqrt, rounding, any, negative_operand)
// NOLINTEND(cppcoreguidelines-macro-usage)

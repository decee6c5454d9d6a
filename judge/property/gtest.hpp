/// @file
/// GoogleTest cases for a function, one per stream of cases.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>

#include "judge/property/subject.hpp"

namespace fixproof::property {

/// A test that calls a function and fails with the text it returns, if any.
class CalledTest : public testing::Test {
 public:
  explicit CalledTest(std::function<std::string()> body) : body_(std::move(body)) {}
  void TestBody() override {
    const std::string wrong = body_();
    if (!wrong.empty()) ADD_FAILURE() << wrong;
  }

 private:
  std::function<std::string()> body_;
};

/// Registers the test `Fixproof_NAME.TEST`.
inline bool register_test(const std::string& name, const std::string& test, const char* file,
                          int line, const std::function<std::string()>& body) {
  testing::RegisterTest(("Fixproof_" + name).c_str(), test.c_str(), nullptr, nullptr, file, line,
                        [body]() -> CalledTest* { return new CalledTest(body); });
  return true;
}

/// Registers one test per stream of cases.
inline bool register_streams(const Subject& subject, const char* file, int line) {
  for (const auto& [stream, cases] :
       streams_of(subject.rules.variant.operation, subject.rules.variant.format)) {
    register_test(
        subject.name, std::string(cases::name_of(stream)), file, line,
        [subject, stream = stream, cases = cases] { return failures_in(subject, stream, cases); });
  }
  return true;
}

}  // namespace fixproof::property

// NOLINTBEGIN(cppcoreguidelines-macro-usage): function names become test names

/// Takes rules by their names, as enumerators of judge/check/rules.hpp, and the format as a type of
/// fixed/formats.hpp.
#define FIXPROOF_SUBJECT_IN(number, function, operation, rounding, overflow, no_result)   \
  ::fixproof::property::subject<number>(                                                  \
      #function,                                                                          \
      ::fixproof::property::rules_of(                                                     \
          ::fixproof::cases::Operation::operation, ::oracle::Rounding::rounding,          \
          ::fixproof::check::Overflow::overflow, ::fixproof::check::NoResult::no_result), \
      [](auto... operands) -> decltype(function(operands...)) { return function(operands...); })

#define FIXPROOF_SUBJECT(function, operation, rounding, overflow, no_result) \
  FIXPROOF_SUBJECT_IN(::fixproof::q16_16, function, operation, rounding, overflow, no_result)

/// Registers tests in the current namespace. A trailing semicolon is optional.
#define FIXPROOF_CHECK_IN(number, function, operation, rounding, overflow, no_result)      \
  [[maybe_unused]] static const bool fixproof_check_##operation##_##function =             \
      ::fixproof::property::register_streams(                                              \
          FIXPROOF_SUBJECT_IN(number, function, operation, rounding, overflow, no_result), \
          __FILE__, __LINE__);
#define FIXPROOF_CHECK_MUL_IN(number, function, rounding, overflow) \
  FIXPROOF_CHECK_IN(number, function, mul, rounding, overflow, any)
#define FIXPROOF_CHECK_DIV_IN(number, function, rounding, overflow, zero_divisor) \
  FIXPROOF_CHECK_IN(number, function, div, rounding, overflow, zero_divisor)
#define FIXPROOF_CHECK_SQRT_IN(number, function, rounding, negative_operand) \
  FIXPROOF_CHECK_IN(number, function, sqrt, rounding, any, negative_operand)
#define FIXPROOF_CHECK(function, operation, rounding, overflow, no_result) \
  FIXPROOF_CHECK_IN(::fixproof::q16_16, function, operation, rounding, overflow, no_result)
#define FIXPROOF_CHECK_MUL(function, rounding, overflow) \
  FIXPROOF_CHECK(function, mul, rounding, overflow, any)
#define FIXPROOF_CHECK_DIV(function, rounding, overflow, zero_divisor) \
  FIXPROOF_CHECK(function, div, rounding, overflow, zero_divisor)
#define FIXPROOF_CHECK_SQRT(function, rounding, negative_operand) \
  FIXPROOF_CHECK(function, sqrt, rounding, any, negative_operand)
// NOLINTEND(cppcoreguidelines-macro-usage)

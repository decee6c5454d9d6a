// Tests the errors of functions: those that fixed/ promises, and those of other libraries that
// `fixproof check` publishes in docs/functions.md.
#include "measure/accuracy/function_accuracy.hpp"

#include <map>

#include "support/usage_error.hpp"
#include "tests/measure/never.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;

/// The rows by "function, variant".
std::map<std::string, measure::AccuracyRow> rows_of(const std::string& function,
                                                    std::string_view format,
                                                    std::optional<std::uint64_t> count) {
  measure::MeasureRequest request;
  request.format = cases::format_named(format);
  request.function = function;
  request.cases = count;
  measure::MeasureProgress progress(never);
  std::map<std::string, measure::AccuracyRow> rows;
  const auto result = measure::measure_function_accuracy(request, progress);
  for (const auto& row : result->rows) {
    rows[row.operation + ", " + row.variant] = row;
  }
  return rows;
}

TEST(FunctionAccuracy, TheTypeIsCorrectInEveryFunctionAndFormat) {
  for (const std::string format : {"q16_16", "q8_24", "u8_8"}) {
    const auto rows = rows_of("all", format, 300);
    std::size_t functions = 0;
    for (const auto& [name, row] : rows) {
      EXPECT_EQ(row.errors.cases() + row.beyond, 300U) << name << format;
      if (row.variant != format || !row.curve) continue;
      ++functions;
      EXPECT_LE(row.errors.max(), 0.5) << name << format;
      EXPECT_EQ(row.errors.correct(), 1) << name << format;
      EXPECT_EQ(row.curve->order.wrong, 0U) << name << format;
      EXPECT_EQ(row.curve->symmetry.wrong, 0U) << name << format;
    }
    EXPECT_GE(functions, 28U) << format << ": few functions have no result that fits";
  }
}

// A word of 16.16 has 32 bits. A double has 21 more, so it is right wherever its own error decides
// nothing; a float has 24, so its result of 2^14 or more is off by up to half of 2^6 ulps, and the
// operand's rounding adds more.
TEST(FunctionAccuracy, FloatingPointIsAsGoodAsItsSignificand) {
  const auto rows = rows_of("exp", "q16_16", {});
  EXPECT_EQ(rows.at("exp, double").errors.correct(), 1);
  EXPECT_GT(rows.at("exp, float").errors.max(), 32);
  EXPECT_LT(rows.at("exp, float").errors.max(), 1000);
  EXPECT_EQ(rows.at("exp, float").curve->order.wrong, 0U);
}

// The figures of `fixproof gen exp | libfixmath exp | fixproof check exp`, in docs/functions.md.
TEST(FunctionAccuracy, LibrariesHaveTheErrorsThatCheckFinds) {
  if (measure::has_libfixmath()) {
    const auto exp = rows_of("exp", "q16_16", {}).at("exp, libfixmath");
    EXPECT_EQ(exp.errors.cases(), 13'235U);
    EXPECT_NEAR(exp.errors.correct(), 0.898, 0.0005);
    EXPECT_NEAR(exp.errors.max(), 22'744, 0.5);
    EXPECT_TRUE(exp.worst.ends_with(" (10.39719)")) << exp.worst;
    EXPECT_NEAR(exp.curve->mean_error, 22.17958, 5e-6);
    EXPECT_EQ(exp.curve->order.wrong, 0U);
    // And those of `fixproof gen tan --cases 2000`.
    const auto tan = rows_of("tan", "q16_16", 2000).at("tan, libfixmath");
    EXPECT_EQ(tan.curve->order.wrong, 65U);
    EXPECT_EQ(tan.curve->order.pairs, 1'806U);
    EXPECT_EQ(tan.curve->order.first, "80209ac6 and 80222ce8");
    const auto atan2 = rows_of("atan2", "q16_16", 2000).at("atan2, libfixmath");
    EXPECT_EQ(atan2.errors.cases(), 2'000U);
    EXPECT_NEAR(atan2.errors.max(), 1'686'685'967, 0.5);
    EXPECT_EQ(atan2.worst, "00000000 00000000 (0 0)");
  }
  if (measure::has_freetype()) {
    const auto sine = rows_of("sin_of_degrees", "q16_16", {}).at("sin_of_degrees, FreeType");
    EXPECT_EQ(sine.errors.cases(), 23'391U);
    EXPECT_NEAR(sine.errors.max(), 0.562, 0.0005);
    EXPECT_TRUE(sine.worst.ends_with(" (24841.37573)")) << sine.worst;
  }
}

// A double holds every word, so its remainders are right. A length near 2^31 can be within 2^-34 of
// a half, which the 53 bits of a double do not tell. A float is off wherever an operand has more
// than 24 bits: a remainder then by any amount below the divisor.
TEST(FunctionAccuracy, RemaindersQuotientsOfProductsAndLengths) {
  for (const std::string function : {"fmod", "remainder", "mul_div", "hypot3"}) {
    const auto rows = rows_of(function, "q16_16", 5000);
    const auto& type = rows.at(function + ", q16_16");
    EXPECT_EQ(type.errors.cases() + type.beyond, 5000U) << function;
    EXPECT_GT(type.errors.cases(), 2000U) << function;
    EXPECT_LE(type.errors.max(), 0.5) << function;
    EXPECT_EQ(type.errors.correct(), 1) << function;
    const auto& of_double = rows.at(function + ", double").errors;
    if (function == "fmod" || function == "remainder") {
      EXPECT_EQ(of_double.correct(), 1) << function;
    }
    if (function == "hypot3") {
      EXPECT_LT(of_double.correct(), 1);
      EXPECT_NEAR(of_double.max(), 0.5, 1e-6);
    }
    EXPECT_LT(rows.at(function + ", float").errors.correct(), 0.99) << function;
  }
}

TEST(FunctionAccuracy, OtherFormatsHaveNoLibraries) {
  const auto rows = rows_of("exp", "q8_24", 100);
  for (const auto& [name, row] : rows) {
    EXPECT_TRUE(row.variant == "q8_24" || row.variant == "float" || row.variant == "double")
        << name;
  }
}

TEST(FunctionAccuracy, RefusesWhatItCannotMeasure) {
  const std::vector<std::pair<std::string, std::string>> refused{
      {"sqrt", "q16_16"}, {"", "q16_16"},    {"exp", "q32_32"},    {"exp", "q3_29"},
      {"fmod", "q32_32"}, {"all", "q32_32"}, {"remainder", "u8_8"}};
  for (const auto& [function, format] : refused) {
    EXPECT_THROW(rows_of(function, format, 1), support::UsageError) << function << format;
  }
}

}  // namespace

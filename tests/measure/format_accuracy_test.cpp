// Tests that the errors in a format are those that its rounding rules promise.
#include "measure/accuracy/format_accuracy.hpp"

#include <fmt/format.h>

#include <map>

#include "tests/measure/never.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;

constexpr std::uint64_t cases = 20'000;
/// The standard deviations of errors that are uniform over one ulp, and over two.
constexpr double one_ulp = 0.288675;
constexpr double two_ulps = 0.577350;

/// The rows by "operation, operands, variant".
std::map<std::string, measure::AccuracyRow> rows_in(std::string_view format) {
  measure::MeasureRequest request;
  request.format = cases::format_named(format);
  request.cases = cases;
  request.seed = 7;
  measure::MeasureProgress progress(never);
  std::map<std::string, measure::AccuracyRow> rows;
  const auto result = measure::measure_format_accuracy(request, progress);
  if (!result) return rows;
  for (const auto& row : result->rows) {
    rows[row.operation + ", " + row.operands + ", " + row.variant] = row;
  }
  return rows;
}

/// Five standard errors of a mean.
double margin(double deviation) { return 5 * deviation / std::sqrt(cases); }

TEST(FormatAccuracy, EveryRuleHasTheErrorsThatItPromises) {
  for (const std::string format : {"q2_30", "q8_24", "q32_32"}) {
    const auto rows = rows_in(format);
    for (const std::string operation : {"mul", "div"}) {
      const auto errors = [&](const std::string& rule) {
        return rows.at(fmt::format("{}, uniform, {}, {}", operation, format, rule)).errors;
      };
      for (const char* nearest : {"half up", "half even", "half away"}) {
        EXPECT_LE(errors(nearest).max(), 0.5) << operation << format << nearest;
        EXPECT_GT(errors(nearest).max(), 0.49);
        EXPECT_EQ(errors(nearest).correct(), 1);
        EXPECT_NEAR(errors(nearest).mean(), 0, margin(one_ulp));
      }
      for (const char* directed : {"floor", "truncate"}) {
        EXPECT_LT(errors(directed).max(), 1) << operation << format << directed;
        EXPECT_GT(errors(directed).max(), 0.99);
        EXPECT_NEAR(errors(directed).correct(), 0.5, 0.03);
      }
      EXPECT_NEAR(errors("floor").mean(), -0.5, margin(one_ulp));
      EXPECT_NEAR(errors("truncate").mean(), 0, margin(two_ulps));
    }
    const auto roots = rows.at("sqrt, uniform, " + format).errors;
    EXPECT_EQ(roots.cases(), cases) << "no operand is negative";
    EXPECT_LE(roots.max(), 0.5);
    EXPECT_EQ(roots.correct(), 1);
  }
}

TEST(FormatAccuracy, WithoutASignTruncationIsFloor) {
  const auto rows = rows_in("u16_16");
  for (const char* operation : {"mul", "div"}) {
    const std::string row = std::string(operation) + ", log-uniform, u16_16, ";
    const auto& floor = rows.at(row + "floor").errors;
    EXPECT_EQ(rows.at(row + "truncate").errors.mean(), floor.mean());
    EXPECT_LT(floor.mean(), -0.3);
  }
}

// Factors have 7 bits, so 1 product in 30 is a tie.
TEST(FormatAccuracy, TiesMakeOnlyHalfUpABias) {
  const auto rows = rows_in("q1_7");
  const auto mean = [&](const std::string& rule) {
    return rows.at("mul, uniform, q1_7, " + rule).errors.mean();
  };
  EXPECT_GT(mean("half up"), margin(one_ulp));
  EXPECT_NEAR(mean("half even"), 0, margin(one_ulp));
  EXPECT_NEAR(mean("half away"), 0, margin(one_ulp));
}

// A product of two words of 8 bits has 14 bits, one of 32 bits has 62, one of 64 bits has 94.
TEST(FormatAccuracy, FloatingPointIsAsGoodAsItsSignificand) {
  const auto largest = [](std::string_view format, const char* variant) {
    return rows_in(format).at(std::string("mul, uniform, ") + variant).errors.max();
  };
  EXPECT_EQ(largest("q1_7", "float"), 0);
  EXPECT_GT(largest("q2_30", "float"), 32);
  EXPECT_LE(largest("q2_30", "float"), 96) << "factors off by 2^-25, and the product";
  EXPECT_LT(largest("q2_30", "double"), 1e-6);
  EXPECT_GT(largest("q48_16", "double"), 100);
}

TEST(FormatAccuracy, CasesWithoutAResultThatFitsAreLeftOut) {
  for (const auto& [name, row] : rows_in("q2_30")) {
    EXPECT_EQ(row.errors.cases() + row.beyond, cases) << name;
    // |x / y| < 2 in three of four cases, and every product and every root fits.
    const double left_out = name.starts_with("div, uniform") ? 0.25 * cases : 0;
    if (name.find("log-uniform") != std::string::npos) continue;
    EXPECT_NEAR(static_cast<double>(row.beyond), left_out, 0.02 * cases) << name;
  }
}

}  // namespace

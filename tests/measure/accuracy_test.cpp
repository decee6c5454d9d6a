// Tests that the measurement finds the known errors of each rounding.
#include "fixed/fixed.hpp"
#include "measure/accuracy/accuracy_run.hpp"
#include "oracle/real.hpp"
#include "tests/measure/never.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;

measure::MeasuredOperation operation_named_here(std::string_view name) {
  for (measure::MeasuredOperation& o : measure::measured_operations()) {
    if (o.name == name) return std::move(o);
  }
  throw std::invalid_argument("no such operation");
}

measure::AccuracyRow row_of_set(std::string_view operation, std::string_view subject,
                                const measure::OperandSet& set) {
  for (measure::AccuracyRow& row :
       measure::measure_errors(operation_named_here(operation), set, never)) {
    if (row.variant == subject) return std::move(row);
  }
  throw std::invalid_argument("no such subject");
}
measure::AccuracyRow uniform(std::string_view operation, std::string_view subject) {
  return row_of_set(operation, subject,
                    measure::random_operands(operation_named_here(operation), 7, 20'000).front());
}

// 1 unit * 8000h units is half a unit: half up gives 1, an error of +1/2. -1 unit gives 0.
TEST(Accuracy, ErrorsOfTwoTies) {
  const measure::OperandSet ties{"ties", {1, 0x8000, 0xFFFFFFFF, 0x8000}};
  const auto up = row_of_set("mul", "q16_16", ties).errors;
  EXPECT_EQ(up.cases(), 2U);
  EXPECT_EQ(up.mean(), 0.5);
  EXPECT_EQ(up.correct(), 1) << "of two that are as near, either";
  const auto away = row_of_set("mul", "q16_16_i8088", ties).errors;
  EXPECT_EQ(away.mean(), 0);
  EXPECT_EQ(away.max(), 0.5);
  const auto down = row_of_set("mul", "q16_16_i386_unrounded", ties).errors;
  EXPECT_EQ(down.mean(), -0.5);
}

TEST(Accuracy, TruncationIsNotTheNearest) {
  const measure::OperandSet one{"one", {3, 0x4000}};
  const auto down = row_of_set("mul", "q16_16_i8088_unrounded", one).errors;
  EXPECT_EQ(down.mean(), -0.75);
  EXPECT_EQ(down.correct(), 0);
  EXPECT_EQ(row_of_set("mul", "q16_16", one).errors.mean(), 0.25);
}

TEST(Accuracy, WhatDoesNotFitIsLeftOut) {
  // 32767 * 2, 1 / 0 and the most negative word / -1.0 do not fit; that word / 1.0 does.
  const measure::OperandSet products{"", {0x7FFF0000, 0x00020000}};
  EXPECT_EQ(row_of_set("mul", "q16_16", products).beyond, 1U);
  const measure::OperandSet quotients{"", {1, 0, 0x80000000, 0xFFFF0000, 0x80000000, 0x00010000}};
  const measure::AccuracyRow row = row_of_set("div", "q16_16", quotients);
  EXPECT_EQ(row.beyond, 2U);
  EXPECT_EQ(row.errors.cases(), 1U);
  EXPECT_EQ(row.errors.max(), 0);
}

// 1.0 / 1.5: the 8088 divides by 1, which is off by 1/3. 1.0 / 0.5 faults.
TEST(Accuracy, The8088DividesByTheWholePart) {
  const measure::OperandSet set{"", {0x00010000, 0x00018000, 0x00010000, 0x00008000}};
  const measure::AccuracyRow row = row_of_set("div", "q16_16_i8088", set);
  EXPECT_EQ(row.faults, 1U);
  EXPECT_DOUBLE_EQ(row.errors.max(), 65536.0 / 3);
}

TEST(Accuracy, ARoundedProductIsHalfAUnitOffAtMostAndHasNoBias) {
  for (const char* subject : {"q16_16", "q16_16_i8088"}) {
    const auto errors = uniform("mul", subject).errors;
    EXPECT_EQ(errors.cases(), 20'000U);
    EXPECT_LE(errors.max(), 0.5);
    EXPECT_GT(errors.max(), 0.49);
    // Uniform errors: the rms is 1 / sqrt(12), and the mean lies within five of its deviations.
    EXPECT_NEAR(errors.root_mean_square(), std::sqrt(1.0 / 12), 0.01);
    EXPECT_NEAR(errors.mean(), 0, 5 * 0.289 / std::sqrt(20'000));
    EXPECT_EQ(errors.correct(), 1);
  }
}

TEST(Accuracy, AProductTowardMinusInfinityIsHalfAUnitLowOnTheWhole) {
  const auto errors = uniform("mul", "q16_16_i386_unrounded").errors;
  EXPECT_LT(errors.max(), 1);
  EXPECT_NEAR(errors.mean(), -0.5, 5 * 0.289 / std::sqrt(20'000));
  EXPECT_NEAR(errors.correct(), 0.5, 0.02);
}

TEST(Accuracy, AProductTowardZeroHasNoBias) {
  const auto errors = uniform("mul", "q16_16_i8088_unrounded").errors;
  EXPECT_LT(errors.max(), 1);
  EXPECT_GT(errors.max(), 0.99);
  EXPECT_NEAR(errors.mean(), 0, 5 * 0.577 / std::sqrt(20'000));
  EXPECT_NEAR(errors.root_mean_square(), std::sqrt(1.0 / 3), 0.01);
}

TEST(Accuracy, DividesOfTheTypeAreRoundedOnce) {
  EXPECT_LE(uniform("div", "q16_16").errors.max(), 0.5);
  EXPECT_LE(uniform("div", "q16_16_i386").errors.max(), 0.5);
  EXPECT_LT(uniform("div", "q16_16_i386_unrounded").errors.max(), 1);
}

TEST(Accuracy, RootsAndCosinesAreTheNearest) {
  for (const char* operation : {"sqrt", "cos", "sin"}) {
    const auto errors = uniform(operation, "q16_16").errors;
    EXPECT_GT(errors.cases(), 3000U);
    EXPECT_LE(errors.max(), 0.5) << operation;
    EXPECT_EQ(errors.correct(), 1) << operation;
  }
}

TEST(Accuracy, ThreeRoundedProductsAreThreeTimesAsFarOffAtMost) {
  const auto thrice = uniform("dot of rounded products", "q16_16").errors;
  EXPECT_LE(thrice.max(), 1.5);
  EXPECT_GT(thrice.max(), 1.2);
  EXPECT_NEAR(thrice.root_mean_square(), std::sqrt(3.0 / 12), 0.01);
  const auto once = uniform("dot rounded once", "q16_16").errors;
  EXPECT_LE(once.max(), 0.5);
  EXPECT_EQ(once.correct(), 1);
  EXPECT_NEAR(uniform("dot of rounded products", "q16_16_i386_unrounded").errors.mean(), -1.5,
              0.02);
}

// sqrt(2) = 1.41421356237309504..., cos(60 degrees) = 1/2, sin(1) = 0.84147098480789650...
TEST(Accuracy, ReferencesThatAreNoRatios) {
  const auto value = [](const oracle::Integer& scaled) {
    return std::ldexp(static_cast<double>(scaled), -16 - 40);
  };
  EXPECT_NEAR(value(oracle::scaled_sqrt(0x20000, 40)), 1.41421356237309504, 1e-15);
  EXPECT_EQ(value(oracle::scaled_cos(600, 40)), 0.5);
  EXPECT_EQ(value(oracle::scaled_cos(-900, 40)), 0);
  EXPECT_NEAR(value(oracle::scaled_cos(1350, 40)), -std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(value(oracle::scaled_sin_of_radians(0x10000, 40)), 0.84147098480789650, 1e-15);
  for (int tenths = -3600; tenths <= 3600; ++tenths) {
    const long double radians = tenths * (3.14159265358979323846L / 1800);
    ASSERT_NEAR(value(oracle::scaled_cos(tenths, 40)), static_cast<double>(std::cos(radians)),
                1e-15)
        << tenths;
  }
  EXPECT_THROW(static_cast<void>(oracle::scaled_sqrt(0xFFFFFFFF, 40)), std::domain_error);
}

// 24-bit words are exact in float. In float, products of 2^29 units and more are multiples of 64.
TEST(Accuracy, FloatingPointIsMeasuredInTheSameUnits) {
  const auto of_double = uniform("mul", "double").errors;
  EXPECT_EQ(of_double.max(), 0);
  EXPECT_EQ(of_double.correct(), 1);
  const auto of_float = uniform("mul", "float").errors;
  EXPECT_GT(of_float.max(), 16);
  EXPECT_LE(of_float.max(), 32);
  EXPECT_EQ(row_of_set("div", "double", {"", {0x10000, 0x20000}}).errors.max(), 0);
  // 1 unit / 3.0 is a third of a unit, which double represents to 2^-54.
  EXPECT_LT(row_of_set("div", "double", {"", {1, 0x30000}}).errors.max(), 1e-16);
  EXPECT_LE(uniform("cos", "double").errors.max(), 1e-9);
  // Roots are at most 2^23.5 units, rounded by half a unit, of operands that are off by 2^-24
  // relative.
  EXPECT_LE(uniform("sqrt", "float").errors.max(), 0.86);
}

TEST(Accuracy, FreeTypeRoundsHalvesAwayFromZero) {
  if (!measure::has_freetype()) GTEST_SKIP() << "FreeType is not installed";
  const measure::OperandSet ties{"ties", {1, 0x8000, 0xFFFFFFFF, 0x8000}};
  EXPECT_EQ(row_of_set("mul", "FreeType", ties).errors.mean(), 0);
  EXPECT_EQ(row_of_set("mul", "FreeType", ties).errors.max(), 0.5);
  EXPECT_EQ(uniform("div", "FreeType").errors.correct(), 1);
}

template <class One, class Other>
void expect_same_products_and_quotients(bool quotients) {
  const measure::OperandSet set =
      measure::random_operands(operation_named_here("div"), 7, 2'000).front();
  for (std::size_t i = 0; i + 2 <= set.words.size(); i += 2) {
    // a is small enough for every product to fit, and b large enough for every quotient.
    const auto a = static_cast<std::int32_t>(set.words[i]) >> 8;
    const auto b = static_cast<std::int32_t>(set.words[i + 1]) >> 8 | 0x20000;
    ASSERT_EQ((One::from_raw(a) * One::from_raw(b)).raw(),
              (Other::from_raw(a) * Other::from_raw(b)).raw());
    if (!quotients) continue;
    ASSERT_EQ((One::from_raw(a) / One::from_raw(b)).raw(),
              (Other::from_raw(a) / Other::from_raw(b)).raw());
  }
}

TEST(Accuracy, PresetsThatAreSaidToBeAlikeAre) {
  using namespace fixproof;
  expect_same_products_and_quotients<q16_16, q16_16_saturating>(true);
  expect_same_products_and_quotients<q16_16, q16_16_trapping>(true);
  expect_same_products_and_quotients<q16_16, q16_16_i386>(false);
  expect_same_products_and_quotients<q16_16, q16_16_i386_mul_rounded>(false);
  expect_same_products_and_quotients<q16_16_i386_unrounded, q16_16_i386_div_rounded>(false);
  expect_same_products_and_quotients<q16_16_i8088, q16_16_i8088_mul_rounded>(false);
  expect_same_products_and_quotients<q16_16_i8088_unrounded, q16_16_i8088_div_rounded>(false);
}

/// 30000 * 2 - 30000 * 1 as a sum of products: the sum fits, the first product does not.
template <class N>
N difference_of_products() {
  return N(30000) * N(2) + N(-30000) * N(1);
}

TEST(Accuracy, AlikeWhereTheSumFitsAreThoseThatWrap) {
  using namespace fixproof;
  EXPECT_EQ(difference_of_products<q16_16>(), q16_16(30000));
  EXPECT_EQ(difference_of_products<q16_16_i386>(), q16_16_i386(30000));
  EXPECT_EQ(difference_of_products<q16_16_i386_mul_rounded>(), q16_16_i386_mul_rounded(30000));
  // The largest word, 32768 less a unit, minus 30000.
  EXPECT_EQ(difference_of_products<q16_16_saturating>().raw(), 2768 * 65536 - 1);
  EXPECT_THROW(static_cast<void>(difference_of_products<q16_16_trapping>()), std::overflow_error);
  const auto alike = [](std::string_view operation) {
    return operation_named_here(operation).subjects.front().alike;
  };
  EXPECT_EQ(alike("dot of rounded products"), "_i386 _i386_mul_rounded");
  // With one rounding, intermediate results need not fit.
  EXPECT_EQ(alike("dot rounded once"), "_saturating _trapping _i386 _i386_mul_rounded");
  const auto once = []<class N>(N) {
    return dot(std::array{N(30000), N(-30000)}, std::array{N(2), N(1)});
  };
  EXPECT_EQ(once(q16_16()), q16_16(30000));
  EXPECT_EQ(once(q16_16_saturating()), q16_16_saturating(30000));
  EXPECT_EQ(once(q16_16_trapping()), q16_16_trapping(30000));
}

// libfixmath's long division starts from an estimate that omits at most one unit of the remainder.
// At the smallest divisor for which it does so, 2^20, that is 1/16 of a unit of the quotient.
TEST(Accuracy, LibfixmathDivideIsMoreThanHalfAUnitOffInOneCaseOfAThousand) {
  if (!measure::has_libfixmath()) GTEST_SKIP() << "libfixmath is not installed";
  const auto sets = measure::random_operands(operation_named_here("div"), 7, 200'000);
  ASSERT_EQ(sets.at(1).name, "uniform to 2048");
  const auto errors = row_of_set("div", "libfixmath", sets.at(1)).errors;
  EXPECT_NEAR(1 - errors.correct(), 0.001, 0.0005);
  EXPECT_GT(errors.max(), 0.5);
  EXPECT_LT(errors.max(), 0.5625);
  // 13668.44558... / 16.00575... is 55965922.5624 units; libfixmath returns ...922.
  const auto worst = row_of_set("div", "libfixmath", {"", {0x35647212, 0x00100179}}).errors;
  EXPECT_NEAR(worst.max(), 0.562366, 1e-6);
  EXPECT_EQ(worst.correct(), 0);
}

}  // namespace

// Tests right and wrong results, worked by hand.
#include "measure/host/host_rules.hpp"

#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using oracle::DivideRule;
using oracle::Rounding;

measure::HostCase case_of(double a, double b, double result) { return {{a, b}, result}; }

measure::HostCase values(double a, double b, double result) {
  return case_of(a * 65536, b * 65536, result * 65536);
}

constexpr auto right = measure::HostJudgement::right;
constexpr auto wrong = measure::HostJudgement::wrong;

// 1 and -1 units * 8000h units are half a unit and minus half a unit.
TEST(HostRules, TiesOfProducts) {
  constexpr double half = 0x8000;
  EXPECT_EQ(measure::product_rounded<Rounding::half_up>(case_of(1, half, 1)), right);
  EXPECT_EQ(measure::product_rounded<Rounding::half_up>(case_of(-1, half, 0)), right);
  EXPECT_EQ(measure::product_rounded<Rounding::half_up>(case_of(-1, half, -1)), wrong);
  EXPECT_EQ(measure::product_rounded<Rounding::half_away>(case_of(-1, half, -1)), right);
  EXPECT_EQ(measure::product_rounded<Rounding::half_away>(case_of(-1, half, 0)), wrong);
  EXPECT_EQ(measure::product_rounded<Rounding::floor>(case_of(1, half, 0)), right);
  EXPECT_EQ(measure::product_rounded<Rounding::floor>(case_of(-1, half, -1)), right);
  EXPECT_EQ(measure::product_rounded<Rounding::truncate>(case_of(-1, half, 0)), right);
  EXPECT_EQ(measure::product_rounded<Rounding::truncate>(case_of(-1, half, -1)), wrong);
}

// A value with more than 32 bits, or with a fraction of a unit, is not a word.
TEST(HostRules, AResultOfTheTypeIsAWord) {
  EXPECT_EQ(measure::product_rounded<Rounding::half_up>(values(2, 3, 6)), right);
  EXPECT_EQ(
      measure::product_rounded<Rounding::half_up>(case_of(0x20000, 0x30000, 0x60000 + 0x1p32)),
      wrong);
  EXPECT_EQ(measure::product_rounded<Rounding::half_up>(case_of(0x20000, 0x30000, 0x60000 + 0.25)),
            wrong);
}

// 3 units / 2.0 is 1 1/2 units. 7.0 / 2.75 is 3.5 if the divisor loses its fraction.
TEST(HostRules, Quotients) {
  EXPECT_EQ(measure::quotient_rounded<Rounding::half_up>(case_of(-3, 0x20000, -1)), right);
  EXPECT_EQ(measure::quotient_rounded<Rounding::half_up>(case_of(-3, 0x20000, -2)), wrong);
  EXPECT_EQ(measure::quotient_rounded<Rounding::half_away>(case_of(-3, 0x20000, -2)), right);
  EXPECT_EQ(measure::quotient_rounded<Rounding::half_up>(case_of(1, 0, 0)), wrong);
  EXPECT_EQ(measure::quotient_of_fixed_asm<DivideRule::i8088_rounded>(values(7, 2.75, 3.5)), right);
  EXPECT_EQ(measure::quotient_of_fixed_asm<DivideRule::i386_rounded>(values(7, 2.75, 3.5)), wrong);
  EXPECT_EQ(measure::quotient_of_fixed_asm<DivideRule::i8088_rounded>(values(7, 0.75, 7)), wrong);
}

// The square root of 2 is 92681.9 units; cos 60 degrees is 1/2.
TEST(HostRules, RootsAndCosines) {
  EXPECT_EQ(measure::root_rounded(case_of(0x20000, 0, 92682)), right);
  EXPECT_EQ(measure::root_rounded(case_of(0x20000, 0, 92681)), wrong);
  EXPECT_EQ(measure::root_rounded(case_of(-1, 0, 0)), wrong);
  EXPECT_EQ(measure::cosine_rounded(case_of(600, 0, 0x8000)), right);
  EXPECT_EQ(measure::cosine_rounded(case_of(600, 0, 0x8001)), wrong);
}

// 15 and its neighbours in float and double; thirds; the square root of 2.
TEST(HostRules, FloatingPointIsRoundedOnce) {
  EXPECT_EQ(measure::product_in<float>(values(3, 5, 15)), right);
  EXPECT_EQ(measure::product_in<float>(values(3, 5, 15 + 0x1p-20)), wrong);
  EXPECT_EQ(measure::product_in<double>(values(3, 5, 15)), right);
  EXPECT_EQ(measure::product_in<double>(values(3, 5, 15 + 0x1p-49)), wrong);
  EXPECT_EQ(measure::quotient_in<float>(values(1, 3, 0x1.555556p-2)), right);
  EXPECT_EQ(measure::quotient_in<float>(values(1, 3, 0x1.555554p-2)), wrong);
  EXPECT_EQ(measure::quotient_in<double>(values(1, 3, 0x1.5555555555555p-2)), right);
  EXPECT_EQ(measure::quotient_in<double>(values(1, 3, 0x1.5555555555556p-2)), wrong);
  EXPECT_EQ(measure::root_in<float>(values(2, 0, 0x1.6a09e6p0)), right);
  EXPECT_EQ(measure::root_in<float>(values(2, 0, 0x1.6a09e8p0)), wrong);
  EXPECT_EQ(measure::root_in<double>(values(2, 0, 0x1.6a09e667f3bcdp0)), right);
  EXPECT_EQ(measure::root_in<double>(values(2, 0, 0x1.6a09e667f3bccp0)), wrong);
  EXPECT_EQ(measure::root_in<double>(values(4, 0, -2)), wrong);
}

TEST(HostRules, ACosineInFloatingPointIsNearlyRight) {
  const double exact = 0.5 * 65536;
  EXPECT_EQ(measure::cosine_in<double>(case_of(600, 0, exact)), right);
  EXPECT_EQ(measure::cosine_in<double>(case_of(600, 0, exact * (1 + 1e-12))), wrong);
  EXPECT_EQ(measure::cosine_in<float>(case_of(600, 0, exact * (1 + 1e-7))), right);
  EXPECT_EQ(measure::cosine_in<float>(case_of(600, 0, exact * (1 + 1e-5))), wrong);
}

// Three products of half a unit each, plus a translation of 10: the rules give different sums.
TEST(HostRules, CoordinatesRoundEveryProduct) {
  measure::HostCase c{{1, 1, 1, 10, 0x8000, 0x8000, 0x8000}, 13};
  EXPECT_EQ(measure::coordinate_rounded<Rounding::half_up>(c), right);
  EXPECT_EQ(measure::coordinate_rounded<Rounding::floor>(c), wrong);
  c.result = 10;
  EXPECT_EQ(measure::coordinate_rounded<Rounding::floor>(c), right);
  c.result = 11.5;
  EXPECT_EQ(measure::coordinate_in<double>(c), right);
  EXPECT_EQ(measure::coordinate_in<float>(c), right);
  c.result = 11.5 * (1 + 1e-5);
  EXPECT_EQ(measure::coordinate_in<float>(c), wrong);
  c.result = 11.5 * (1 + 1e-14);
  EXPECT_EQ(measure::coordinate_in<double>(c), wrong);
}

}  // namespace

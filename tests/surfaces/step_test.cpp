// The three roundings of a step, by hand, and a divide that looks at a part of its divisor.
#include "xsharp/raster/step.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace {

using namespace xsharp;
using fixed::q16_16;
using fixed::q16_16_i386;
using fixed::q16_16_i386_unrounded;
using fixed::q16_16_i8088;
using fixed::q16_16_trapping;

template <class N>
N of(double value) {
  return Arithmetic<N>::constant(value, Conversion::nearest);
}

constexpr std::int64_t pixel = 65536;

TEST(Step, TheSlopeIsRoundedAsTheDivideIs) {
  // 2/3 of 65536 units is 43690.67.
  EXPECT_EQ((slope(of<q16_16_i386>(1), of<q16_16_i386>(3), 3 * pixel).raw()), 43691);
  EXPECT_EQ((slope(of<q16_16_i386_unrounded>(1), of<q16_16_i386_unrounded>(3), 3 * pixel).raw()),
            43690);
  EXPECT_EQ((slope(of<q16_16_i386>(3), of<q16_16_i386>(1), 3 * pixel).raw()), -43691);
  EXPECT_DOUBLE_EQ((slope(1.0, 3.0, 3 * pixel)), 2.0 / 3);
}

TEST(Step, TheStartIsTheValueAtTheCentre) {
  // A quarter of a pixel along a slope of 2.
  const auto step = step_across(of<q16_16_i386>(10), of<q16_16_i386>(18), 4 * pixel, pixel / 4);
  EXPECT_EQ(step.start.raw(), 10 * 65536 + 32768);
  EXPECT_EQ(step.slope.raw(), 2 * 65536);
}

TEST(Step, AWayBelowAPixelHasOneValueBetweenItsEnds) {
  const auto step = step_across(of<q16_16_trapping>(0), of<q16_16_trapping>(30000), 4, 1);
  EXPECT_EQ(step.start.raw(), 7500 * 65536);
  EXPECT_EQ(step.slope.raw(), 0);
}

TEST(Step, AWayThatIsLongerThan16_16IsHalved) {
  // From -32000 to 32000: 64000 pixels, 128 higher.
  EXPECT_EQ((slope(of<q16_16>(0), of<q16_16>(128), 64000 * pixel).raw()), 131);  // 131.07
}

TEST(Step, WordsAreTheNearest) {
  EXPECT_EQ(word_of(0x7F, 8), 0U);
  EXPECT_EQ(word_of(0x80, 8), 1U);
  EXPECT_EQ(word_of(-0x80, 8), 0U);
  EXPECT_EQ(word_of(-0x81, 8), 0xFFFFFFFFU);
  EXPECT_EQ(word_of(INT32_MAX, 8), 0x800000U);
  EXPECT_EQ(word_of(INT32_MIN, 0), 0x80000000U);
}

TEST(Step, NoQuotientIsZero) {
  EXPECT_EQ(ratio(of<q16_16_i386>(1), of<q16_16_i386>(0)).raw(), 0);
  EXPECT_EQ(ratio(1.0, 0.0), 0);
}

// The divide of the 8088 drops the divisor's fraction: of 3.75 it sees 3, which would be 25 %.
TEST(Step, TheDivideOfThe8088SeesNearlyAllOfTheDivisor) {
  const double exact = 60 / 3.75;
  const auto by = slope(of<q16_16_i8088>(0), of<q16_16_i8088>(60), 15 * pixel / 4);
  EXPECT_NEAR(by.raw() / 65536.0, exact, exact / 256);
}

RC_GTEST_PROP(Step, DoublingChangesNoOtherQuotient, (std::int32_t n, std::int32_t d)) {
  RC_PRE(d != 0);
  const auto a = q16_16_i386::from_raw(n % (1 << 28));
  const auto b = q16_16_i386::from_raw(d);
  const auto quotient = fixed::try_divide(a, b);
  RC_PRE(quotient.has_value());
  RC_ASSERT(ratio(a, b) == *quotient);
}

}  // namespace

// Tests the three roundings of a step, by hand, and the divide that drops part of its divisor.
#include "xsharp/raster/step.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "tests/support/test.hpp"
#include "tests/xsharp/raster/generators.hpp"

namespace {

using namespace xsharp;
using fixproof::q16_16;
using fixproof::q16_16_i386;
using fixproof::q16_16_i386_unrounded;
using fixproof::q16_16_i8088;
using fixproof::q16_16_trapping;

template <class N>
N of(double value) {
  return Arithmetic<N>::constant(value, Conversion::nearest);
}

constexpr std::int64_t pixel = 65536;

TEST(SpanStep, TheSlopeIsRoundedAsTheDivideIs) {
  // 2/3 of 65536 units is 43690.67.
  EXPECT_EQ((slope(of<q16_16_i386>(1), of<q16_16_i386>(3), 3 * pixel).raw()), 43691);
  EXPECT_EQ((slope(of<q16_16_i386_unrounded>(1), of<q16_16_i386_unrounded>(3), 3 * pixel).raw()),
            43690);
  EXPECT_EQ((slope(of<q16_16_i386>(3), of<q16_16_i386>(1), 3 * pixel).raw()), -43691);
  EXPECT_DOUBLE_EQ((slope(1.0, 3.0, 3 * pixel)), 2.0 / 3);
}

TEST(SpanStep, TheStartIsTheValueAtTheCentre) {
  // The first centre is a quarter of a pixel along a slope of 2.
  const auto step = step_across(of<q16_16_i386>(10), of<q16_16_i386>(18), 4 * pixel, pixel / 4);
  EXPECT_EQ(step.start.raw(), 10 * 65536 + 32768);
  EXPECT_EQ(step.slope.raw(), 2 * 65536);
}

TEST(SpanStep, AWayBelowAPixelHasOneValueBetweenItsEnds) {
  const auto step = step_across(of<q16_16_trapping>(0), of<q16_16_trapping>(30000), 4, 1);
  EXPECT_EQ(step.start.raw(), 7500 * 65536);
  EXPECT_EQ(step.slope.raw(), 0);
}

TEST(SpanStep, AWayThatIsLongerThan16_16IsHalved) {
  // The row runs from -32000 to 32000, 64000 pixels, and the value rises by 128.
  EXPECT_EQ((slope(of<q16_16>(0), of<q16_16>(128), 64000 * pixel).raw()), 131);  // 131.07
}

TEST(SpanStep, WordsAreTheNearest) {
  EXPECT_EQ(word_of(0x7F, 8), 0U);
  EXPECT_EQ(word_of(0x80, 8), 1U);
  EXPECT_EQ(word_of(-0x80, 8), 0U);
  EXPECT_EQ(word_of(-0x81, 8), 0xFFFFFFFFU);
  EXPECT_EQ(word_of(INT32_MAX, 8), 0x800000U);
  EXPECT_EQ(word_of(INT32_MIN, 0), 0x80000000U);
}

TEST(SpanStep, NoQuotientIsZero) {
  EXPECT_EQ(ratio(of<q16_16_i386>(1), of<q16_16_i386>(0)).raw(), 0);
  EXPECT_EQ(ratio(1.0, 0.0), 0);
}

// The 8088 divide drops the divisor's fraction. It would take 3.75 as 3, an error of 25 %.
TEST(SpanStep, TheDivideOfThe8088SeesNearlyAllOfTheDivisor) {
  const double exact = 60 / 3.75;
  const auto by = slope(of<q16_16_i8088>(0), of<q16_16_i8088>(60), 15 * pixel / 4);
  EXPECT_NEAR(by.raw() / 65536.0, exact, exact / 256);
}

/// For a slope below 1 the divisor is at least 8191, so the lost fraction costs less than 1. For a
/// steeper slope the upper part leaves at most D / 8191 and half a unit for each of 2^14 pixels,
/// below 4.2. Dividing that by at least 2^11 times the number of pixels loses less than 1, and the
/// product and the quotient round.
RC_GTEST_PROP(SpanStep, TheDivideOfThe8088SeesItUnderLargeDifferencesToo, ()) {
  const std::int64_t units = *generators::among(65536, 321 * 65536);
  const bool steep = *generators::among(0, 2) == 0;
  const std::int32_t size = steep ? *generators::among(static_cast<std::int32_t>(units), INT32_MAX)
                                  : *generators::among(0, static_cast<std::int32_t>(units));
  const std::int32_t to = *generators::among(0, 2) == 0 ? size : -size;
  const auto from = q16_16_i8088::from_raw(0);
  const auto end = q16_16_i8088::from_raw(to);
  const double pixels = static_cast<double>(units) / 65536;
  const double exact = to / pixels;
  const double bound = steep ? 1 + 4.2 * 65536 / 2048 / pixels : 0.5 + std::fabs(exact) / 8191;
  RC_ASSERT(std::fabs(slope(from, end, units).raw() - exact) <= bound);
}

TEST(SpanStep, TheDivideOfThe8088IsRightForWholeLengths) {
  // 32767 / 3 is 10922 1/3, and 65536 / 3 is 21845.3.
  EXPECT_EQ(slope(of<q16_16_i8088>(0), of<q16_16_i8088>(32767), 3 * pixel).raw(),
            10922 * 65536 + 21845);
  EXPECT_EQ(slope(of<q16_16_i8088>(32767), of<q16_16_i8088>(0), pixel).raw(), -32767 * 65536);
  EXPECT_EQ(slope(of<q16_16_i8088>(0), q16_16_i8088::from_raw(INT32_MAX), pixel).raw(), INT32_MAX);
  EXPECT_EQ(ratio(of<q16_16_i8088>(32767), of<q16_16_i8088>(0.5)).raw(), 0);
}

// For 265.2 pixels a single divide by 8486 instead of 8486.4 would give a slope 3 units too great.
TEST(SpanStep, TheDivideOfThe8088SeesAllOfADivisorThatIsTheDividend) {
  const std::int32_t way = 17'380'078;
  EXPECT_NEAR(slope(of<q16_16_i8088>(0), q16_16_i8088::from_raw(way), way).raw(), 65536, 1);
}

RC_GTEST_PROP(SpanStep, DoublingChangesNoOtherQuotient, (std::int32_t n, std::int32_t d)) {
  RC_PRE(d != 0);
  const auto a = q16_16_i386::from_raw(n % (1 << 28));
  const auto b = q16_16_i386::from_raw(d);
  const auto quotient = fixproof::try_divide(a, b);
  RC_PRE(quotient.has_value());
  RC_ASSERT(ratio(a, b) == *quotient);
}

}  // namespace

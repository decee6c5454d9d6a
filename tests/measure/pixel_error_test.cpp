// Tests the error on the page that the 8088 divide causes by dropping the divisor's fraction.
#include "measure/accuracy/pixel_error.hpp"

#include "fixed/fixed.hpp"
#include "tests/measure/never.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;

const measure::PixelErrors& named(const std::vector<measure::PixelErrors>& all,
                                  std::string_view name) {
  for (const measure::PixelErrors& e : all) {
    if (e.name == name) return e;
  }
  throw std::invalid_argument("no such preset");
}

/// The error in pixels, away from the middle, of x at distance z, both in units.
template <class N>
double pixels_too_far_out(std::int32_t x, std::int32_t z) {
  const N drawn = N::from_raw(x) / N::from_raw(z) * N(320);
  return static_cast<double>(drawn) - 320.0 * x / z;
}

// The 8088 divides a point at the edge of the page, 160 pixels out, at a distance just below k + 1,
// by k. It draws the point at most 160 / k pixels too far out. Rounding the quotient adds up to
// half a unit, 160 units of the page or 0.00244 pixels: 160 / 322 + 0.00244 = 0.4993, but 160 / 321
// + 0.00244 = 0.5009. Truncation adds nothing, so k = 320 stays below half a pixel.
TEST(PixelError, HalfAPixelAtTheDistanceOfThePage) {
  const auto all = measure::measure_pixel_errors({}, 1, 100, never);
  EXPECT_EQ(named(all, "q16_16_i8088").safe_from, 322);
  EXPECT_EQ(named(all, "q16_16_i8088_unrounded").safe_from, 320);
}

// 10518240 units / 320 is 32869.5, rounded to 32870; times 320 that is 160.49805 pixels. The
// correct result is 10518240 / 21037055 * 320 = 159.99563.
TEST(PixelError, HalfAPixelJustBelow321) {
  constexpr std::int32_t z = 0x0140FFFF;
  EXPECT_NEAR(pixels_too_far_out<fixproof::q16_16_i8088>(0x00A07EE0, z), 0.50242, 1e-5);
}

// 10551110 units / 321 is 32869.502, also rounded to 32870. The correct result is 159.99719. The
// point is 185 units from the edge, where 10551295 / 321 = 32870.08 rounds down.
TEST(PixelError, HalfAPixelJustBelow322) {
  constexpr std::int32_t z = 0x0141FFFF;
  EXPECT_NEAR(pixels_too_far_out<fixproof::q16_16_i8088>(0x00A0FF46, z), 0.50086, 1e-5);
}

// 10485530 units / 319 is exactly 32870. The correct result is 159.99650.
TEST(PixelError, HalfAPixelJustBelow320Unrounded) {
  constexpr std::int32_t z = 0x013FFFFF;
  EXPECT_NEAR(pixels_too_far_out<fixproof::q16_16_i8088_unrounded>(0x009FFF1A, z), 0.50155, 1e-5);
}

// With twice the constant, half a unit of the quotient is 0.00488 pixels: 160 / 324 + 0.0049 =
// 0.4987. Just below 324 the edge is at 5308415 units. 71 units nearer the middle, 5308344 / 323 is
// 16434.502, rounded to 16435: 16435 * 640 / 65536 = 160.49805. The correct result is 159.99786.
TEST(PixelError, SafeDistanceOfAnotherPage) {
  const auto all =
      measure::measure_pixel_errors({.constant = -640, .half_width = 160}, 1, 100, never);
  EXPECT_EQ(named(all, "q16_16_i8088").safe_from, 324);
}

// From z = -1 on, 160 / k is at most 160, and the error comes close to that.
TEST(PixelError, LargestAtTheNearPlane) {
  const auto all = measure::measure_pixel_errors({}, 1, 2000, never);
  const auto& octaves = named(all, "q16_16_i8088").octaves;
  ASSERT_EQ(octaves.size(), 15U);
  EXPECT_EQ(octaves.front().nearest, 1);
  EXPECT_GT(octaves.front().max, 100);
  EXPECT_LT(octaves.front().max, 160.01);
  EXPECT_EQ(octaves.back().nearest, 16384);
  EXPECT_LT(octaves.back().max, 160.0 / 16384 + 0.003);
  for (std::size_t i = 0; i < octaves.size(); ++i) {
    EXPECT_LT(octaves[i].max, 160.0 / octaves[i].nearest + 0.003) << i;
    EXPECT_LE(octaves[i].mean, octaves[i].max);
  }
}

// With the whole divisor, the quotient is off by at most half a unit: 160 units in the product,
// plus half a unit for the product's rounding. Truncation doubles both.
TEST(PixelError, AFullDivideIsNowhereNearHalfAPixel) {
  const auto all = measure::measure_pixel_errors({}, 1, 2000, never);
  for (const measure::DistanceOctave& o : named(all, "q16_16_i386").octaves) {
    EXPECT_LE(o.max, 160.5 / 65536);
    EXPECT_EQ(o.half, 0);
  }
  for (const measure::DistanceOctave& o : named(all, "q16_16_i386_unrounded").octaves) {
    EXPECT_LE(o.max, 321.0 / 65536);
  }
  EXPECT_EQ(named(all, "q16_16_i386").safe_from, 1);
}

}  // namespace

// The error of the 8088's divide on the page, from what it leaves out of the divisor.
#include "measure/accuracy/pixel_error.hpp"

#include <gtest/gtest.h>

#include "fixed/fixed.hpp"
#include "tests/measure/never.hpp"

namespace {

using namespace fixproof;

const measure::PixelErrors& named(const std::vector<measure::PixelErrors>& all,
                                  std::string_view name) {
  for (const measure::PixelErrors& e : all) {
    if (e.name == name) return e;
  }
  throw std::invalid_argument("no such preset");
}

/// How many pixels too far out x at distance z is drawn, both in units: by the type, and in double.
template <class N>
double pixels_too_far_out(std::int32_t x, std::int32_t z) {
  const N drawn = N::from_raw(x) / N::from_raw(z) * N(320);
  return static_cast<double>(drawn) - 320.0 * x / z;
}

// A point at the edge of the page, 160 pixels out, at a distance of almost k + 1 is divided by k:
// it is drawn 160 / k pixels too far out at most. Half a unit of the quotient, rounded, adds 160
// units of the page, 0.00244 pixels: 160 / 322 + 0.00244 = 0.4993, but 160 / 321 + 0.00244 =
// 0.5009. Cutting adds nothing, and k = 320 makes less than half a pixel.
TEST(PixelError, HalfAPixelAtTheDistanceOfThePage) {
  const auto all = measure::measure_pixel_errors({}, 1, 100, never);
  EXPECT_EQ(named(all, "q16_16_i8088").safe_from, 322);
  EXPECT_EQ(named(all, "q16_16_i8088_unrounded").safe_from, 320);
}

// 10518240 units by 320 are 32869.5, drawn as 32870: times 320 160.49805 pixels. It belongs at
// 10518240 / 21037055 * 320 = 159.99563.
TEST(PixelError, HalfAPixelJustBelow321) {
  constexpr std::int32_t z = 0x0140FFFF;
  EXPECT_NEAR(pixels_too_far_out<fixed::q16_16_i8088>(0x00A07EE0, z), 0.50242, 1e-5);
}

// 10551110 units by 321 are 32869.502, drawn as 32870 too. It belongs at 159.99719. It is 185 units
// from the edge, where 10551295 by 321 is 32870.08, rounded down.
TEST(PixelError, HalfAPixelJustBelow322) {
  constexpr std::int32_t z = 0x0141FFFF;
  EXPECT_NEAR(pixels_too_far_out<fixed::q16_16_i8088>(0x00A0FF46, z), 0.50086, 1e-5);
}

// 10485530 units by 319 are 32870, with nothing to cut. It belongs at 159.99650.
TEST(PixelError, HalfAPixelJustBelow320Unrounded) {
  constexpr std::int32_t z = 0x013FFFFF;
  EXPECT_NEAR(pixels_too_far_out<fixed::q16_16_i8088_unrounded>(0x009FFF1A, z), 0.50155, 1e-5);
}

// With a constant twice as large half a unit of the quotient is 0.00488 pixels. 160 / 324 + 0.0049
// = 0.4987. At almost 324 the edge is at 5308415 units; 71 nearer the middle 5308344 by 323 is
// 16434.502, drawn as 16435 * 640 / 65536 = 160.49805. It belongs at 159.99786.
TEST(PixelError, SafeDistanceOfAnotherPage) {
  const auto all =
      measure::measure_pixel_errors({.constant = -640, .half_width = 160}, 1, 100, never);
  EXPECT_EQ(named(all, "q16_16_i8088").safe_from, 324);
}

// From z = -1 on, 160 / k is 160 at most, and comes near that.
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

// A whole divisor leaves the quotient half a unit off: 160 units of the last place in the product,
// and half a unit of its own. Truncation is twice that.
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

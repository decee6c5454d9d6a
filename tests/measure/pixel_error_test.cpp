// The error of the 8088's divide on the page, from what it leaves out of the divisor.
#include "verify/measure/pixel_error.hpp"

#include <gtest/gtest.h>

#include "tests/measure/never.hpp"

namespace {

using namespace fixproof;

const PixelErrors& named(const std::vector<PixelErrors>& all, std::string_view name) {
  for (const PixelErrors& e : all) {
    if (e.name == name) return e;
  }
  throw std::invalid_argument("no such preset");
}

// A point at the edge of the page, 160 pixels out, at a distance of almost k + 1 is divided by k:
// it is drawn 160 / k pixels too far out. That is half a pixel at k = 320; rounding, 320 units of
// the quotient's last place, may add 0.003 pixels, and moves the limit by 2 at most.
TEST(PixelError, HalfAPixelAtTheDistanceOfThePage) {
  const auto all = measure_pixel_errors({}, 1, 100, never);
  EXPECT_NEAR(named(all, "q16_16_i8088").safe_from, 320, 3);
  EXPECT_NEAR(named(all, "q16_16_i8088_unrounded").safe_from, 320, 3);
}

// From z = -1 on, 160 / k is 160 at most, and comes near that.
TEST(PixelError, LargestAtTheNearPlane) {
  const auto all = measure_pixel_errors({}, 1, 2000, never);
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
  const auto all = measure_pixel_errors({}, 1, 2000, never);
  for (const DistanceOctave& o : named(all, "q16_16_i386").octaves) {
    EXPECT_LE(o.max, 160.5 / 65536);
    EXPECT_EQ(o.half, 0);
  }
  for (const DistanceOctave& o : named(all, "q16_16_i386_unrounded").octaves) {
    EXPECT_LE(o.max, 321.0 / 65536);
  }
  EXPECT_EQ(named(all, "q16_16_i386").safe_from, 1);
}

}  // namespace

// What a loop is called with, against the exact value at every pixel of a span.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "tests/surfaces/strip.hpp"
#include "tests/xsharp/raster/generators.hpp"

namespace surfaces {
namespace {

using namespace xsharp;

/// A slope is off by half a unit of the divide and half of the word's last bit, the start by half
/// of the latter; after i additions i slopes are.
double bound_at(std::size_t i, double last_bit) {
  const double slope = ulp / 2 + (last_bit > ulp ? last_bit / 2 : 0);
  return static_cast<double>(i) * slope + (last_bit > ulp ? last_bit / 2 : 0);
}

void check_kind(SurfaceKind kind, double last_bit, double highest, std::uint32_t modulus_bits) {
  const std::int32_t width = *generators::among(1, 321);
  const double from =
      std::floor(*generators::among(0, 1 << 24) * (highest / (1 << 24)) / ulp) * ulp;
  const double to = std::floor(*generators::among(0, 1 << 24) * (highest / (1 << 24)) / ulp) * ulp;
  const bool depth = kind == SurfaceKind::flat;
  Surface surface;
  surface.kind = kind;
  const auto calls =
      calls_of<Number>(scene_of(surface, depth ? DepthBuffering::on : DepthBuffering::off),
                       strip(width, {depth ? from : 0, from}, {depth ? to : 0, to}), width);
  RC_ASSERT(calls.size() == 1U);
  RC_ASSERT(calls[0].pixels == static_cast<std::size_t>(width));
  const std::uint64_t mask = (std::uint64_t{1} << modulus_bits) - 1;
  for (std::size_t i = 0; i < calls[0].pixels; ++i) {
    const double exact = from + (to - from) * static_cast<double>(i) / width;
    const auto word = (calls[0].one.start + i * calls[0].one.step) & mask;
    RC_ASSERT(std::fabs(static_cast<double>(word) * last_bit - exact) <=
              bound_at(i, last_bit) + 1e-9);
  }
}

TEST(SpanError, Gouraud8IsWithinAHalfBitAPixel) {
  EXPECT_TRUE(rc::check([] { check_kind(SurfaceKind::gouraud8, 1.0 / 256, 255, 16); }));
}
TEST(SpanError, Gouraud16IsWithinAHalfUnitAPixel) {
  EXPECT_TRUE(rc::check([] { check_kind(SurfaceKind::gouraud16, ulp, 255, 32); }));
}
TEST(SpanError, DepthIsWithinAHalfBitAPixel) {
  EXPECT_TRUE(rc::check([] { check_kind(SurfaceKind::flat, 1.0 / 256, 32767, 32); }));
}

// Longer rows begin anew: no error is greater than that of 320 pixels.
TEST(SpanError, RowsOfMoreThan320PixelsAreDrawnInPieces) {
  Surface surface;
  surface.kind = SurfaceKind::gouraud8;
  const auto calls = calls_of<Number>(scene_of(surface), strip(1000, {0, 1}, {0, 126}), 1000);
  ASSERT_EQ(calls.size(), 4U);
  std::size_t first = 0;
  for (const auto& call : calls) {
    EXPECT_LE(call.pixels, longest_span);
    const double exact = 1 + 125 * static_cast<double>(first) / 1000;
    // A slope of 16.16 over the pixels that are passed over, and the word's half bit.
    EXPECT_NEAR(call.one.start / 256.0, exact, static_cast<double>(first) * ulp / 2 + 1.0 / 512);
    first += call.pixels;
  }
  EXPECT_EQ(first, 1000U);
}

}  // namespace
}  // namespace surfaces

// Compares the arguments of the loops with the exact value at every pixel of a span.
#include <rapidcheck.h>

#include "tests/support/test.hpp"
#include "tests/xsharp/raster/generators.hpp"
#include "tests/xsharp/surfaces/polygon_row.hpp"
#include "tests/xsharp/surfaces/strip.hpp"

namespace surfaces {
namespace {

using namespace xsharp;

/// A slope is off by half a unit from the divide and half of the word's last bit. The start is off
/// by half of that bit. After i additions the slope's error counts i times.
double bound_at(std::size_t i, double last_bit) {
  const double slope = ulp / 2 + (last_bit > ulp ? last_bit / 2 : 0);
  return static_cast<double>(i) * slope + (last_bit > ulp ? last_bit / 2 : 0);
}

/// A stepped value and its word. Depth uses a flat surface.
struct Kind {
  SurfaceKind surface = SurfaceKind::flat;
  double last_bit = 0;
  double highest = 0;
  std::uint32_t word_bits = 32;

  [[nodiscard]] bool is_depth() const { return surface == SurfaceKind::flat; }
  [[nodiscard]] Scene scene() const {
    Surface of_kind;
    of_kind.kind = surface;
    return scene_of(of_kind, is_depth() ? DepthBuffering::on : DepthBuffering::off);
  }
  /// A value of the ramp's range, two levels away from either end so that no error wraps. It is an
  /// exact 16.16 number.
  [[nodiscard]] PointValues any_value() const {
    const double value = 2 + *generators::among(0, 1 << 24) * ((highest - 4) / (1 << 24));
    const double number = std::floor(value / ulp) * ulp;
    return {is_depth() ? number : 0, number};
  }
  /// The value whose whole part the loop draws.
  [[nodiscard]] double value_of(const StepWords& words, std::size_t i) const {
    const std::uint64_t mask = (std::uint64_t{1} << word_bits) - 1;
    return static_cast<double>((words.start + i * words.step) & mask) * last_bit;
  }
};
constexpr Kind gouraud8{SurfaceKind::gouraud8, 1.0 / 256, 255, 16};
constexpr Kind gouraud16{SurfaceKind::gouraud16, ulp, 255};
constexpr Kind depths{SurfaceKind::flat, 1.0 / 256, 32767};

void check_span(const Kind& kind) {
  const std::int32_t width = *generators::among(1, 321);
  const PointValues left = kind.any_value();
  const PointValues right = kind.any_value();
  const auto calls = calls_of<Number>(kind.scene(), strip(width, left, right), width);
  RC_ASSERT(calls.size() == 1U);
  RC_ASSERT(calls[0].pixels == static_cast<std::size_t>(width));
  for (std::size_t i = 0; i < calls[0].pixels; ++i) {
    const double exact = left[1] + (right[1] - left[1]) * static_cast<double>(i) / width;
    RC_ASSERT(std::fabs(kind.value_of(calls[0].one, i) - exact) <=
              bound_at(i, kind.last_bit) + 1e-9);
  }
}

TEST(SpanError, Gouraud8IsWithinAHalfBitAPixel) {
  EXPECT_TRUE(rc::check([] { check_span(gouraud8); }));
}
TEST(SpanError, Gouraud16IsWithinAHalfUnitAPixel) {
  EXPECT_TRUE(rc::check([] { check_span(gouraud16); }));
}
TEST(SpanError, DepthIsWithinAHalfBitAPixel) {
  EXPECT_TRUE(rc::check([] { check_span(depths); }));
}

/// A quadrilateral that begins above the page and may extend past its left and right sides. Each
/// corner has another value.
Picture around_the_page(const Kind& kind) {
  const auto left = [] { return *generators::among(-500, 100); };
  const auto right = [] { return *generators::among(120, 500); };
  const std::int32_t top = *generators::among(-300, 0);
  const std::int32_t bottom = *generators::among(1, 300);
  Picture picture = strip(1, {}, {});
  picture.points = {{left(), top}, {right(), top}, {right(), bottom}, {left(), bottom}};
  for (PointValues& value : picture.values) value = kind.any_value();
  return picture;
}

void check_clipped(const Kind& kind) {
  constexpr std::int32_t width = 320;
  constexpr std::int32_t height = 8;
  const Picture picture = around_the_page(kind);
  const auto calls = calls_of<Number>(kind.scene(), picture, width, height);
  std::int32_t y = 0;
  for (const auto& call : calls) {
    const auto row = row_of(picture, picture.polygons[0], y++);
    RC_ASSERT(row.has_value());
    const std::int32_t first = row->first();
    RC_ASSERT(call.pixels == static_cast<std::size_t>(row->end(width) - first));
    for (std::size_t i = 0; i < call.pixels; ++i) {
      const std::int32_t x = first + static_cast<std::int32_t>(i);
      RC_ASSERT(std::fabs(kind.value_of(call.one, i) - row->at(1, x)) <=
                stepping_error(*row, 1, x, kind.last_bit) + 1e-9);
    }
  }
  RC_ASSERT(y == std::min(height, picture.points[2].y));
}

// Kind gives a flat surface's depth as both the first and the second value.
TEST(SpanError, WhatBeginsOffThePageIsSteppedToItsSideAndItsTop) {
  EXPECT_TRUE(rc::check([] { check_clipped(gouraud8); }));
  EXPECT_TRUE(rc::check([] { check_clipped(gouraud16); }));
  EXPECT_TRUE(rc::check([] { check_clipped(depths); }));
}

// Long rows are drawn in pieces. A piece starts at the row's start plus one slope per earlier
// pixel. The slope's half unit counts for all these pixels, but the word's half bits only from the
// start of the piece.
TEST(SpanError, RowsOfMoreThan320PixelsAreDrawnInPieces) {
  const auto calls = calls_of<Number>(gouraud8.scene(), strip(1000, {0, 1}, {0, 126}), 1000);
  ASSERT_EQ(calls.size(), 4U);
  std::size_t from = 0;
  for (const auto& call : calls) {
    EXPECT_LE(call.pixels, longest_span);
    for (std::size_t i = 0; i < call.pixels; ++i) {
      const double exact = 1 + 125 * static_cast<double>(from + i) / 1000;
      const double bound = static_cast<double>(from + i) * ulp / 2 +
                           static_cast<double>(i + 1) * gouraud8.last_bit / 2;
      EXPECT_NEAR(gouraud8.value_of(call.one, i), exact, bound) << from << " + " << i;
    }
    from += call.pixels;
  }
  EXPECT_EQ(from, 1000U);
}

}  // namespace
}  // namespace surfaces

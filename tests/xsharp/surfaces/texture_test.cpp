// Compares the bitmap places of the texture loops with exact perspective.
#include <rapidcheck.h>

#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"
#include "tests/xsharp/raster/generators.hpp"
#include "tests/xsharp/surfaces/strip.hpp"
#include "xsharp/files/scene_json.hpp"

namespace surfaces {
namespace {

using namespace xsharp;

/// A span whose place is p / q, with p and q linear in screen x; q runs from `near` to `far`.
struct Span {
  std::int32_t width = 0;
  double near = 0;
  double far = 0;
  double from = 0;
  double to = 0;

  [[nodiscard]] double q(double x) const { return near + (far - near) * x / width; }
  [[nodiscard]] double place(double x) const {
    return (from * near + (to * far - from * near) * x / width) / q(x);
  }
  /// |u''| = 2 |W e| / q^3 for u = p / q with slopes b and e and the constant W = b q - p e.
  [[nodiscard]] double bend() const {
    const double e = (far - near) / width;
    const double b = (to * far - from * near) / width;
    return 2 * std::fabs((b * near - from * near * e) * e) / std::pow(std::min(near, far), 3);
  }
};

/// Keeps places a texel inside the bitmap, so that no clamping hides stepping errors.
Span any_span() {
  const auto part = [] { return *generators::among(0, 65536) / 65536.0; };
  const auto place = [] { return *generators::among(256, 65536 - 255) / 65536.0; };
  return {*generators::among(2, 321), std::floor(100 + 32000 * part()),
          std::floor(100 + 32000 * part()), place(), place()};
}

/// The same depths with other places, for the rows of the bitmap.
Span with_other_places(Span span) {
  const Span other = any_span();
  span.from = other.from;
  span.to = other.to;
  return span;
}

std::vector<RecordingLoops::Call> calls_of_span(const Span& span, const Span& down,
                                                std::int32_t every) {
  Surface surface;
  surface.kind = SurfaceKind::texture;
  surface.exact_every = every;
  return calls_of<Number>(
      scene_of(surface),
      strip(span.width, {span.near, span.from, down.from}, {span.far, span.to, down.to}),
      span.width);
}

/// Between exact places h apart, a line is off by h^2 / 8 times the bend. An exact place has the
/// errors of p and q: half a unit from the products at the corners, and a slope's error per pixel.
TEST(Texture, IsWithinABoundThatFollowsFromThePixelsBetweenExactPlaces) {
  EXPECT_TRUE(rc::check([] {
    const Span span = any_span();
    const Span down = with_other_places(span);
    for (const std::int32_t every : {1, 8, 16}) {
      const double stepped = (0.5 * span.width + 3) * ulp;
      const double exact = 2 * stepped / std::min(span.near, span.far) + ulp / 2;
      std::size_t x = 0;
      const auto check = [&](const StepWords& words, std::size_t i, const Span& places) {
        const double linear = every * every / 8.0 * places.bend();
        const double bound = linear + exact + (every + 1) * ulp / 2;
        const auto word = static_cast<std::int32_t>(words.start + i * words.step);
        const double off = word * ulp - places.place(static_cast<double>(x));
        RC_ASSERT(std::fabs(off) <= bound + 1e-12);
      };
      for (const auto& call : calls_of_span(span, down, every)) {
        for (std::size_t i = 0; i < call.pixels; ++i, ++x) {
          check(call.one, i, span);
          check(call.other, i, down);
        }
      }
      RC_ASSERT(x == static_cast<std::size_t>(span.width));
    }
  }));
}

// Linear distortion is a straight line from corner to corner.
TEST(Texture, WithoutExactPlacesIsLinear) {
  EXPECT_TRUE(rc::check([] {
    const Span span = any_span();
    const Span down = with_other_places(span);
    const auto calls = calls_of_span(span, down, 0);
    RC_ASSERT(calls.size() == 1U);
    const auto check = [&](const StepWords& words, std::size_t i, const Span& places) {
      const auto word = static_cast<std::int32_t>(words.start + i * words.step);
      const double x = static_cast<double>(i);
      const double line = places.from + (places.to - places.from) * x / places.width;
      RC_ASSERT(std::fabs(word * ulp - line) <= (0.5 * x + 1) * ulp);
    };
    for (std::size_t i = 0; i < calls[0].pixels; ++i) {
      check(calls[0].one, i, span);
      check(calls[0].other, i, down);
    }
  }));
}

template <class N>
void check_inside() {
  // Corners go from the centre of the first texel to that of the last, or back.
  const std::int32_t width = *generators::among(2, 4097);
  const bool back = *generators::among(0, 2) == 1;
  const double from = back ? 255.5 / 256 : 0.5 / 256;
  Surface surface;
  surface.kind = SurfaceKind::texture;
  surface.exact_every = *generators::among(0, 2) == 1 ? 16 : 0;
  for (const auto& call : calls_of<N>(
           scene_of(surface), strip(width, {20000, from, from}, {20000, 1 - from, from}), width)) {
    for (const std::size_t i : {std::size_t{0}, call.pixels - 1}) {
      for (const StepWords& words : {call.one, call.other}) {
        const auto place = static_cast<std::int32_t>(words.start + i * words.step);
        RC_ASSERT(place >= 0);
        RC_ASSERT(place <= 0xFFFF);
      }
    }
  }
}

TEST(Texture, NoRowOfAnyLengthLeavesTheBitmap) {
  EXPECT_TRUE(rc::check([] { check_inside<Number>(); }));
  EXPECT_TRUE(rc::check([] { check_inside<fixproof::q16_16_i386_unrounded>(); }));
  EXPECT_TRUE(rc::check([] { check_inside<fixproof::q16_16_i8088>(); }));
  EXPECT_TRUE(rc::check([] { check_inside<fixproof::q16_16_i8088_unrounded>(); }));
}

TEST(Texture, APlaceOutsideIsBroughtToTheEdgeOfTheBitmap) {
  EXPECT_EQ(inside_bitmap({100, 20}, 4), (StepWords{100, 20}));
  EXPECT_EQ(inside_bitmap({0xFFFFFFF0, 0xFFFFFFFF}, 3), (StepWords{0, 0}));
  EXPECT_EQ(inside_bitmap({65000, 200}, 4), (StepWords{65000, 178}));  // (65535 - 65000) / 3
  EXPECT_EQ(inside_bitmap({100, static_cast<std::uint32_t>(-60)}, 4),
            (StepWords{100, static_cast<std::uint32_t>(-33)}));
  EXPECT_EQ(inside_bitmap({70000, 5}, 1), (StepWords{65535, 5}));
}

/// The number of pixels that differ from the exact rendering in frame 40 of the textured scene.
std::ptrdiff_t differing(std::int32_t every) {
  Scene scene = read_scene(paths::scene("textured.json"));
  for (ObjectDescription& object : scene.objects) object.surface.exact_every = every;
  Animation<Number> animation(scene);
  for (int frame = 0; frame < 40; ++frame) animation.move();
  Picture picture;
  animation.draw(picture);
  StepFiller<Number> stepped(scene, std::make_unique<PlainLoops>());
  ExactFiller exact(scene);
  const Indices one = drawn(stepped, picture, scene.width, scene.height);
  const Indices other = drawn(exact, picture, scene.width, scene.height);
  std::ptrdiff_t count = 0;
  for (std::size_t i = 0; i < one.pixels().size(); ++i) {
    count += one.pixels()[i] == other.pixels()[i] ? 0 : 1;
  }
  return count;
}

TEST(Texture, TheFewerExactPlacesTheMorePixelsDiffer) {
  EXPECT_LE(differing(1), differing(8));
  EXPECT_LT(differing(8), differing(16));
  EXPECT_LT(differing(16), differing(0) / 4);
}

TEST(Texture, PatternsAreWhatTheySay) {
  Surface surface;
  surface.texels = {3, 9};
  const auto checker = bitmap_of(surface);
  ASSERT_EQ(checker.size(), bitmap_texels);
  EXPECT_EQ(checker[0], 3);
  EXPECT_EQ(checker[32], 9);
  EXPECT_EQ(checker[32 * 256], 9);
  EXPECT_EQ(checker[33 * 256 + 63], 3);
  surface.pattern = Pattern::bricks;
  const auto bricks = bitmap_of(surface);
  EXPECT_EQ(bricks[3 * 256 + 20], 9);   // the joint above a row
  EXPECT_EQ(bricks[10 * 256 + 3], 9);   // the joint before a brick
  EXPECT_EQ(bricks[10 * 256 + 20], 3);  // a brick
  EXPECT_EQ(bricks[40 * 256 + 3], 3);   // the next row is shifted by half a brick
  EXPECT_EQ(bricks[40 * 256 + 35], 9);
}

}  // namespace
}  // namespace surfaces

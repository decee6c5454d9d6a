// Where in a bitmap the texture loops go, against the true perspective.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "tests/surfaces/strip.hpp"
#include "tests/xsharp/raster/generators.hpp"
#include "xsharp/files/scene_json.hpp"

namespace surfaces {
namespace {

using namespace xsharp;

/// A span: places p / q where p and q are linear on the screen, q from `near` to `far`.
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
  /// |u''| = 2 |W e| / q^3, for u = p / q with slopes b and e and the constant W = b q - p e.
  [[nodiscard]] double bend() const {
    const double e = (far - near) / width;
    const double b = (to * far - from * near) / width;
    return 2 * std::fabs((b * near - from * near * e) * e) / std::pow(std::min(near, far), 3);
  }
};

Span any_span() {
  const auto part = [] { return *generators::among(0, 65536) / 65536.0; };
  return {*generators::among(2, 321), std::floor(100 + 32000 * part()),
          std::floor(100 + 32000 * part()), part(), part()};
}

std::vector<RecordingLoops::Call> calls_of_span(const Span& span, std::int32_t every) {
  Surface surface;
  surface.kind = SurfaceKind::texture;
  surface.exact_every = every;
  return calls_of<Number>(scene_of(surface),
                          strip(span.width, {span.near, span.from, 0}, {span.far, span.to, 0}),
                          span.width);
}

/// Between exact places h apart a line errs by h^2 / 8 times the bend. An exact place errs by what
/// p and q do, each a product's half unit at the corners, and a slope's for every pixel.
TEST(Texture, IsWithinABoundThatFollowsFromThePixelsBetweenExactPlaces) {
  EXPECT_TRUE(rc::check([] {
    const Span span = any_span();
    for (const std::int32_t every : {1, 8, 16}) {
      const double linear = every * every / 8.0 * span.bend();
      const double stepped = (0.5 * span.width + 3) * ulp;
      const double exact = 2 * stepped / std::min(span.near, span.far) + ulp / 2;
      const double bound = linear + exact + (every + 1) * ulp / 2;
      std::size_t x = 0;
      for (const auto& call : calls_of_span(span, every)) {
        for (std::size_t i = 0; i < call.pixels; ++i, ++x) {
          const auto word = static_cast<std::int32_t>(call.one.start + i * call.one.step);
          const double off = word * ulp - span.place(static_cast<double>(x));
          RC_ASSERT(std::fabs(off) <= bound + 1e-12);
        }
      }
      RC_ASSERT(x == static_cast<std::size_t>(span.width));
    }
  }));
}

// Linear distortion goes straight from corner to corner.
TEST(Texture, WithoutExactPlacesIsLinear) {
  EXPECT_TRUE(rc::check([] {
    const Span span = any_span();
    const auto calls = calls_of_span(span, 0);
    RC_ASSERT(calls.size() == 1U);
    for (std::size_t i = 0; i < calls[0].pixels; ++i) {
      const auto word = static_cast<std::int32_t>(calls[0].one.start + i * calls[0].one.step);
      const double x = static_cast<double>(i);
      const double line = span.from + (span.to - span.from) * x / span.width;
      RC_ASSERT(std::fabs(word * ulp - line) <= (0.5 * x + 1) * ulp);
    }
  }));
}

/// Pixels of frame 40 of the textured scene that are not those of the exact rendering.
std::ptrdiff_t differing(std::int32_t every) {
  Scene scene = read_scene(SCENES "/textured.json");
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
  EXPECT_EQ(bricks[10 * 256 + 3], 9);   // and before a brick
  EXPECT_EQ(bricks[10 * 256 + 20], 3);  // a brick
  EXPECT_EQ(bricks[40 * 256 + 3], 3);   // half a brick further in the next row
  EXPECT_EQ(bricks[40 * 256 + 35], 9);
}

}  // namespace
}  // namespace surfaces

// The depth buffer against depths in double, with and without clearing, and what order is worth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/surfaces/strip.hpp"
#include "xsharp/files/scene_json.hpp"

namespace surfaces {
namespace {

using namespace xsharp;

/// Polygon `i` is painted with index i + 1.
void number_polygons(Picture& picture) {
  ASSERT_LT(picture.polygons.size(), 255U);
  for (std::size_t i = 0; i < picture.polygons.size(); ++i) {
    picture.polygons[i].paint = {.is_index = true, .index = static_cast<std::uint8_t>(i + 1)};
  }
}

/// The exact depth of a polygon at a pixel; minus infinity where it is not.
double depth_of(const Scene& scene, const Picture& picture, std::size_t polygon, std::int32_t x,
                std::int32_t y) {
  Picture alone = picture;
  alone.polygons = {picture.polygons.at(polygon)};
  ExactFiller exact(scene);
  drawn(exact, alone, scene.width, scene.height);
  return exact.depth_at(x, y);
}

struct Difference {
  int pixels = 0;
  double most = 0;  ///< of the two depths, where another polygon is nearest
};

/// Of what is nearest at each pixel, by the buffer and in double.
Difference differences_of(DepthBuffering mode, int frames) {
  Scene scene = read_scene(SCENES "/intersecting.json");
  scene.depth_buffer = mode;
  Animation<Number> animation(scene);
  StepFiller<Number> stepped(scene, std::make_unique<PlainLoops>());
  ExactFiller exact(scene);
  Picture picture;
  Difference all;
  for (int frame = 0; frame < frames; ++frame) {
    if (frame > 0) animation.move();
    animation.draw(picture);
    number_polygons(picture);
    const Indices one = drawn(stepped, picture, scene.width, scene.height);
    const Indices other = drawn(exact, picture, scene.width, scene.height);
    for (std::int32_t y = 0; y < scene.height; ++y) {
      for (std::int32_t x = 0; x < scene.width; ++x) {
        const auto at = static_cast<std::size_t>(x);
        const std::size_t is = one.row(y)[at];
        const std::size_t should_be = other.row(y)[at];
        if (is == should_be) continue;
        EXPECT_TRUE(is > 0 && should_be > 0) << "a pixel without a polygon";
        if (is == 0 || should_be == 0) return all;
        ++all.pixels;
        all.most = std::max(all.most, depth_of(scene, picture, should_be - 1, x, y) -
                                          depth_of(scene, picture, is - 1, x, y));
        // Worse than any bound: the rest would take minutes.
        if (all.most > 100) return all;
      }
    }
  }
  return all;
}

/// Two depths are told apart by their whole parts, so they may be equal in the buffer where they
/// are less than 1 apart; a step errs by half of 2^-8 a pixel, over 320 pixels by 0.625, so two
/// stepped depths by 1.25; starts and edges add less than 0.1 each.
constexpr double unit_of_depth = 1 + 2 * (0.625 + 0.1);

TEST(DepthBuffer, DrawsTheIntersectingSolidsButForPixelsNearlyAtOneDepth) {
  const Difference is = differences_of(DepthBuffering::on, 300);
  EXPECT_GT(is.pixels, 0);
  EXPECT_LT(is.most, unit_of_depth);
}

TEST(DepthBuffer, DoesSoWithItsAxisReversed) {
  const Difference is = differences_of(DepthBuffering::reversed, 60);
  EXPECT_LT(is.most, unit_of_depth);
}

// A quarter of the depths: units four times as large.
TEST(DepthBuffer, DoesSoWithoutClearingWithTwoBitsLess) {
  const Difference is = differences_of(DepthBuffering::no_clear, 60);
  EXPECT_LT(is.most, 4 * unit_of_depth);
}

// What is farther than all that a pixel has ever had shows where the rest has gone: nothing of an
// earlier picture hides it.
TEST(DepthBuffer, WithoutClearingNothingOfEarlierPicturesHides) {
  const Scene scene = scene_of({}, DepthBuffering::no_clear);
  StepFiller<Number> filler(scene, std::make_unique<PlainLoops>());
  for (int picture = 0; picture < 40; ++picture) {
    const double depth = picture % 2 == 0 ? 32767 : 1;
    Picture next = strip(8, {depth}, {depth});
    next.polygons[0].paint.index = 7;
    // Half of the pictures leave half of the pixels alone.
    if (picture % 4 == 1) next.points[1].x = next.points[2].x = 4;
    const Indices page = drawn(filler, next, 8, 2);
    EXPECT_EQ(std::count(page.pixels().begin(), page.pixels().end(), 7), picture % 4 == 1 ? 8 : 16)
        << picture;
  }
}

// Drawn front to back, fewer pixels are written that others then cover.
TEST(DepthBuffer, IsDrawnFrontToBackForFewerPixels) {
  Scene scene = read_scene(SCENES "/ball_and_cubes.json");
  scene.depth_buffer = DepthBuffering::on;
  Animation<Number> animation(scene);
  // The ball is before or behind the cubes.
  for (int frame = 0; frame < 60; ++frame) animation.move();
  Picture picture;
  animation.draw(picture);
  const auto order = animation.order();
  for (std::size_t i = 1; i < order.size(); ++i) {
    EXPECT_GE(animation.state(order[i - 1]).xform[11], animation.state(order[i]).xform[11]);
  }
  StepFiller<Number> filler(scene, std::make_unique<PlainLoops>());
  const auto pixels = [&] {
    filler.begin(picture, scene.width, scene.height);
    Indices page(scene.width, scene.height);
    std::int64_t set = 0;
    for (const Polygon& polygon : picture.polygons) {
      set += filler.fill<std::uint8_t>(page, picture, polygon, polygon.paint.index);
    }
    return std::pair(set, page);
  };
  const auto [forward, one] = pixels();
  std::ranges::reverse(picture.polygons);
  const auto [backward, other] = pixels();
  EXPECT_LT(forward, backward);
  EXPECT_EQ(std::ranges::count(one.pixels(), 0), std::ranges::count(other.pixels(), 0));
}

}  // namespace
}  // namespace surfaces

// Tests the depth buffer against depths in double, with and without clearing, and drawing order.
#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"
#include "tests/xsharp/surfaces/polygon_row.hpp"
#include "tests/xsharp/surfaces/strip.hpp"
#include "xsharp/files/scene_json.hpp"

namespace surfaces {
namespace {

using namespace xsharp;

/// Paints polygon `i` with index i + 1.
void number_polygons(Picture& picture) {
  ASSERT_LT(picture.polygons.size(), 255U);
  for (std::size_t i = 0; i < picture.polygons.size(); ++i) {
    picture.polygons[i].paint = {.is_index = true, .index = static_cast<std::uint8_t>(i + 1)};
  }
}

/// The depth of a polygon at a pixel, and the bound on the buffer's error. Per pixel, the error is
/// half a unit of 2^-16 and half of the loops' last bit, which is 0.627 over 320 pixels in 16.8.
/// The row's edges and slope add to it (stepping_error()).
struct Depth {
  double exact = 0;
  double error = 0;
};

Depth depth_of(const Picture& picture, std::size_t polygon, std::int32_t x, std::int32_t y,
               double last_bit = 1.0 / 256) {
  const auto row = row_of(picture, picture.polygons.at(polygon), y);
  if (!row) return {};
  return {row->at(0, x), stepping_error(*row, 0, x, last_bit)};
}

struct Difference {
  int pixels = 0;
  /// The greatest depth difference between the nearest and the drawn polygon, as a fraction of the
  /// bound. The buffer compares whole parts, so depths less than 1 apart may compare equal, and
  /// each depth has its stepping error.
  double most = 0;
};

/// Compares the visible polygon at each pixel, by the buffer and in double.
Difference differences_of(DepthBuffering mode, int frames) {
  Scene scene = read_scene(paths::scene("intersecting.json"));
  scene.depth_buffer = mode;
  Animation<Number> animation(scene);
  StepFiller<Number> stepped(scene, std::make_unique<PlainLoops>());
  ExactFiller exact(scene);
  Picture picture;
  // Without clearing, depths have two bits less.
  const double unit = mode == DepthBuffering::no_clear ? 4 : 1;
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
        const Depth nearest = depth_of(picture, should_be - 1, x, y, unit / 256);
        const Depth drawn_there = depth_of(picture, is - 1, x, y, unit / 256);
        all.most = std::max(all.most, (nearest.exact - drawn_there.exact) /
                                          (unit + nearest.error + drawn_there.error));
      }
    }
  }
  return all;
}

TEST(DepthBuffer, DrawsTheIntersectingSolidsButForPixelsNearlyAtOneDepth) {
  const Difference is = differences_of(DepthBuffering::on, 300);
  EXPECT_GT(is.pixels, 0);
  EXPECT_LE(is.most, 1);
}

TEST(DepthBuffer, DoesSoWithItsAxisReversed) {
  EXPECT_LE(differences_of(DepthBuffering::reversed, 60).most, 1);
}

TEST(DepthBuffer, DoesSoWithoutClearingWithTwoBitsLess) {
  EXPECT_LE(differences_of(DepthBuffering::no_clear, 60).most, 1);
}

/// The number of pictures between two clearings.
constexpr int pictures = 7;

// The farthest depth makes remnants visible: neither an earlier picture nor the cleared value may
// hide it. Each of the seven pictures alternates between near and far.
TEST(DepthBuffer, WithoutClearingNothingOfEarlierPicturesHides) {
  const Scene scene = scene_of({}, DepthBuffering::no_clear);
  StepFiller<Number> filler(scene, std::make_unique<PlainLoops>());
  for (int picture = 0; picture < 6 * pictures; ++picture) {
    const double depth = (picture + picture / pictures) % 2 == 0 ? 1 : 32767;
    Picture next = strip(8, {depth}, {depth});
    next.polygons[0].paint.index = 7;
    // Every fourth picture leaves half of the pixels untouched.
    if (picture % 4 == 1) next.points[1].x = next.points[2].x = 4;
    const Indices page = drawn(filler, next, 8, 2);
    EXPECT_EQ(std::count(page.pixels().begin(), page.pixels().end(), 7), picture % 4 == 1 ? 8 : 16)
        << picture;
  }
}

// In words of four units by 2^-8, a slope of 0.0079 becomes 0.0156. After 320 pixels the depth is
// 2.5 units too high, above 32767, or too low, below 0. Neither error may hide a later picture or
// let an earlier one show.
TEST(DepthBuffer, WithoutClearingNorDoesWhatWasSteppedBeyondTheRange) {
  constexpr double rise = 320 * 0.0079;
  const Scene scene = scene_of({}, DepthBuffering::no_clear);
  StepFiller<Number> filler(scene, std::make_unique<PlainLoops>());
  for (int picture = 0; picture < 6 * pictures; ++picture) {
    const bool far = (picture + picture / pictures) % 2 == 0;
    Picture next = far ? strip(320, {rise}, {0}) : strip(320, {32767 - rise}, {32767});
    next.polygons[0].paint.index = 7;
    const Indices page = drawn(filler, next, 320, 2);
    EXPECT_EQ(std::count(page.pixels().begin(), page.pixels().end(), 7), 640) << picture;
  }
}

// Front-to-back drawing overwrites fewer pixels.
TEST(DepthBuffer, IsDrawnFrontToBackForFewerPixels) {
  Scene scene = read_scene(paths::scene("ball_and_cubes.json"));
  scene.depth_buffer = DepthBuffering::on;
  Animation<Number> animation(scene);
  // After 60 frames the ball overlaps the cubes.
  for (int frame = 0; frame < 60; ++frame) animation.move();
  Picture picture;
  animation.draw(picture);
  number_polygons(picture);
  const Picture nearest_first = picture;
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
  // When the buffer holds equal depths, the polygon drawn first wins.
  for (std::int32_t y = 0; y < scene.height; ++y) {
    for (std::int32_t x = 0; x < scene.width; ++x) {
      const std::size_t first = one.row(y)[static_cast<std::size_t>(x)];
      const std::size_t last = other.row(y)[static_cast<std::size_t>(x)];
      if (first == last) continue;
      ASSERT_TRUE(first > 0 && last > 0) << "a pixel without a polygon";
      const Depth one_depth = depth_of(nearest_first, first - 1, x, y);
      const Depth other_depth = depth_of(nearest_first, last - 1, x, y);
      ASSERT_LT(std::fabs(one_depth.exact - other_depth.exact),
                1 + one_depth.error + other_depth.error)
          << x << ", " << y;
    }
  }
}

}  // namespace
}  // namespace surfaces

/// Tests two-body scenes that a sort by one depth draws in the wrong order. Rays determine the
/// visible body at each pixel.
#include "tests/support/test.hpp"
#include "tests/xsharp/pipeline/stage.hpp"
#include "tests/xsharp/pipeline/types.hpp"
#include "xsharp/animation.hpp"

namespace xsharp {
namespace {

/// A box with axis-aligned faces at whole numbers, so the 8088 divide drops no fraction.
struct Box {
  Triple least;
  Triple most;
};

constexpr std::int32_t screen_side = 128;
constexpr double half = screen_side / 2;

/// Where the ray enters the box, in units of the screen's distance, or a huge value if it misses.
/// The box is the intersection of three slabs.
double entry(const Box& box, const Triple& ray) {
  constexpr double never = std::numeric_limits<double>::max();
  double enter = 0;
  double leave = never;
  for (std::size_t i = 0; i < 3; ++i) {
    if (ray[i] == 0) {
      if (box.least[i] > 0 || box.most[i] < 0) return never;
      continue;
    }
    const auto [near, far] = std::minmax({box.least[i] / ray[i], box.most[i] / ray[i]});
    enter = std::max(enter, near);
    leave = std::min(leave, far);
  }
  return enter < leave ? enter : never;
}

/// The body that the ray through this page point hits first: 1 or 2, or 0 for none. The distance of
/// the projection plane equals the page width.
std::uint8_t seen(const std::array<Box, 2>& boxes, double x, double y) {
  const Triple ray{(x - half) / screen_side, (half - y) / screen_side, -1};
  const double one = entry(boxes[0], ray);
  const double two = entry(boxes[1], ray);
  if (one == std::numeric_limits<double>::max() && two == one) return 0;
  return one < two ? 1 : 2;
}

/// The number of pixels with the wrong body. Pixels near an edge do not count, because rounding may
/// give them to either side.
int wrong_pixels(const pipeline::Mask& page, const std::array<Box, 2>& boxes) {
  int wrong = 0;
  for (std::int32_t y = 0; y < screen_side; ++y) {
    for (std::int32_t x = 0; x < screen_side; ++x) {
      const std::uint8_t here = seen(boxes, x, y);
      bool edge = false;
      for (const double dx : {-1.0, 1.0}) {
        for (const double dy : {-1.0, 1.0}) edge = edge || seen(boxes, x + dx, y + dy) != here;
      }
      if (!edge && page.row(y)[static_cast<std::size_t>(x)] != here) ++wrong;
    }
  }
  return wrong;
}

template <class N>
int wrong_pixels(const std::array<Box, 2>& boxes, DepthKey key, bool swapped = false) {
  Scene scene = pipeline::scene(screen_side, {});
  scene.depth_key = key;
  for (std::size_t i = 0; i < 2; ++i) {
    const Box& box = boxes[i];
    const Triple middle = scaled(sum(box.least, box.most), 0.5);
    scene.objects.push_back(pipeline::plain_body(pipeline::box(difference(box.most, middle)),
                                                 middle, static_cast<std::uint8_t>(i + 1)));
  }
  if (swapped) std::swap(scene.objects[0], scene.objects[1]);
  Animation<N> animation(scene);
  Picture picture;
  animation.draw(picture);
  return wrong_pixels(pipeline::drawn(picture, screen_side), boxes);
}

/// A wall on the right that runs from 10 to 110 away from the viewer.
constexpr Box wall{{10, -8, -110}, {12, 8, -10}};
/// On the viewer's side of the wall, nearer than its end and farther than its middle.
constexpr Box small_before{{6, -2, -72}, {8, 2, -68}};
/// On the other side of the wall, nearer than its middle.
constexpr Box small_behind{{16, -2, -44}, {18, 2, -40}};
/// Behind the wall but nearer by every key; its rightmost visible point is at 14 / 28.
constexpr Box wall_behind{{14, -2, -70}, {20, 2, -8}};

template <class N>
struct Overlap : testing::Test {};
TYPED_TEST_SUITE(Overlap, pipeline::scene_types, );

TYPED_TEST(Overlap, OneOfTheTwoOrdersIsRight) {
  for (const Box& other : {small_before, small_behind, wall_behind}) {
    const bool before = other.most[0] < wall.least[0];
    EXPECT_EQ(wrong_pixels<TypeParam>({wall, other}, DepthKey::none, !before), 0);
    EXPECT_GT(wrong_pixels<TypeParam>({wall, other}, DepthKey::none, before), 10);
  }
}

TYPED_TEST(Overlap, TheCentreIsNotEnough) {
  EXPECT_GT(wrong_pixels<TypeParam>({wall, small_before}, DepthKey::center), 10);
  EXPECT_GT(wrong_pixels<TypeParam>({wall, small_behind}, DepthKey::center), 10);
}

TYPED_TEST(Overlap, TheNearestPointIsNotEnough) {
  EXPECT_GT(wrong_pixels<TypeParam>({wall, small_before}, DepthKey::nearest), 10);
  EXPECT_EQ(wrong_pixels<TypeParam>({wall, small_behind}, DepthKey::nearest), 0);
}

TYPED_TEST(Overlap, TheFarthestPointIsNotEnough) {
  EXPECT_EQ(wrong_pixels<TypeParam>({wall, small_before}, DepthKey::farthest), 0);
  EXPECT_GT(wrong_pixels<TypeParam>({wall, small_behind}, DepthKey::farthest), 10);
}

TYPED_TEST(Overlap, NoKeyIsEnough) {
  for (const DepthKey key : {DepthKey::center, DepthKey::nearest, DepthKey::farthest}) {
    EXPECT_GT(wrong_pixels<TypeParam>({wall, wall_behind}, key), 10);
  }
}

}  // namespace
}  // namespace xsharp

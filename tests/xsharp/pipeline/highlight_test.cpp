/// Tests highlights on faces against the formula in double.
#include "xsharp/highlight.hpp"

#include "tests/support/test.hpp"
#include "tests/xsharp/pipeline/draws.hpp"
#include "tests/xsharp/pipeline/stage.hpp"
#include "tests/xsharp/pipeline/types.hpp"

namespace xsharp {
namespace {

using draws::Integers;
using pipeline::direction;
using pipeline::number;
using pipeline::product_error;
using pipeline::triple;
using pipeline::ulp;

constexpr Color black{};

template <class N>
Ray<N> ray(const Triple& to_light, const Intensity& intensity) {
  return {true,
          pipeline::vector<N>(to_light),
          {number<N>(intensity[0]), number<N>(intensity[1]), number<N>(intensity[2])}};
}

/// The cosine of the angle between the normal and the halfway vector, in double.
double cosine_of(const Triple& normal, const Triple& to_light, const Triple& to_viewer) {
  const Triple half = sum(to_light, to_viewer);
  return length(half) > 0 ? dot(half, normal) / length(half) : 0;
}

template <class N>
struct HighlightOf : testing::Test {};
TYPED_TEST_SUITE(HighlightOf, pipeline::scene_types, );

/// With products within p, a cosine is within 3 p, and 3 more ulps for the components of the
/// halfway vector. A power changes by at most its exponent times the cosine's error. Two more
/// products and the last rounding follow.
TYPED_TEST(HighlightOf, IsTheFormula) {
  using N = TypeParam;
  int bright = 0;
  EXPECT_TRUE(draws::hold(10, -100, 100, [&bright](const Integers& d) {
    const Vec3<N> normal = direction<N>(d[0], d[1], d[2]);
    const Vec3<N> to_viewer = direction<N>(d[3], d[4], d[5]);
    // The light is near the mirror image; otherwise, most highlights would be black.
    const double across = 2 * dot(triple(normal), triple(to_viewer));
    const Triple off{static_cast<double>(d[6]) / 400, static_cast<double>(d[7]) / 400, 0};
    const Triple mirrored = sum(difference(scaled(triple(normal), across), triple(to_viewer)), off);
    if (length(mirrored) < 0.1) return true;
    Lighting<N> lighting;
    lighting.rays.push_back(ray<N>(scaled(mirrored, 1 / length(mirrored)), {1, 0.5, 0}));
    const Highlight highlight{1.0 + static_cast<double>(d[8] + 100) / 2,
                              static_cast<double>(d[9] + 100) / 200};
    const Color shown = with_highlight(black, normal, to_viewer, highlight, lighting);
    const Triple light = triple(lighting.rays[0].to_light);
    const double facing = dot(light, triple(normal));
    const double cosine = cosine_of(triple(normal), light, triple(to_viewer));
    if (std::fabs(facing) < 4 * ulp || std::fabs(cosine) < 8 * ulp) return true;
    if (length(sum(light, triple(to_viewer))) < 0.1) return true;
    double exact = 0;
    if (facing > 0 && cosine > 0) {
      exact = 255 * highlight.strength * std::pow(std::min(cosine, 1.0), highlight.exponent);
    }
    bright += exact > 10 ? 1 : 0;
    const double p = product_error<N>();
    const double allowed =
        std::max(0.5, p / ulp) + 255 * (highlight.exponent * (3 * p + 6 * ulp) + 3 * p);
    return std::fabs(shown.red - exact) <= allowed &&
           std::fabs(shown.green - exact / 2) <= allowed && shown.blue == 0;
  }));
  EXPECT_GT(bright, 10);
}

// By hand: light and viewer are equally far from the normal, so the halfway vector is the normal,
// and the power is 1. Halfway between (0.6, 0, 0.8) and (0, 0, 1) is (1, 0, 3) / sqrt(10), whose
// cosine with (0, 0, 1) is 0.948683: squared, 0.9; to the power of 20, 0.9^10 = 0.348678.
TYPED_TEST(HighlightOf, WorkedByHand) {
  using N = TypeParam;
  const Vec3<N> normal = pipeline::vector<N>({0, 0, 1});
  Lighting<N> lighting;
  lighting.rays.push_back(ray<N>({0.6, 0, 0.8}, {1, 0.5, 0}));
  const Color mirrored =
      with_highlight(black, normal, pipeline::vector<N>({-0.6, 0, 0.8}), {1000, 0.5}, lighting);
  EXPECT_NEAR(mirrored.red, 127.5, 4);
  EXPECT_NEAR(mirrored.green, 63.75, 2);
  EXPECT_EQ(mirrored.blue, 0);
  const Color aside = with_highlight({10, 20, 30}, normal, normal, {20, 1}, lighting);
  EXPECT_NEAR(aside.red, 10 + 88.9, 1);
  EXPECT_NEAR(aside.green, 20 + 44.5, 1);
  EXPECT_EQ(aside.blue, 30);
}

TYPED_TEST(HighlightOf, AddsUpToWhiteAtMost) {
  using N = TypeParam;
  const Vec3<N> normal = pipeline::vector<N>({0, 0, 1});
  Lighting<N> lighting;
  for (int i = 0; i < 16; ++i) lighting.rays.push_back(ray<N>({0, 0, 1}, {100, 100, 100}));
  EXPECT_EQ(with_highlight({200, 0, 255}, normal, normal, {1000, 1}, lighting),
            (Color{255, 255, 255}));
}

TYPED_TEST(HighlightOf, NoneFromALightThatIsOffOrBehind) {
  using N = TypeParam;
  const Vec3<N> normal = pipeline::vector<N>({0, 0, 1});
  const Color before{1, 2, 3};
  Lighting<N> lighting;
  lighting.rays.push_back(ray<N>({0, 0, 1}, {1, 1, 1}));
  EXPECT_NE(with_highlight(before, normal, normal, {5, 1}, lighting), before);
  EXPECT_EQ(with_highlight(before, normal, normal, {5, 0}, lighting), before);
  lighting.rays[0].on = false;
  EXPECT_EQ(with_highlight(before, normal, normal, {5, 1}, lighting), before);
  // The light is behind the face, although the halfway vector is in front of it.
  lighting.rays[0] = ray<N>({0.8, 0, -0.6}, {1, 1, 1});
  EXPECT_EQ(with_highlight(before, normal, normal, {5, 1}, lighting), before);
  // A light opposite the viewer has no halfway vector.
  lighting.rays[0] = ray<N>({0.6, 0, 0.8}, {1, 1, 1});
  const Vec3<N> opposite = pipeline::vector<N>({-0.6, 0, -0.8});
  EXPECT_EQ(with_highlight(before, normal, opposite, {5, 1}, lighting), before);
}

/// A ball with a highlight and the same without one.
Scene two_balls(double strength) {
  ObjectDescription object = pipeline::body(with_normals(ball(40, 10)), {0, 0, -300});
  for (Paint& paint : object.paints) paint = {false, 0, {40, 80, 120}};
  object.shadings.assign(object.paints.size(), {true, true, Highlight{30, strength}});
  Scene scene = pipeline::scene(200, {object});
  scene.lights.spots.push_back({.direction = {-1, -1, -2}, .intensity = {1, 1, 1}});
  return scene;
}

template <class N>
std::vector<Color> colors_of(const Scene& scene) {
  Animation<N> animation(scene);
  Picture picture;
  animation.draw(picture);
  std::vector<Color> colors;
  for (const Polygon& polygon : picture.polygons) colors.push_back(polygon.paint.color);
  return colors;
}

// A face of a ball has a highlight where its normal is near the halfway vector, nowhere else.
TYPED_TEST(HighlightOf, OfABallIsASpot) {
  const auto with = colors_of<TypeParam>(two_balls(1));
  const auto without = colors_of<TypeParam>(two_balls(0));
  ASSERT_EQ(with.size(), without.size());
  std::size_t brighter = 0;
  int most = 0;
  for (std::size_t i = 0; i < with.size(); ++i) {
    const int added = with[i].red - without[i].red;
    EXPECT_GE(added, 0);
    brighter += added > 8 ? 1 : 0;
    most = std::max(most, added);
  }
  EXPECT_GT(most, 180);
  EXPECT_GT(brighter, 5U);
  EXPECT_LT(brighter, with.size() / 3);
}

// float rounds to 24 bits: its colours are those of double, give or take one.
TEST(HighlightInFloat, IsThatOfDouble) {
  const auto single = colors_of<float>(two_balls(1));
  const auto exact = colors_of<double>(two_balls(1));
  ASSERT_EQ(single.size(), exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_NEAR(single[i].red, exact[i].red, 1);
}

}  // namespace
}  // namespace xsharp

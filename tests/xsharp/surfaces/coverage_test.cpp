// Tests that interpolated polygons cover the same pixels as flat ones, whatever their values.
#include <rapidcheck.h>

#include "tests/support/test.hpp"
#include "tests/xsharp/raster/generators.hpp"
#include "tests/xsharp/surfaces/strip.hpp"
#include "xsharp/raster/fill.hpp"
#include "xsharp/raster/screen.hpp"

namespace surfaces {
namespace {

using namespace xsharp;
using definition::Points;

constexpr std::int32_t sheet_width = 32;
constexpr std::int32_t sheet_height = 24;

Picture picture_of(const Points& points, const std::vector<PointValues>& values) {
  Picture picture;
  picture.points = points;
  picture.values = values;
  picture.polygons.push_back({.object = 0,
                              .first = 0,
                              .points = static_cast<std::uint32_t>(points.size()),
                              .paint = {.is_index = true, .index = 1}});
  return picture;
}

Indices flat(const Points& points) {
  Indices page(sheet_width, sheet_height);
  Filler().fill<std::uint8_t>(page, points, 1);
  return page;
}

template <class Fill>
Indices by(Fill&& filler, const Picture& picture) {
  return drawn(filler, picture, sheet_width, sheet_height);
}

StepFiller<fixproof::q16_16_i386> stepper(const Scene& scene) {
  return {scene, std::make_unique<PlainLoops>()};
}

TEST(SurfaceCoverage, IsThatOfAFlatPolygon) {
  const Scene scene = scene_of({}, DepthBuffering::on);
  EXPECT_TRUE(rc::check([&] {
    const bool near = *rc::gen::arbitrary<bool>();
    const Points points =
        generators::some(near ? generators::small() : generators::extreme(), 0, 8);
    std::vector<PointValues> values(points.size());
    for (PointValues& value : values) value[0] = *generators::among(1, 32767);
    const Picture picture = picture_of(points, values);
    const Indices expected = flat(points);
    RC_ASSERT(by(stepper(scene), picture) == expected);
    // In double, crossings of long edges are not exact.
    if (near) RC_ASSERT(by(ExactFiller(scene), picture) == expected);
  }));
}

TEST(SurfaceCoverage, NoValuesAreUndefinedBehaviour) {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(rc::check([] {
    const Points points = generators::some(generators::extreme(), 3, 6);
    std::vector<PointValues> values(points.size());
    for (PointValues& value : values) {
      for (double& number : value) {
        number = *rc::gen::oneOf(
            rc::gen::element(infinity, -infinity, std::numeric_limits<double>::quiet_NaN(), 0.0,
                             32767.0, -32768.0, 1e300),
            rc::gen::map(generators::among(-70000, 70000), [](int n) { return n / 3.0; }));
      }
    }
    const Picture picture = picture_of(points, values);
    Surface surface;
    surface.kind = static_cast<SurfaceKind>(*generators::among(0, 8));
    surface.phong = static_cast<PhongForm>(*generators::among(0, 3));
    surface.exact_every = exact_choices.at(*generators::among<std::size_t>(0, 4));
    const auto depth = static_cast<DepthBuffering>(*generators::among(0, 4));
    const Scene scene = scene_of(surface, depth);
    by(stepper(scene), picture);
    by(StepFiller<fixproof::q16_16_i8088_unrounded>(scene, std::make_unique<PlainLoops>()),
       picture);
    by(ExactFiller(scene), picture);
  }));
}

/// Two strips of 20 by 2 pixels. The first is farther away than the second in its left half.
Picture two_strips() {
  Picture picture = strip(20, {100, 3}, {30000, 120});
  const Picture other = strip(20, {15000, 60}, {15000, 60});
  picture.points.insert(picture.points.end(), other.points.begin(), other.points.end());
  picture.values.insert(picture.values.end(), other.values.begin(), other.values.end());
  picture.polygons[0].paint = {.is_index = true, .index = 7};
  picture.polygons.push_back(
      {.object = 0, .first = 4, .points = 4, .paint = {.is_index = true, .index = 200}});
  return picture;
}

// A true-colour pixel has the palette's colour for its index, or the paint of a flat surface.
// Hidden pixels stay unchanged.
TEST(SurfaceCoverage, TrueColorShowsTheSame) {
  for (const SurfaceKind kind : {SurfaceKind::gouraud16, SurfaceKind::flat}) {
    for (const DepthBuffering depth : {DepthBuffering::off, DepthBuffering::on}) {
      Surface surface;
      surface.kind = kind;
      const Scene scene = scene_of(surface, depth);
      auto indexed = stepper(scene);
      auto true_color = stepper(scene);
      Screen<std::uint8_t> indices(sheet_width, sheet_height, PaletteKind::ramps, 0, &indexed);
      Screen<std::uint32_t> colors(sheet_width, sheet_height, PaletteKind::ramps, 0, &true_color);
      indices.show(two_strips());
      colors.show(two_strips());
      EXPECT_EQ(indices.count().pixels, depth == DepthBuffering::off ? 80 : 60);
      EXPECT_EQ(colors.count().pixels, indices.count().pixels);
      if (kind == SurfaceKind::flat) {
        const auto painted = [&](std::uint8_t index) {
          return std::ranges::count(indices.page().pixels(), index);
        };
        EXPECT_EQ(painted(7), depth == DepthBuffering::off ? 0 : 20);
        EXPECT_EQ(painted(200), depth == DepthBuffering::off ? 40 : 20);
      }
      for (std::size_t i = 0; i < colors.page().pixels().size(); ++i) {
        EXPECT_EQ(colors.page().pixels()[i],
                  rgb(palette_of(PaletteKind::ramps).at(indices.page().pixels()[i])));
      }
    }
  }
}

}  // namespace
}  // namespace surfaces

// Phong's light by stepping against the exact light at every pixel.
//
// Along a span a normal goes straight: n(x) = n0 + x d. With r the least distance of that line from
// 0 and k = |d| / r, the light M . n / |n| is A cos(theta - phi), |A| <= |M|, tan theta = k (x -
// x0). Differentiated, |light''| <= |M| k^2 and |light'''| <= 3 |M| k^3, both reached where theta
// is 0. A line between values h apart then errs by h^2 / 8 |light''|, a parabola through three
// values h apart by h^3 / (9 sqrt 3) |light'''| = |M| (k h)^3 / (3 sqrt 3).
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "tests/surfaces/strip.hpp"
#include "tests/xsharp/raster/generators.hpp"
#include "xsharp/files/scene_json.hpp"
#include "xsharp/raster/fill.hpp"

namespace surfaces {
namespace {

using namespace xsharp;

Triple any_direction() {
  const auto part = [] { return *generators::among(-1000, 1001) / 1000.0; };
  const Triple v{part(), part(), part()};
  const double size = length(v);
  return size < 0.1 ? Triple{0, 0, 1} : scaled(v, 1 / size);
}

/// As 16.16 has it.
double rounded(double x) { return std::floor(x / ulp + 0.5) * ulp; }

/// The least distance from 0 of the way from `a` to `b`.
double least_distance(const Triple& a, const Triple& b) {
  const Triple way = difference(b, a);
  const double square = dot(way, way);
  const double part = square > 0 ? std::clamp(-dot(a, way) / square, 0.0, 1.0) : 0;
  return length(sum(a, scaled(way, part)));
}

/// What arithmetic adds, in levels: a component of a normal that is off by half a unit of its slope
/// for every pixel and row it was stepped, unit() by four units, three products; a parabola makes
/// of errors in its three values at most 1.25 of them and adds 0.07 (more_loops.hpp).
double arithmetic_error(double steps, double distance) {
  const double normal = (steps / 2 + 2) * ulp / distance;
  return ramp_levels * 1.25 * (2 * normal + 12 * ulp) + 0.07;
}

/// Levels that an index may differ by whose value differs by less than this.
int levels(double bound) { return static_cast<int>(std::floor(bound)) + 1; }

int most_difference(const Indices& one, const Indices& other) {
  int most = 0;
  for (std::size_t i = 0; i < one.pixels().size(); ++i) {
    most = std::max(most, std::abs(one.pixels()[i] - other.pixels()[i]));
  }
  return most;
}

TEST(Phong, EverySpanIsWithinItsBound) {
  EXPECT_TRUE(rc::check([] {
    const std::int32_t width = *generators::among(1, 321);
    Triple from = any_direction();
    Triple to = any_direction();
    const Triple light = any_direction();
    if (dot(from, to) < 0) to = scaled(to, -1);
    for (std::size_t i = 0; i < 3; ++i) {
      from[i] = rounded(from[i]);
      to[i] = rounded(to[i]);
    }
    Picture picture = strip(width, {0, from[0], from[1], from[2]}, {0, to[0], to[1], to[2]});
    for (std::size_t i = 0; i < 3; ++i) picture.light[i] = rounded(light[i]);

    Surface surface;
    surface.kind = SurfaceKind::phong;
    ExactFiller exact(scene_of(surface));
    const Indices expected = drawn(exact, picture, width, 1);
    const double distance = least_distance(from, to);
    const double k = length(difference(to, from)) / width / distance;
    const auto check = [&](PhongForm form, double bound) {
      surface.phong = form;
      StepFiller<Number> filler(scene_of(surface), std::make_unique<PlainLoops>());
      const int most = most_difference(drawn(filler, picture, width, 1), expected);
      RC_ASSERT(most <= levels(bound + arithmetic_error(width, distance)));
    };
    check(PhongForm::exact, 0);
    check(PhongForm::fourth, ramp_levels * 16.0 / 8 * k * k);
    const double half = k * (width - 1) / 2;
    check(PhongForm::quadratic, ramp_levels * half * half * half / (3 * std::sqrt(3.0)));
  }));
}

/// The bound of a polygon's spans: every normal of it is between those of its corners, so that a
/// span's way is at most the longest between two corners, and as far from 0 as the corners are
/// along their mean.
double polygon_bound(const Picture& picture, const Polygon& polygon) {
  const auto values = picture.values_of(polygon);
  std::vector<Triple> normals;
  Triple mean{};
  for (const PointValues& value : values) {
    normals.push_back({value[1], value[2], value[3]});
    mean = sum(mean, normals.back());
  }
  mean = scaled(mean, 1 / length(mean));
  double way = 0;
  double distance = 2;
  for (const Triple& normal : normals) {
    distance = std::min(distance, dot(normal, mean));
    for (const Triple& other : normals) way = std::max(way, length(difference(normal, other)));
  }
  const double half = way / 2 / distance;
  const double light = length(picture.light);
  const auto points = picture.points_of(polygon);
  const auto [left, right] = std::ranges::minmax(points, {}, &ScreenPoint::x);
  const auto [top, bottom] = std::ranges::minmax(points, {}, &ScreenPoint::y);
  const int steps = right.x - left.x + bottom.y - top.y;
  return ramp_levels * light * half * half * half / (3 * std::sqrt(3.0)) +
         arithmetic_error(steps, distance);
}

// The scene, every pixel: the polygon that is seen there says by how much it may differ.
TEST(Phong, TheSceneByParabolasIsWithinTheBoundOfEachPolygon) {
  const Scene scene = read_scene(SCENES "/phong.json");
  Animation<Number> animation(scene);
  StepFiller<Number> stepped(scene, std::make_unique<PlainLoops>());
  ExactFiller exact(scene);
  Filler filler;
  Picture picture;
  int differing = 0;
  double greatest_bound = 0;
  for (int frame = 0; frame < 60; ++frame) {
    if (frame > 0) animation.move();
    animation.draw(picture);
    const Indices one = drawn(stepped, picture, scene.width, scene.height);
    const Indices other = drawn(exact, picture, scene.width, scene.height);
    Page<std::uint32_t> allowed(scene.width, scene.height);
    for (const Polygon& polygon : picture.polygons) {
      const double bound = polygon_bound(picture, polygon);
      greatest_bound = std::max(greatest_bound, bound);
      filler.fill<std::uint32_t>(allowed, picture.points_of(polygon),
                                 static_cast<std::uint32_t>(levels(bound)));
    }
    for (std::size_t i = 0; i < one.pixels().size(); ++i) {
      const int off = std::abs(one.pixels()[i] - other.pixels()[i]);
      differing += off == 0 ? 0 : 1;
      ASSERT_LE(off, static_cast<int>(allowed.pixels()[i])) << "frame " << frame << ", pixel " << i;
    }
  }
  EXPECT_GT(differing, 0);
  // Of any polygon of the scene.
  EXPECT_LT(greatest_bound, 2);
}

}  // namespace
}  // namespace surfaces

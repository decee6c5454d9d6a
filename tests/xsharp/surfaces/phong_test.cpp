// Compares stepped Phong light with the exact light at every pixel.
//
// Along a span the normal is linear: n(x) = n0 + x d. Let r be the least distance of that line from
// 0 and k = |d| / r. The light M . n / |n| is A cos(theta - phi) with |A| <= |M| and tan(theta) = k
// (x - x0). Its derivatives satisfy |light''| <= |M| k^2 and |light'''| <= 3 |M| k^3, with equality
// where theta is 0. A line between values h apart is off by at most h^2 / 8 |light''|. A parabola
// through three values h apart is off by at most h^3 / (9 sqrt 3) |light'''| = |M| (k h)^3 / (3
// sqrt 3).
#include <rapidcheck.h>

#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"
#include "tests/xsharp/raster/generators.hpp"
#include "tests/xsharp/surfaces/polygon_row.hpp"
#include "tests/xsharp/surfaces/strip.hpp"
#include "xsharp/files/scene_json.hpp"

namespace surfaces {
namespace {

using namespace xsharp;

Triple any_direction() {
  const auto part = [] { return *generators::among(-1000, 1001) / 1000.0; };
  const Triple v{part(), part(), part()};
  const double size = length(v);
  return size < 0.1 ? Triple{0, 0, 1} : scaled(v, 1 / size);
}

double rounded(double x) { return std::floor(x / ulp + 0.5) * ulp; }

/// The least distance from 0 of the segment from `a` to `b`.
double least_distance(const Triple& a, const Triple& b) {
  const Triple way = difference(b, a);
  const double square = dot(way, way);
  const double part = square > 0 ? std::clamp(-dot(a, way) / square, 0.0, 1.0) : 0;
  return length(sum(a, scaled(way, part)));
}

constexpr std::array<PhongForm, 3> forms{PhongForm::exact, PhongForm::fourth, PhongForm::quadratic};

/// A span of `count` pixels under a light of length `light`, with k (above) per pixel.
struct Way {
  std::int32_t count = 0;
  double k = 0;
  double light = 1;
};

/// The error of the chord or the parabola, in levels. The form `exact` has neither.
double form_error(PhongForm form, const Way& way) {
  const double last = way.count - 1;
  if (form == PhongForm::exact || last < 1) return 0;
  if (form == PhongForm::fourth) {
    const double stretch = std::min(4.0, last) * way.k;
    return ramp_levels * way.light * stretch * stretch / 8;
  }
  const double half = last / 2 * way.k;
  return ramp_levels * way.light * half * half * half / (3 * std::sqrt(3.0));
}

/// The error of the arithmetic, in levels. `component` bounds the error of a normal's component,
/// and `distance` is the least length of a normal. The error has that part, four units from unit()
/// and three products. A parabola turns errors in its three values into at most 1.25 times as much.
/// Its words add less than 0.03 in 320 pixels: its second difference on a ramp is doubled five
/// times before the two rounding divides, so x^2 times 2^-22 is 0.025, and the slope adds 0.001.
double arithmetic_error(PhongForm form, double component, double distance) {
  const double value = ramp_levels * (2 * component / distance + 12 * ulp);
  return form == PhongForm::quadratic ? 1.25 * value + 0.03 : value;
}

/// The largest index difference when the values differ by less than `bound`.
int levels(double bound) { return static_cast<int>(std::floor(bound)) + 1; }

int max_difference(const Indices& one, const Indices& other) {
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
    const double component = (width / 2.0 + 2) * ulp;
    for (const PhongForm form : forms) {
      surface.phong = form;
      StepFiller<Number> filler(scene_of(surface), std::make_unique<PlainLoops>());
      const int most = max_difference(drawn(filler, picture, width, 1), expected);
      RC_ASSERT(most <= levels(form_error(form, {width, k, 1}) +
                               arithmetic_error(form, component, distance)));
    }
  }));
}

/// Error bounds of each pixel for each form, as whole levels.
class Bounds {
 public:
  explicit Bounds(const Picture& picture, std::int32_t width, std::int32_t height) {
    for (auto& page : pages_) page = std::make_unique<Indices>(width, height);
    for (const Polygon& polygon : picture.polygons) {
      for (std::int32_t y = 0; y < height; ++y) {
        if (const auto row = row_of(picture, polygon, y)) add(*row, length(picture.light), y);
      }
    }
  }

  [[nodiscard]] int of(PhongForm form, std::size_t pixel) const {
    return pages_.at(static_cast<std::size_t>(form))->pixels()[pixel];
  }
  [[nodiscard]] double greatest(PhongForm form) const {
    return greatest_.at(static_cast<std::size_t>(form));
  }

 private:
  /// Adds the row of a polygon, which covers earlier polygons.
  void add(const PolygonRow& row, double light, std::int32_t y) {
    const std::int32_t first = row.first();
    const std::int32_t end = row.end(pages_[0]->width());
    if (first >= end) return;
    const Triple from{row.from[1], row.from[2], row.from[3]};
    const Triple to{row.to[1], row.to[2], row.to[3]};
    const double distance = least_distance(from, to);
    const Way way{end - first, length(difference(to, from)) / row.width() / distance, light};
    double component = 0;
    for (const std::size_t k : {1U, 2U, 3U}) {
      component = std::max(component, stepping_error(row, k, end - 1, ulp));
    }
    for (const PhongForm form : forms) {
      const auto i = static_cast<std::size_t>(form);
      const double bound = form_error(form, way) + arithmetic_error(form, component, distance);
      greatest_.at(i) = std::max(greatest_.at(i), bound);
      const auto pixels = pages_.at(i)->row(y).subspan(static_cast<std::size_t>(first),
                                                       static_cast<std::size_t>(end - first));
      std::ranges::fill(pixels, static_cast<std::uint8_t>(std::min(levels(bound), 255)));
    }
  }

  std::array<std::unique_ptr<Indices>, 3> pages_{};
  std::array<double, 3> greatest_{};
};

// Compares every pixel at half size. The visible row at a pixel sets the bound.
TEST(Phong, EveryPixelOfTheSceneIsWithinTheBoundOfItsRow) {
  Scene scene = read_scene(paths::scene("phong.json"));
  scene.width /= 2;
  scene.height /= 2;
  Animation<Number> animation(scene);
  std::vector<std::unique_ptr<StepFiller<Number>>> stepped;
  for (const PhongForm form : forms) {
    for (ObjectDescription& object : scene.objects) object.surface.phong = form;
    stepped.push_back(std::make_unique<StepFiller<Number>>(scene, std::make_unique<PlainLoops>()));
  }
  ExactFiller exact(scene);
  Picture picture;
  std::array<int, 3> differing{};
  std::array<double, 3> greatest{};
  for (int frame = 0; frame < 300; ++frame) {
    if (frame > 0) animation.move();
    animation.draw(picture);
    const Indices expected = drawn(exact, picture, scene.width, scene.height);
    const Bounds bounds(picture, scene.width, scene.height);
    for (const PhongForm form : forms) {
      const auto f = static_cast<std::size_t>(form);
      greatest.at(f) = std::max(greatest.at(f), bounds.greatest(form));
      const Indices is = drawn(*stepped.at(f), picture, scene.width, scene.height);
      for (std::size_t i = 0; i < is.pixels().size(); ++i) {
        const int off = std::abs(is.pixels()[i] - expected.pixels()[i]);
        differing.at(f) += off == 0 ? 0 : 1;
        ASSERT_LE(off, bounds.of(form, i))
            << phong_words.at(f) << ", frame " << frame << ", pixel " << i;
      }
    }
  }
  for (const int pixels : differing) EXPECT_GT(pixels, 0);
  // These are bounds over all rows, in levels. The exact form has only arithmetic error; a chord is
  // worse the more of a turn four pixels span.
  EXPECT_LT(greatest[0], 0.1);
  EXPECT_LT(greatest[1], 6);
  EXPECT_LT(greatest[2], 1.2);
}

}  // namespace
}  // namespace surfaces

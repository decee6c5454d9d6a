/// Tests clipping, and that the clipped points can be projected.
#include "xsharp/clip.hpp"

#include "tests/support/test.hpp"
#include "tests/xsharp/pipeline/draws.hpp"
#include "tests/xsharp/pipeline/types.hpp"

namespace xsharp {
namespace {

using draws::Integers;
using pipeline::triple;
using pipeline::ulp;

template <class N>
using Points = std::vector<Vec3<N>>;

constexpr std::array<std::int32_t, 6> slopes{1, 2, 16, 64, 512, 1024};

template <class N>
Points<N> clipped(const Points<N>& polygon, std::int32_t slope) {
  return clip<N>(std::span<const Vec3<N>>(polygon), slope);
}

/// The points for `drawn`, which has three numbers per point.
template <class N>
Points<N> points_of(const Integers& drawn) {
  const auto coordinate = [&](std::size_t i) {
    return Arithmetic<N>::from_raw(static_cast<std::int32_t>(drawn[i]));
  };
  Points<N> points;
  for (std::size_t i = 0; i + 2 < drawn.size(); i += 3) {
    points.push_back({coordinate(i), coordinate(i + 1), coordinate(i + 2)});
  }
  return points;
}

/// Halving 32 times, with half an ulp of rounding each, moves a point off its edge by at most 16
/// ulp per component.
constexpr double off_edge = 16 * ulp;

/// Whether the point is inside by the definition of the volume. At most two later planes cut an
/// edge along a side again. Each moves x or y off the side, and also z times the slope.
template <class N>
bool is_inside(const Vec3<N>& point, std::int32_t slope) {
  const auto [x, y, z] = triple(point);
  const double most = -slope * z + 2 * (1 + slope) * off_edge;
  return z <= -1 && std::fabs(x) <= most && std::fabs(y) <= most;
}

/// Whether `holds` is true under every slope for triangles of any size and near the near plane.
template <class N, class Check>
bool for_triangles(Check holds) {
  const auto check = [holds](const Integers& drawn) {
    return std::all_of(slopes.begin(), slopes.end(),
                       [&](std::int32_t slope) { return holds(points_of<N>(drawn), slope); });
  };
  return draws::hold_for_raws(9, check) && draws::hold(9, -300000, 300000, check);
}

template <class N>
struct Clip : testing::Test {};
TYPED_TEST_SUITE(Clip, pipeline::multiplying_types, );

TYPED_TEST(Clip, OnlyWhatIsInsideIsLeft) {
  using N = TypeParam;
  EXPECT_TRUE(for_triangles<N>([](const Points<N>& triangle, std::int32_t slope) {
    const Points<N> left = clipped(triangle, slope);
    return std::all_of(left.begin(), left.end(),
                       [&](const Vec3<N>& point) { return is_inside(point, slope); });
  }));
}

TYPED_TEST(Clip, WhatIsWhollyInsideIsLeftAsItIs) {
  using N = TypeParam;
  EXPECT_TRUE(for_triangles<N>([](Points<N> triangle, std::int32_t slope) {
    for (Vec3<N>& point : triangle) {
      auto [x, y, z] = triple(point);
      z = std::min(-1.0, -std::fabs(z));
      x = std::clamp(x, slope * z, -slope * z);
      y = std::clamp(y, slope * z, -slope * z);
      point = pipeline::vector<N>({x, y, z});
    }
    return clipped(triangle, slope) == triangle;
  }));
}

TYPED_TEST(Clip, WhatIsWhollyBeyondOnePlaneIsGone) {
  using N = TypeParam;
  EXPECT_TRUE(for_triangles<N>([](const Points<N>& triangle, std::int32_t slope) {
    const auto all = [&](auto beyond) {
      return std::all_of(triangle.begin(), triangle.end(),
                         [&](const Vec3<N>& point) { return beyond(triple(point)); });
    };
    const bool outside = all([](const Triple& p) { return p[2] > -1; }) ||
                         all([&](const Triple& p) { return p[0] < slope * p[2]; }) ||
                         all([&](const Triple& p) { return p[0] > -slope * p[2]; }) ||
                         all([&](const Triple& p) { return p[1] < slope * p[2]; }) ||
                         all([&](const Triple& p) { return p[1] > -slope * p[2]; });
    return !outside || clipped(triangle, slope).empty();
  }));
  const Points<N> behind{pipeline::vector<N>({1, 0, 5}), pipeline::vector<N>({0, 1, -0.5}),
                         pipeline::vector<N>({-1, 0, 7})};
  EXPECT_TRUE(clipped(behind, 1).empty());
}

TYPED_TEST(Clip, AnEdgeThatTwoPolygonsShareGetsTheSamePointsFromBoth) {
  using N = TypeParam;
  const auto check = [](const Integers& drawn) {
    const Points<N> p = points_of<N>(drawn);
    return std::all_of(slopes.begin(), slopes.end(), [&](std::int32_t slope) {
      const Points<N> one = clipped<N>({p[0], p[1], p[2]}, slope);
      const Points<N> other = clipped<N>({p[1], p[0], p[3]}, slope);
      const Points<N> edge = clipped<N>({p[0], p[1]}, slope);
      return std::all_of(edge.begin(), edge.end(), [&](const Vec3<N>& point) {
        return std::count(one.begin(), one.end(), point) > 0 &&
               std::count(other.begin(), other.end(), point) > 0;
      });
    });
  };
  EXPECT_TRUE(draws::hold_for_raws(12, check));
  EXPECT_TRUE(draws::hold(12, -300000, 300000, check));
}

/// Whether each corner turns the same way as the triangle. The tolerance allows for errors from
/// each of the five planes.
template <class N>
bool keeps_convex(const Points<N>& triangle, std::int32_t slope) {
  const auto at = [](const Points<N>& points, std::size_t i) {
    return triple(points[i % points.size()]);
  };
  const auto turn = [&](const Points<N>& points, std::size_t i) {
    return cross(difference(at(points, i + 1), at(points, i)),
                 difference(at(points, i + 2), at(points, i + 1)));
  };
  const Triple normal = turn(triangle, 0);
  if (length(normal) == 0) return true;
  const Triple unit = scaled(normal, 1 / length(normal));
  const Points<N> left = clipped(triangle, slope);
  const double off = 5 * std::sqrt(3.0) * off_edge;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const double edges = length(difference(at(left, i + 1), at(left, i))) +
                         length(difference(at(left, i + 2), at(left, i + 1)));
    if (dot(turn(left, i), unit) < -2 * off * (edges + off)) return false;
    // Each point must also lie in the plane of the triangle.
    if (std::fabs(dot(difference(at(left, i), at(triangle, 0)), unit)) > off) return false;
  }
  return true;
}

TYPED_TEST(Clip, StaysConvexFlatAndInTheSameSense) {
  EXPECT_TRUE(for_triangles<TypeParam>(keeps_convex<TypeParam>));
}

TYPED_TEST(Clip, AWallIsCutAtTheVolumesEdges) {
  using N = TypeParam;
  // A very wide wall at z = -4 keeps only the four corners of the volume at that depth.
  const Points<N> corners{
      pipeline::vector<N>({-30000, 30000, -4}), pipeline::vector<N>({30000, 30000, -4}),
      pipeline::vector<N>({30000, -30000, -4}), pipeline::vector<N>({-30000, -30000, -4})};
  const Points<N> left = clipped(corners, 64);
  for (const Triple& corner :
       {Triple{-256, 256, -4}, {256, 256, -4}, {256, -256, -4}, {-256, -256, -4}}) {
    EXPECT_TRUE(std::any_of(
        left.begin(), left.end(),
        [&](const Vec3<N>& point) { return length(difference(triple(point), corner)) < 2 * ulp; }))
        << corner[0] << " " << corner[1];
  }
  // The near plane cuts the edge from z = -9 to z = 7 halfway, at z = -1.
  const Points<N> edge =
      clipped<N>({pipeline::vector<N>({0, 0, -9}), pipeline::vector<N>({0, 16, 7})}, 64);
  ASSERT_GE(edge.size(), 2U);
  EXPECT_LT(length(difference(triple(edge[1]), {0, 8, -1})), 2 * ulp);
}

template <class N>
Projection<N> projection(double ratio, std::int32_t width) {
  Scene scene;
  scene.projection_ratio = ratio;
  scene.width = width;
  scene.height = width;
  return projection_of<N>(scene);
}

template <class N>
struct ClippedProjection : testing::Test {};
TYPED_TEST_SUITE(ClippedProjection, pipeline::all_types, );

TYPED_TEST(ClippedProjection, WhatIsLeftIsProjectedWithoutAFaultAndWithin16Bits) {
  using N = TypeParam;
  // Projection constants run from -0.01 to -16000, the limits of a scene.
  for (const auto& [ratio, width] :
       {std::pair{-0.01, 2}, {-2.0, 320}, {-1.0, 4096}, {-8.0, 4000}}) {
    const Projection<N> p = projection<N>(ratio, width);
    const auto check = [&](const Integers& drawn) {
      const Points<N> left = clipped(points_of<N>(drawn), p.slope);
      return std::all_of(left.begin(), left.end(), [&](const Vec3<N>& point) {
        const auto on_screen = project(point, p);
        return on_screen && std::abs(on_screen->x - p.center_x) <= 32001 &&
               std::abs(on_screen->y - p.center_y) <= 32001;
      });
    };
    EXPECT_TRUE(draws::hold_for_raws(9, check)) << ratio;
    EXPECT_TRUE(draws::hold(9, -300000, 300000, check)) << ratio;
  }
}

TYPED_TEST(ClippedProjection, AProjectedPointIsWhereTheQuotientIs) {
  using N = TypeParam;
  // z is a whole number, so the 8088 divide drops no fraction.
  const Projection<N> p = projection<N>(-2, 320);
  EXPECT_EQ(project(pipeline::vector<N>({0, 0, -1}), p), (ScreenPoint{160, 160}));
  EXPECT_EQ(project(pipeline::vector<N>({4, 2, -8}), p), (ScreenPoint{320, 80}));
  EXPECT_EQ(project(pipeline::vector<N>({-4, -2, -16}), p), (ScreenPoint{80, 200}));
}

TEST(Clip8088, WithoutClippingTheDivideFaults) {
  using N = fixproof::q16_16_i8088;
  const auto divided = [](double n, double d) {
    return Arithmetic<N>::divide(pipeline::number<N>(n), pipeline::number<N>(d));
  };
  EXPECT_FALSE(divided(1, -0.75));
  EXPECT_FALSE(divided(0, 0.999));
  EXPECT_TRUE(divided(1, -1));
  EXPECT_FALSE(project(pipeline::vector<N>({5, 5, -0.5}), projection<N>(-2, 320)));
}

}  // namespace
}  // namespace xsharp

/// @file
/// Clipping in view space, so that no divide faults and no projected coordinate wraps.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "xsharp/arithmetic.hpp"
#include "xsharp/project.hpp"
#include "xsharp/transform.hpp"

namespace xsharp {

/// The planes of the clip volume: z <= -1, and x and y within +-slope * z.
enum class ClipPlane { near, left, right, below, above };
inline constexpr std::array clip_planes{ClipPlane::near, ClipPlane::left, ClipPlane::right,
                                        ClipPlane::below, ClipPlane::above};

/// Whether a point is inside a plane. Computed in double, which is exact for every term.
template <Scalar N>
bool inside(const Vec3<N>& point, ClipPlane plane, std::int32_t slope) {
  const auto x = static_cast<double>(point.x);
  const auto y = static_cast<double>(point.y);
  const auto z = static_cast<double>(point.z);
  switch (plane) {
    case ClipPlane::near:
      return z <= -1;
    case ClipPlane::left:
      return x >= slope * z;
    case ClipPlane::right:
      return x <= -slope * z;
    case ClipPlane::below:
      return y >= slope * z;
    case ClipPlane::above:
      return y <= -slope * z;
  }
  return false;
}

/// Whether a point is inside all planes.
template <Scalar N>
bool inside(const Vec3<N>& point, std::int32_t slope) {
  const auto z = static_cast<double>(point.z);
  const double reach = -slope * z;
  return z <= -1 && std::fabs(static_cast<double>(point.x)) <= reach &&
         std::fabs(static_cast<double>(point.y)) <= reach;
}

/// A corner of a polygon with values that are linear along its edges.
template <Scalar N>
struct Corner {
  Vec3<N> place{};
  /// A normal, or the column and row of a bitmap and 0.
  Vec3<N> carried{};
};

template <Scalar N>
const Vec3<N>& place_of(const Vec3<N>& point) {
  return point;
}
template <Scalar N>
const Vec3<N>& place_of(const Corner<N>& corner) {
  return corner.place;
}

template <Scalar N>
Vec3<N> between(const Vec3<N>& a, const Vec3<N>& b) {
  return {Arithmetic<N>::midpoint(a.x, b.x), Arithmetic<N>::midpoint(a.y, b.y),
          Arithmetic<N>::midpoint(a.z, b.z)};
}
template <Scalar N>
Corner<N> between(const Corner<N>& a, const Corner<N>& b) {
  return {between(a.place, b.place), between(a.carried, b.carried)};
}

/// The last point inside on the way from `in` to `out`. Bisects until the ends are neighbours: this
/// uses no product and no divide, so it works in every number type and the result is inside the
/// plane. Two polygons that share the edge get the same point.
/// @tparam Point Vec3 or Corner
template <class Point>
Point crossing(Point in, Point out, ClipPlane plane, std::int32_t slope) {
  // 16.16 has 2^32 values; for double, 40 steps are more than is visible.
  for (int halvings = 0; halvings < 40; ++halvings) {
    const Point middle = between(in, out);
    Point& end = inside(place_of(middle), plane, slope) ? in : out;
    if (place_of(end) == place_of(middle)) break;
    end = middle;
  }
  return in;
}

/// The part of a polygon in the clip volume, with the same orientation; empty if there is none. All
/// its points have z <= -1 exactly. If a plane cuts an edge that runs along a side of the volume,
/// rounding may put the new corner a few units of 2^-16 beyond that side.
template <class Point>
std::vector<Point> clip_polygon(std::span<const Point> polygon, std::int32_t slope) {
  std::vector<Point> kept(polygon.begin(), polygon.end());
  std::vector<Point> before;
  for (const ClipPlane plane : clip_planes) {
    before.swap(kept);
    kept.clear();
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Point& from = before[i];
      const Point& to = before[(i + 1) % before.size()];
      const bool starts_inside = inside(place_of(from), plane, slope);
      const bool ends_inside = inside(place_of(to), plane, slope);
      if (starts_inside) kept.push_back(from);
      if (starts_inside && !ends_inside) kept.push_back(crossing(from, to, plane, slope));
      if (!starts_inside && ends_inside) kept.push_back(crossing(to, from, plane, slope));
    }
  }
  return kept;
}

template <Scalar N>
std::vector<Vec3<N>> clip(std::span<const Vec3<N>> polygon, std::int32_t slope) {
  return clip_polygon(polygon, slope);
}

}  // namespace xsharp

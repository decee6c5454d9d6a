/// @file
/// Clipping in view space, so that no divide can fault and no projected coordinate wraps.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "xsharp/arithmetic.hpp"
#include "xsharp/project.hpp"
#include "xsharp/transform.hpp"

namespace xsharp {

/// The sides of the volume that is kept: z <= -1, and x and y within +-slope * z.
enum class ClipPlane { near, left, right, below, above };
inline constexpr std::array clip_planes{ClipPlane::near, ClipPlane::left, ClipPlane::right,
                                        ClipPlane::below, ClipPlane::above};

/// Decided in double, which holds every term exactly.
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

template <Scalar N>
bool inside(const Vec3<N>& point, std::int32_t slope) {
  for (const ClipPlane plane : clip_planes) {
    if (!inside(point, plane, slope)) return false;
  }
  return true;
}

/// The last point inside on the way from `in` to `out`, by halving the way until its ends are
/// neighbours: no product and no divide, so every number type finds a point, and one that is
/// inside this plane. Two polygons that share the edge get the same point.
template <Scalar N>
Vec3<N> crossing(Vec3<N> in, Vec3<N> out, ClipPlane plane, std::int32_t slope) {
  // 16.16 has 2^32 values; double is halved no further than is seen.
  for (int halvings = 0; halvings < 40; ++halvings) {
    const Vec3<N> middle{Arithmetic<N>::midpoint(in.x, out.x), Arithmetic<N>::midpoint(in.y, out.y),
                         Arithmetic<N>::midpoint(in.z, out.z)};
    Vec3<N>& end = inside(middle, plane, slope) ? in : out;
    if (end == middle) break;
    end = middle;
  }
  return in;
}

/// The part of a convex polygon in the clip volume, in the same sense of rotation; empty if there
/// is none. Its points are at z <= -1 exactly; where a further plane cuts an edge that runs along a
/// side of the volume, rounding may put the new corner a few units of 2^-16 beyond that side.
template <Scalar N>
std::vector<Vec3<N>> clip(std::span<const Vec3<N>> polygon, std::int32_t slope) {
  std::vector<Vec3<N>> kept(polygon.begin(), polygon.end());
  std::vector<Vec3<N>> before;
  for (const ClipPlane plane : clip_planes) {
    before.swap(kept);
    kept.clear();
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Vec3<N>& from = before[i];
      const Vec3<N>& to = before[(i + 1) % before.size()];
      const bool starts_inside = inside(from, plane, slope);
      const bool ends_inside = inside(to, plane, slope);
      if (starts_inside) kept.push_back(from);
      if (starts_inside && !ends_inside) kept.push_back(crossing(from, to, plane, slope));
      if (!starts_inside && ends_inside) kept.push_back(crossing(to, from, plane, slope));
    }
  }
  return kept;
}

}  // namespace xsharp

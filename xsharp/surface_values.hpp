/// @file
/// The values that the surface of a polygon interpolates, at its corners.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "xsharp/arithmetic.hpp"
#include "xsharp/clip.hpp"
#include "xsharp/normals.hpp"
#include "xsharp/picture.hpp"
#include "xsharp/ratio.hpp"
#include "xsharp/surface.hpp"
#include "xsharp/transform.hpp"

namespace xsharp {

/// near / distance, at most 1. @param distance positive
template <Scalar N>
N nearness(N distance, N near) {
  const N one = from_whole<N>(1);
  return distance <= near ? one : std::min(ratio(near, distance), one);
}

/// The interpolated depth: nearest_depth * near / -z, which is linear on the screen; greater is
/// nearer, at most nearest_depth.
template <Scalar N>
N depth_value(const Vec3<N>& place, N near) {
  return nearness(-place.z, near) * from_whole<N>(nearest_depth);
}

/// The depth of DepthMeasure::z: z + 32768. It is 0 for the farthest z of 16.16 and grows towards
/// the viewer. In 16 bits this equals z minus the word 8000h, minus infinity.
/// @pre z is at most -1, which clipping ensures
template <Scalar N>
N z_depth(const Vec3<N>& place) {
  return place.z + from_whole<N>(nearest_depth) + from_whole<N>(1);
}

/// The distance of a point with z <= -1 from the viewer, without a square root: its dot product
/// with the unit vector towards it.
template <Scalar N>
N distance_from_viewer(const Vec3<N>& place) {
  const N zero = from_whole<N>(0);
  const auto size = [zero](N x) { return x < zero ? -x : x; };
  const N longest = std::max({size(place.x), size(place.y), size(place.z)});
  // Halved, so that the length is from 0.5 to 0.87, where unit() is accurate.
  const auto part = [&](N x) { return ratio(Arithmetic<N>::midpoint(x, zero), longest); };
  return dot(place, unit(Vec3<N>{part(place.x), part(place.y), part(place.z)}));
}

/// Light from -1 to 1 on a surface's ramp.
template <Scalar N>
N ramp_value(N light, const Surface& surface) {
  return from_whole<N>(surface.ramp * ramp_length + ramp_dark) + light * from_whole<N>(ramp_levels);
}

/// Column and row of the bitmap at corner `i` of a face of `corners`; 1 is 256 texels. A
/// quadrilateral has the whole bitmap; the points of another face are on a circle. Both start at
/// the middle of the outermost texels, so that stepping errors do not leave the bitmap in rows of
/// up to 255 pixels; inside_bitmap() handles longer rows.
inline Triple bitmap_place(std::size_t i, std::size_t corners) {
  constexpr double first = 1.0 / 512;
  constexpr double last = 1 - first;
  if (corners == 4) return {i == 1 || i == 2 ? last : first, i >= 2 ? last : first, 0};
  const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
  constexpr double radius = 0.5 - first;
  return {0.5 + radius * std::sin(angle), 0.5 - radius * std::cos(angle), 0};
}

/// @param light its dot product with a normal is from -1 to 1
template <Scalar N>
PointValues point_values(const Surface& surface, const Corner<N>& corner, const Vec3<N>& light,
                         N near, DepthMeasure measure = DepthMeasure::inverse) {
  const N depth =
      measure == DepthMeasure::z ? z_depth(corner.place) : depth_value(corner.place, near);
  PointValues values{static_cast<double>(depth), 0, 0, 0};
  const auto on_ramp = [&](N of) {
    const N one = from_whole<N>(1);
    return static_cast<double>(ramp_value(std::clamp(of, -one, one), surface));
  };
  switch (surface.kind) {
    case SurfaceKind::flat:
      break;
    case SurfaceKind::gouraud8:
    case SurfaceKind::gouraud16:
      values[1] = on_ramp(dot(light, corner.carried));
      break;
    case SurfaceKind::depth:
      values[1] = on_ramp(nearness(-corner.place.z, near));
      break;
    case SurfaceKind::distance:
      values[1] = on_ramp(nearness(distance_from_viewer(corner.place), near));
      break;
    case SurfaceKind::environment: {
      // The normal as seen from the front: x to the right, y upward.
      const N half = Arithmetic<N>::from_raw(0x8000);
      const N radius = Arithmetic<N>::from_raw(0x8000 - 0x80);
      values[1] = static_cast<double>(half + corner.carried.x * radius);
      values[2] = static_cast<double>(half - corner.carried.y * radius);
      break;
    }
    case SurfaceKind::texture:
    case SurfaceKind::phong:
      values[1] = static_cast<double>(corner.carried.x);
      values[2] = static_cast<double>(corner.carried.y);
      values[3] = static_cast<double>(corner.carried.z);
      break;
  }
  return values;
}

}  // namespace xsharp

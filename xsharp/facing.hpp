/// @file
/// Decides which side of a screen polygon faces the viewer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "xsharp/picture.hpp"

namespace xsharp {

/// Whether a convex screen polygon shows its front: the cross product of the edges from its first
/// corner to the next and to the last is positive (y grows downward).
inline bool faces_viewer(const ScreenPoint& corner, const ScreenPoint& next,
                         const ScreenPoint& last) {
  const auto x = [&corner](const ScreenPoint& to) { return std::int64_t{to.x} - corner.x; };
  const auto y = [&corner](const ScreenPoint& to) { return std::int64_t{to.y} - corner.y; };
  return x(next) * y(last) - y(next) * x(last) > 0;
}

/// The same for a polygon with corners from clipping, whose first and last edges may have almost no
/// length: uses twice its area.
inline bool shows_front_area(std::span<const ScreenPoint> polygon) {
  std::int64_t area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ScreenPoint& a = polygon[i];
    const ScreenPoint& b = polygon[(i + 1) % polygon.size()];
    area += std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
  }
  return area > 0;
}

}  // namespace xsharp

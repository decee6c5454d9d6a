/// @file
/// Which pixels belong to a polygon, pixel by pixel, from integers that cannot overflow.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <tuple>
#include <vector>

#include "xsharp/picture.hpp"

namespace definition {

using Integer = boost::multiprecision::checked_int128_t;
using Points = std::vector<xsharp::ScreenPoint>;

/// Above 0 if c is on the side of the line from a to b on which positive y is when b is at
/// positive x of a.
inline Integer side(const xsharp::ScreenPoint& a, const xsharp::ScreenPoint& b,
                    const xsharp::ScreenPoint& c) {
  return (Integer(b.x) - a.x) * (Integer(c.y) - a.y) - (Integer(b.y) - a.y) * (Integer(c.x) - a.x);
}

/// The corners of the convex hull, each once, so that the inside has side() > 0 of every edge.
/// Fewer than three if it has no area.
inline Points hull(Points points) {
  const auto order = [](const auto& p) { return std::tuple(p.x, p.y); };
  std::sort(points.begin(), points.end(),
            [&](const auto& a, const auto& b) { return order(a) < order(b); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  const auto half = [](const auto& from, const auto& to) {
    Points chain;
    for (auto point = from; point != to; ++point) {
      while (chain.size() >= 2 && side(chain.end()[-2], chain.back(), *point) <= 0) {
        chain.pop_back();
      }
      chain.push_back(*point);
    }
    chain.pop_back();
    return chain;
  };
  Points corners = half(points.begin(), points.end());
  const Points back = half(points.rbegin(), points.rend());
  corners.insert(corners.end(), back.begin(), back.end());
  return corners;
}

/// By half planes: strictly inside of every edge, or on a left edge, or on a top edge.
inline bool belongs(const Points& hull, std::int32_t x, std::int32_t y) {
  if (hull.size() < 3) return false;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const auto& a = hull[i];
    const auto& b = hull[(i + 1) % hull.size()];
    const Integer where = side(a, b, {x, y});
    const bool left = b.y < a.y;
    const bool top = b.y == a.y && b.x > a.x;
    if (where < 0 || (where == 0 && !left && !top)) return false;
  }
  return true;
}

/// For any points: an edge that crosses the row does so at x or to the left of it, another does so
/// to the right of x.
inline bool between_crossings(const Points& points, std::int32_t x, std::int32_t y) {
  bool left = false;
  bool right = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    xsharp::ScreenPoint upper = points[i];
    xsharp::ScreenPoint lower = points[(i + 1) % points.size()];
    if (upper.y > lower.y) std::swap(upper, lower);
    if (y < upper.y || y >= lower.y) continue;
    (side(upper, lower, {x, y}) <= 0 ? left : right) = true;
  }
  return left && right;
}

}  // namespace definition

/// @file
/// Defines the pixels of a polygon one by one, with integers that cannot overflow.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "xsharp/picture.hpp"

namespace definition {

using Integer = boost::multiprecision::checked_int128_t;
using Points = std::vector<xsharp::ScreenPoint>;

/// Positive if c lies on the positive-y side of the line from a to b, for b at positive x of a.
inline Integer side(const xsharp::ScreenPoint& a, const xsharp::ScreenPoint& b,
                    const xsharp::ScreenPoint& c) {
  return (Integer(b.x) - a.x) * (Integer(c.y) - a.y) - (Integer(b.y) - a.y) * (Integer(c.x) - a.x);
}

/// The distinct corners of the convex hull, ordered so that side() > 0 inside for every edge. Fewer
/// than three if the hull has no area.
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

/// Whether the pixel is strictly inside every edge, or on a left or top edge.
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

/// Entry `index` of a chain's list, which has one entry for each row of each downward edge. The
/// entry is the ceiling of the edge's crossing plus `shift`.
inline Integer entry_of(const Points& chain, Integer index, int shift) {
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const Integer height = Integer(chain[i + 1].y) - chain[i].y;
    if (height <= 0) continue;
    if (index >= height) {
      index -= height;
      continue;
    }
    const Integer across = (Integer(chain[i + 1].x) - chain[i].x) * index;
    // Truncation is already the ceiling of a negative quotient.
    const Integer whole = across / height;
    return Integer(chain[i].x) + shift + whole + (across > whole * height ? 1 : 0);
  }
  throw std::logic_error("a chain is shorter than its polygon");
}

/// X-Sharp's rule for arbitrary points: two lists with one x per row.
inline bool in_lists(const Points& points, std::int32_t x, std::int32_t y) {
  if (points.size() < 3) return false;
  const auto count = static_cast<std::ptrdiff_t>(points.size());
  const auto at = [&](std::ptrdiff_t i) {
    return points[static_cast<std::size_t>((i % count + count) % count)];
  };
  const auto [highest, lowest] = std::ranges::minmax(points, {}, &xsharp::ScreenPoint::y);
  if (highest.y == lowest.y) return false;
  const auto place = [&](std::int32_t row) {
    return std::ranges::find(points, row, &xsharp::ScreenPoint::y) - points.begin();
  };
  std::ptrdiff_t first = place(highest.y);
  std::ptrdiff_t last = first;
  while (at(first - 1).y == highest.y) --first;
  while (at(last + 1).y == highest.y) ++last;
  const bool flat = at(first).x != at(last).x;
  bool swapped = at(first).x > at(last).x;
  // The turn from the next point via the top to the previous one decides which chain is left.
  if (!flat) swapped = side(at(first), at(last + 1), at(first - 1)) < 0;

  Points backward{at(first)};
  for (std::ptrdiff_t i = first;;) {
    --i;
    backward.push_back(at(i));
    if ((i % count + count) % count == place(lowest.y)) break;
  }
  Points forward{at(last)};
  for (std::ptrdiff_t i = last;;) {
    ++i;
    forward.push_back(at(i));
    if (i % count == place(lowest.y)) break;
  }
  const Points& left = swapped ? forward : backward;
  const Points& right = swapped ? backward : forward;
  const Integer rows = Integer(lowest.y) - highest.y - 1 + (flat ? 1 : 0);
  const Integer row = Integer(y) - highest.y - (flat ? 0 : 1);
  if (row < 0 || row >= rows) return false;
  const Integer entry = row + (flat ? 0 : 1);
  return entry_of(left, entry, 0) <= x && x <= entry_of(right, entry, -1);
}

}  // namespace definition

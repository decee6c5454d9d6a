/// @file
/// Fills convex polygons into a page.
///
/// A row y is crossed by the edges whose upper end is at or above it and whose lower end is below
/// it. A pixel (x, y) belongs to the polygon if x is at or to the right of the leftmost of these
/// crossings and to the left of the rightmost, as exact rationals: left edges and what is on them
/// belong to it, right edges do not; its topmost row does, its bottommost does not. So polygons
/// that share an edge and lie on different sides of it have every pixel along it exactly once.
///
/// The order of the points, either way round, changes nothing. What has no area has no pixels. A
/// polygon that rounding to pixels has made slightly concave is filled between its outermost edges.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "xsharp/picture.hpp"
#include "xsharp/raster/edge.hpp"
#include "xsharp/raster/page.hpp"

namespace xsharp {

/// Keeps the ends of rows between polygons, so that filling does not allocate.
class Filler {
 public:
  /// Sets the polygon's pixels that are on the page; returns how many. Time grows with the rows of
  /// the page that the polygon's edges cross and the pixels set, not with what is off the page.
  template <PixelType Pixel>
  std::int64_t fill(Page<Pixel>& page, std::span<const ScreenPoint> points, Pixel pixel) {
    if (!find_rows(points, page.width(), page.height())) return 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      cross(points[i], points[i + 1 == points.size() ? 0 : i + 1]);
    }
    return paint(page, pixel);
  }

 private:
  struct Ends {
    std::int64_t left = std::numeric_limits<std::int64_t>::max();
    std::int64_t right = std::numeric_limits<std::int64_t>::min();
  };

  /// Sets top_, bottom_ and ends_ to the polygon's rows on the page. False if it cannot have
  /// pixels.
  bool find_rows(std::span<const ScreenPoint> points, std::int32_t width, std::int32_t height) {
    if (points.size() < 3) return false;
    ScreenPoint least = points.front();
    ScreenPoint most = least;
    for (const ScreenPoint& point : points) {
      least = {std::min(least.x, point.x), std::min(least.y, point.y)};
      most = {std::max(most.x, point.x), std::max(most.y, point.y)};
    }
    top_ = std::max(least.y, 0);
    bottom_ = std::min(most.y, height);
    if (top_ >= bottom_ || least.x >= width || most.x <= 0) return false;
    ends_.assign(static_cast<std::size_t>(bottom_ - top_), Ends{});
    return true;
  }

  /// Widens the rows that the edge between the two points crosses.
  void cross(const ScreenPoint& one, const ScreenPoint& other) {
    const ScreenPoint& upper = one.y < other.y ? one : other;
    const ScreenPoint& lower = one.y < other.y ? other : one;
    const std::int32_t first = std::max(upper.y, top_);
    const std::int32_t end = std::min(lower.y, bottom_);
    if (first >= end) return;
    EdgeWalk edge(upper, lower, first);
    const auto rows = std::span(ends_).subspan(static_cast<std::size_t>(first - top_),
                                               static_cast<std::size_t>(end - first));
    for (Ends& row : rows) {
      row.left = std::min(row.left, edge.x());
      row.right = std::max(row.right, edge.x());
      edge.step_down();
    }
  }

  template <PixelType Pixel>
  std::int64_t paint(Page<Pixel>& page, Pixel pixel) const {
    std::int64_t painted = 0;
    const std::int64_t width = page.width();
    const auto stride = static_cast<std::size_t>(width);
    const auto pixels =
        page.pixels().subspan(static_cast<std::size_t>(top_) * stride, ends_.size() * stride);
    for (std::size_t row = 0; row < ends_.size(); ++row) {
      const std::int64_t left = std::max(ends_[row].left, std::int64_t{0});
      const std::int64_t right = std::min(ends_[row].right, width);
      if (left >= right) continue;
      const auto start = pixels.begin() + (static_cast<std::ptrdiff_t>(row) * width + left);
      std::fill(start, start + (right - left), pixel);
      painted += right - left;
    }
    return painted;
  }

  std::int32_t top_ = 0;
  std::int32_t bottom_ = 0;
  std::vector<Ends> ends_;
};

}  // namespace xsharp

/// @file
/// A row of a polygon, exactly, and how far stepping may be from it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "tests/surfaces/strip.hpp"
#include "xsharp/picture.hpp"

namespace surfaces {

/// From edge to edge, in double.
struct PolygonRow {
  double left = 0;
  double right = 0;
  xsharp::PointValues from{};
  xsharp::PointValues to{};
  double rows = 0;  ///< that the edges go down to here, the longer of the two

  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double at(std::size_t value, double x) const {
    return from[value] + (to[value] - from[value]) * (x - left) / width();
  }
  /// Pixels of a page: from first() up to, but not including, end().
  [[nodiscard]] std::int32_t first() const {
    return static_cast<std::int32_t>(std::max(std::ceil(left), 0.0));
  }
  [[nodiscard]] std::int32_t end(std::int32_t page_width) const {
    return std::min(static_cast<std::int32_t>(std::ceil(right)), page_width);
  }
};

/// Nothing where no edge crosses the row.
inline std::optional<PolygonRow> row_of(const xsharp::Picture& picture,
                                        const xsharp::Polygon& polygon, std::int32_t y) {
  const auto points = picture.points_of(polygon);
  const auto values = picture.values_of(polygon);
  std::optional<PolygonRow> row;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t next = (i + 1) % points.size();
    const std::size_t upper = points[i].y < points[next].y ? i : next;
    const std::size_t lower = upper == i ? next : i;
    if (y < points[upper].y || y >= points[lower].y) continue;
    const double rows = y - points[upper].y;
    const double height = points[lower].y - points[upper].y;
    const double part = rows / height;
    // The product first: a whole crossing stays whole.
    const double x = points[upper].x + (points[lower].x - points[upper].x) * rows / height;
    xsharp::PointValues there{};
    for (std::size_t k = 0; k < there.size(); ++k) {
      there[k] = values[upper][k] + (values[lower][k] - values[upper][k]) * part;
    }
    if (!row) row = PolygonRow{x, x, there, there, 0};
    row->rows = std::max(row->rows, rows);
    if (x < row->left) {
      row->left = x;
      row->from = there;
    }
    if (x > row->right) {
      row->right = x;
      row->to = there;
    }
  }
  return row;
}

/// By how much a value may be off at pixel x where divides and multiplies are rounded (step.hpp):
/// - half a unit a row: the edges' slopes, whose whole distances make no error in the product;
/// - the ends are cut to 2^-16 pixels, which moves x by that part of the row's way at most;
/// - half a unit a pixel from the end on, the row's slope, and half a unit, the product that goes
///   to the first centre. In a row narrower than a pixel it is half a unit of its way instead;
/// - start and slope become the nearest words, if these have fewer bits after the point.
inline double stepping_error(const PolygonRow& row, std::size_t value, std::int32_t x,
                             double last_bit) {
  const double edges = row.rows / 2 * ulp;
  const double way = std::fabs(row.to[value] - row.from[value]) + 2 * edges;
  const double cut = row.width() > 2 * ulp ? way * ulp / (row.width() - ulp) : way;
  const double narrow = row.width() < 1 + ulp ? way : 0;
  const double slope = std::max(x - row.left, narrow) / 2 * ulp;
  const double word = last_bit > ulp ? (x - row.first() + 1) * last_bit / 2 : 0;
  return edges + cut + slope + ulp / 2 + word;
}

}  // namespace surfaces

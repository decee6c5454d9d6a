/// @file
/// An exact polygon row and the error bound of stepping along it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "tests/xsharp/surfaces/strip.hpp"
#include "xsharp/picture.hpp"

namespace surfaces {

/// A row of a polygon from edge to edge, in double.
struct PolygonRow {
  double left = 0;
  double right = 0;
  xsharp::PointValues from{};
  xsharp::PointValues to{};
  double rows = 0;  ///< rows from the top of the longer edge to this row

  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double at(std::size_t value, double x) const {
    return from[value] + (to[value] - from[value]) * (x - left) / width();
  }
  /// The page pixels of the row run from first() up to, but not including, end().
  [[nodiscard]] std::int32_t first() const {
    return static_cast<std::int32_t>(std::max(std::ceil(left), 0.0));
  }
  [[nodiscard]] std::int32_t end(std::int32_t page_width) const {
    return std::min(static_cast<std::int32_t>(std::ceil(right)), page_width);
  }
};

/// Returns nothing if no edge crosses the row.
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
    // Multiplying first keeps a whole-number crossing exact.
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

/// The error bound of a value at pixel x when divides and multiplies round (step.hpp). It adds:
/// - Half a unit per row from the edges' slopes. The products of whole distances are exact.
/// - Truncation of the ends to 2^-16 pixels, which moves x by at most that part of the row's
///   change.
/// - Half a unit per pixel from the row's slope, and half a unit from the product for the first
///   centre. In a row narrower than a pixel, it is half a unit of the row's change instead.
/// - Rounding of start and slope to the nearest words, if these have fewer fraction bits.
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

/// @file
/// The rows of a polygon, with the values that are stepped along its edges.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "xsharp/picture.hpp"
#include "xsharp/raster/chains.hpp"
#include "xsharp/raster/edge.hpp"
#include "xsharp/raster/pixel_row.hpp"
#include "xsharp/raster/step.hpp"
#include "xsharp/surface.hpp"

namespace xsharp {

template <Scalar N>
class SteppedRows {
 public:
  using Steps = std::array<Step<N>, 4>;

  /// A value of a picture in 16.16, to nearest.
  static N number(double value) {
    return Arithmetic<N>::from_raw(raw_constant(value, Conversion::nearest));
  }

  /// Finds the polygon's rows on a page and steps its values along its edges.
  /// @param buffered whether depths are stepped for a depth buffer
  std::span<const PixelRow> find(const Picture& picture, const Polygon& polygon,
                                 const Surface& surface, bool buffered, std::int32_t width,
                                 std::int32_t height) {
    rows_.clear();
    const auto points = picture.points_of(polygon);
    const Chains chains(points);
    top_ = chains.first();
    const std::int32_t bottom = chains.end(height);
    if (top_ >= bottom) return rows_;
    choose_slots(surface, buffered);
    ends_.resize(static_cast<std::size_t>(bottom - top_));
    corners_.clear();
    for (const PointValues& values : picture.values_of(polygon)) {
      corners_.push_back(corner(values, surface));
    }
    chains.walk(
        height, [&](const ChainEdge& edge) { cross(points, edge, &Ends::left); },
        [&](const ChainEdge& edge) { cross(points, edge, &Ends::right); });
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const auto left = std::max<std::int64_t>(first_pixel(ends_[i].left), 0);
      const auto right = std::min<std::int64_t>(first_pixel(ends_[i].right), width);
      if (left >= right) continue;
      rows_.push_back({top_ + static_cast<std::int32_t>(i), static_cast<std::int32_t>(left),
                       static_cast<std::int32_t>(right)});
    }
    return rows_;
  }

  [[nodiscard]] const PixelRow& row(std::size_t index) const { return rows_[index]; }

  /// The steps along a row.
  [[nodiscard]] Steps steps(std::size_t index) const {
    const PixelRow& row = rows_[index];
    const Ends& ends = ends_[static_cast<std::size_t>(row.y - top_)];
    const std::int64_t units = ends.right.units - ends.left.units;
    const std::int64_t distance = std::int64_t{row.left} * 65536 - ends.left.units;
    Steps steps{};
    for (std::size_t k = first_slot_; k < end_slot_; ++k) {
      steps[k] = step_across(ends.left.values[k], ends.right.values[k], units, distance);
    }
    return steps;
  }

 private:
  /// The crossing of an edge with a row, in 2^-16 pixels, and the values there.
  struct Crossing {
    std::int64_t units = 0;
    std::array<N, 4> values{};
  };
  struct Ends {
    Crossing left{};
    Crossing right{};
  };

  /// Selects which of a point's four values are stepped.
  void choose_slots(const Surface& surface, bool buffered) {
    first_slot_ = buffered || in_perspective(surface) ? 0 : 1;
    end_slot_ = surface.kind == SurfaceKind::flat    ? 1
                : has_bitmap(surface)                ? 3
                : surface.kind == SurfaceKind::phong ? 4
                                                     : 2;
  }

  /// The stepped values of a corner. In perspective, bitmap coordinates are multiplied by depth,
  /// which makes them linear on the screen.
  static std::array<N, 4> corner(const PointValues& values, const Surface& surface) {
    std::array<N, 4> numbers{number(values[0]), number(values[1]), number(values[2]),
                             number(values[3])};
    if (in_perspective(surface)) {
      numbers[1] = numbers[1] * numbers[0];
      numbers[2] = numbers[2] * numbers[0];
    }
    return numbers;
  }

  static std::int64_t first_pixel(const Crossing& crossing) {
    return (crossing.units + 65535) >> 16;
  }

  /// Stores an edge's crossings as one end of the rows that it yields.
  void cross(std::span<const ScreenPoint> points, const ChainEdge& edge, Crossing Ends::*end) {
    const ScreenPoint& upper = points[edge.upper];
    const ScreenPoint& lower = points[edge.lower];
    EdgeWalk walk(upper, lower, edge.y);
    const std::int64_t length = (std::int64_t{lower.y} - upper.y) * 65536;
    const std::int64_t skipped = (std::int64_t{edge.y} - upper.y) * 65536;
    const std::array<N, 4>& from = corners_[edge.upper];
    std::array<N, 4> values = from;
    std::array<N, 4> slopes{};
    for (std::size_t k = first_slot_; k < end_slot_; ++k) {
      slopes[k] = slope(from[k], corners_[edge.lower][k], length);
      if (skipped != 0) values[k] = from[k] + slopes[k] * distance_of<N>(skipped);
    }
    for (std::int32_t row = edge.first; row < edge.end; ++row) {
      ends_[static_cast<std::size_t>(row - top_)].*
          end = {walk.x() * 65536 - walk.to_the_left(), values};
      walk.step_down();
      for (std::size_t k = first_slot_; k < end_slot_; ++k) values[k] = values[k] + slopes[k];
    }
  }

  std::size_t first_slot_ = 0;
  std::size_t end_slot_ = 0;
  std::int32_t top_ = 0;
  std::vector<std::array<N, 4>> corners_{};
  std::vector<Ends> ends_{};
  std::vector<PixelRow> rows_{};
};

}  // namespace xsharp

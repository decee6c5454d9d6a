/// @file
/// The output of the pipeline: polygons on the screen, in drawing order. Rounding to pixels may
/// have made a polygon concave or self-crossing.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace xsharp {

/// A pixel, with the origin at the top left and y downward. May be off the page.
struct ScreenPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend bool operator==(const ScreenPoint&, const ScreenPoint&) = default;
};

/// Components from 0 to 255.
struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  friend bool operator==(const Color&, const Color&) = default;
};

/// The fill of a polygon: a palette index, or a colour. A page with a palette looks up the index of
/// a colour.
struct Paint {
  bool is_index = true;
  std::uint8_t index = 0;
  Color color{};

  friend bool operator==(const Paint&, const Paint&) = default;
};

/// A polygon of a Picture, as a range of its points.
struct Polygon {
  std::uint32_t object = 0;  ///< index of the object in the scene
  std::uint32_t first = 0;
  std::uint32_t points = 0;
  Paint paint{};
};

/// Values interpolated between points: the depth, then those of the object's surface: a palette
/// index, column and row of a bitmap (1 is 256 texels), or a normal. Double holds 16.16 exactly.
using PointValues = std::array<double, 4>;

/// Polygons in drawing order: later ones cover earlier ones.
struct Picture {
  std::vector<ScreenPoint> points;
  std::vector<Polygon> polygons;
  /// Empty if nothing is interpolated, otherwise one entry per point.
  std::vector<PointValues> values{};
  /// The light for pixels, in view space: its dot product with a normal is from -1 to 1.
  std::array<double, 3> light{};

  /// The values of a polygon. @pre the picture has values
  [[nodiscard]] std::span<const PointValues> values_of(const Polygon& polygon) const {
    return std::span(values).subspan(polygon.first, polygon.points);
  }

  [[nodiscard]] std::span<const ScreenPoint> points_of(const Polygon& polygon) const {
    return std::span(points).subspan(polygon.first, polygon.points);
  }

  /// Appends the polygons of another picture, in front of the existing ones.
  void add(const Picture& other) {
    const auto before = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), other.points.begin(), other.points.end());
    if (!other.values.empty()) {
      // Either picture may lack the values of its last objects, if these have none.
      values.resize(before);
      values.insert(values.end(), other.values.begin(), other.values.end());
    }
    for (Polygon polygon : other.polygons) {
      polygon.first += before;
      polygons.push_back(polygon);
    }
  }

  void clear() {
    points.clear();
    polygons.clear();
    values.clear();
  }
};

}  // namespace xsharp

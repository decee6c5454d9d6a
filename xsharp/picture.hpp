/// @file
/// What the pipeline ends in: convex polygons on the screen, in drawing order.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace xsharp {

/// A pixel: origin top left, y grows downward. Not necessarily on the page.
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

/// What a polygon is filled with: an index of the palette, or a colour, for which a page with a
/// palette finds the index.
struct Paint {
  bool is_index = true;
  std::uint8_t index = 0;
  Color color{};

  friend bool operator==(const Paint&, const Paint&) = default;
};

/// A convex polygon among the points of a Picture.
struct Polygon {
  std::uint32_t object = 0;  ///< of which object, by its index in the scene
  std::uint32_t first = 0;
  std::uint32_t points = 0;
  Paint paint{};
};

/// What is interpolated between points: the depth, then what the surface of the polygon's object
/// needs: an index of the palette, columns and rows of a bitmap (1 is 256 texels), or a normal.
/// Numbers in 16.16 are exact in double.
using PointValues = std::array<double, 4>;

/// Polygons in drawing order: later ones cover earlier ones.
struct Picture {
  std::vector<ScreenPoint> points;
  std::vector<Polygon> polygons;
  /// Empty where nothing is interpolated, else one for each point.
  std::vector<PointValues> values{};
  /// The light for pixels, in view space: a normal times it is from -1 to 1.
  std::array<double, 3> light{};

  /// Of a picture that has values.
  [[nodiscard]] std::span<const PointValues> values_of(const Polygon& polygon) const {
    return std::span(values).subspan(polygon.first, polygon.points);
  }

  [[nodiscard]] std::span<const ScreenPoint> points_of(const Polygon& polygon) const {
    return std::span(points).subspan(polygon.first, polygon.points);
  }

  /// Adds the polygons of another picture, in front of its own.
  void add(const Picture& other) {
    const auto before = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), other.points.begin(), other.points.end());
    if (!other.values.empty()) {
      // Those of the last objects of either may be missing, if these have none.
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

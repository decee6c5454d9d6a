/// @file
/// What the pipeline ends in: convex polygons on the screen, in drawing order.
#pragma once

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

/// Polygons in drawing order: later ones cover earlier ones.
struct Picture {
  std::vector<ScreenPoint> points;
  std::vector<Polygon> polygons;

  [[nodiscard]] std::span<const ScreenPoint> points_of(const Polygon& polygon) const {
    return std::span(points).subspan(polygon.first, polygon.points);
  }

  /// Adds the polygons of another picture, in front of its own.
  void add(const Picture& other) {
    const auto before = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), other.points.begin(), other.points.end());
    for (Polygon polygon : other.polygons) {
      polygon.first += before;
      polygons.push_back(polygon);
    }
  }

  void clear() {
    points.clear();
    polygons.clear();
  }
};

}  // namespace xsharp

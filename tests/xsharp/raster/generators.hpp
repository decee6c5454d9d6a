/// @file
/// Random points, convex polygons and pictures.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "tests/xsharp/raster/definition.hpp"
#include "xsharp/picture.hpp"

namespace generators {

using definition::Points;

/// Uniform values from `least` up to, but not including, `end`, from the first case on.
template <class T>
rc::Gen<T> among(T least, T end) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange<T>(least, end));
}

inline rc::Gen<xsharp::ScreenPoint> point(const rc::Gen<std::int32_t>& coordinate) {
  return rc::gen::map(rc::gen::pair(coordinate, coordinate), [](const auto& place) {
    return xsharp::ScreenPoint{place.first, place.second};
  });
}

/// Coordinates around a page of about 30 x 20.
inline rc::Gen<std::int32_t> small() { return among<std::int32_t>(-12, 44); }

/// Range ends and values near them, values near a page, and arbitrary values.
inline rc::Gen<std::int32_t> extreme() {
  constexpr std::int32_t least = std::numeric_limits<std::int32_t>::min();
  constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
  return rc::gen::oneOf(
      rc::gen::element(std::int32_t{least}, least + 1, least / 2, -65536, -1, 0, 1, 7, 32767, 65536,
                       most / 2, most - 1, std::int32_t{most}),
      among<std::int32_t>(-5, 20), among<std::int32_t>(least, most));
}

inline Points some(const rc::Gen<std::int32_t>& coordinate, std::size_t least, std::size_t most) {
  const auto count = *among<std::size_t>(least, most + 1);
  return *rc::gen::container<Points>(count, point(coordinate));
}

/// A convex polygon whose points start at any corner, in either direction, with repeated corners
/// and points on edges.
struct Convex {
  Points corners;  ///< in the order of hull()
  Points points;
};

inline Convex convex(const rc::Gen<std::int32_t>& coordinate) {
  Convex polygon{definition::hull(some(coordinate, 3, 9)), {}};
  const std::size_t count = polygon.corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto& corner = polygon.corners[i];
    const auto& next = polygon.corners[(i + 1) % count];
    polygon.points.push_back(corner);
    if (*among(0, 6) == 0) polygon.points.push_back(corner);
    const std::int64_t x = std::int64_t{corner.x} + next.x;
    const std::int64_t y = std::int64_t{corner.y} + next.y;
    if (x % 2 == 0 && y % 2 == 0) {
      polygon.points.push_back(
          {static_cast<std::int32_t>(x / 2), static_cast<std::int32_t>(y / 2)});
    }
  }
  if (!polygon.points.empty()) {
    const auto start = *among<std::ptrdiff_t>(0, std::ssize(polygon.points));
    std::rotate(polygon.points.begin(), polygon.points.begin() + start, polygon.points.end());
  }
  if (*rc::gen::arbitrary<bool>()) std::reverse(polygon.points.begin(), polygon.points.end());
  return polygon;
}

inline xsharp::Paint paint() {
  const auto byte = rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint8_t>());
  return {.is_index = *rc::gen::arbitrary<bool>(), .index = *byte, .color = {*byte, *byte, *byte}};
}

/// Up to four objects of up to three polygons. The polygons of an object need not be consecutive,
/// and some have no area.
inline xsharp::Picture picture() {
  xsharp::Picture picture;
  const int polygons = *among(0, 8);
  for (int i = 0; i < polygons; ++i) {
    const Points points = some(small(), 0, 5);
    picture.polygons.push_back({.object = *among<std::uint32_t>(0, 4),
                                .first = static_cast<std::uint32_t>(picture.points.size()),
                                .points = static_cast<std::uint32_t>(points.size()),
                                .paint = paint()});
    picture.points.insert(picture.points.end(), points.begin(), points.end());
  }
  return picture;
}

}  // namespace generators

/// @file
/// Scenes for tests, and their drawn pixels.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "xsharp/animation.hpp"
#include "xsharp/raster/fill.hpp"
#include "xsharp/raster/page.hpp"
#include "xsharp/shapes.hpp"

namespace pipeline {

/// A body whose faces have consecutive indices from `first` on.
inline xsharp::ObjectDescription body(xsharp::Mesh mesh, const xsharp::Triple& position,
                                      std::uint8_t first = 1) {
  xsharp::ObjectDescription object;
  object.mesh = std::move(mesh);
  object.position = position;
  for (std::size_t face = 0; face < object.mesh.faces.size(); ++face) {
    object.paints.push_back({true, static_cast<std::uint8_t>(first + face), {}});
  }
  return object;
}

inline xsharp::ObjectDescription plain_body(xsharp::Mesh mesh, const xsharp::Triple& position,
                                            std::uint8_t index) {
  xsharp::ObjectDescription object = body(std::move(mesh), position);
  for (xsharp::Paint& paint : object.paints) paint.index = index;
  return object;
}

/// A cube stretched to these half edges.
inline xsharp::Mesh box(const xsharp::Triple& half) {
  xsharp::Mesh mesh = xsharp::cube(1);
  for (xsharp::Triple& vertex : mesh.vertices) {
    for (std::size_t i = 0; i < 3; ++i) vertex[i] *= half[i];
  }
  return mesh;
}

/// A square scene with background index 0.
inline xsharp::Scene scene(std::int32_t side, std::vector<xsharp::ObjectDescription> objects) {
  xsharp::Scene scene;
  scene.width = side;
  scene.height = side;
  scene.conversion = xsharp::Conversion::nearest;
  scene.objects = std::move(objects);
  return scene;
}

using Mask = xsharp::Page<std::uint8_t>;

inline Mask drawn(const xsharp::Picture& picture, std::int32_t side) {
  Mask page(side, side);
  xsharp::Filler filler;
  for (const xsharp::Polygon& polygon : picture.polygons) {
    filler.fill<std::uint8_t>(page, picture.points_of(polygon), polygon.paint.index);
  }
  return page;
}

inline Mask times_covered(const xsharp::Picture& picture, std::int32_t side) {
  Mask times(side, side);
  xsharp::Filler filler;
  for (const xsharp::Polygon& polygon : picture.polygons) {
    Mask one(side, side);
    filler.fill<std::uint8_t>(one, picture.points_of(polygon), 1);
    std::transform(times.pixels().begin(), times.pixels().end(), one.pixels().begin(),
                   times.pixels().begin(),
                   [](auto a, auto b) { return static_cast<std::uint8_t>(a + b); });
  }
  return times;
}

inline std::ptrdiff_t pixels(const Mask& page, std::uint8_t value) {
  return std::count(page.pixels().begin(), page.pixels().end(), value);
}

}  // namespace pipeline

/// @file
/// Computed meshes: the cube as chapter 52 prints it, and a ball. Chapter 53 says that its ball has
/// 72 faces in bands, and that radius and bands can be chosen, but does not print the generator.
/// Faces and vertices are in the order that the original program's pictures show.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "xsharp/mesh.hpp"

namespace xsharp {

/// The cube of chapter 52 about the origin. The order of vertices and faces and the first vertex of
/// each face are the published ones, so face colours and products of edges match.
[[nodiscard]] inline Mesh cube(double half_edge) {
  const double h = half_edge;
  return {{{h, h, h},
           {h, h, -h},
           {h, -h, h},
           {h, -h, -h},
           {-h, h, h},
           {-h, h, -h},
           {-h, -h, h},
           {-h, -h, -h}},
          {{{1, 3, 2, 0}},
           {{5, 7, 3, 1}},
           {{4, 5, 1, 0}},
           {{3, 7, 6, 2}},
           {{5, 4, 6, 7}},
           {{0, 2, 6, 4}}}};
}

/// The maximum number of bands of a ball; one more would exceed the face limit of a scene.
inline constexpr int max_bands = 45;

/// A ball about the origin: `bands` of equal latitude from the pole at +y to that at -y, with 2 *
/// bands faces each. Faces are ordered by band, and within a band in a full turn from -x towards
/// +z, as in X-Sharp. Those at the poles are triangles, the others flat trapezoids. The vertices
/// are the pole at +y, the circles between bands downward, and the pole at -y.
/// @throws std::invalid_argument unless there are 2 to max_bands bands
[[nodiscard]] inline Mesh ball(double radius, int bands) {
  if (bands < 2 || bands > max_bands) throw std::invalid_argument("a ball has 2 to 45 bands");
  const auto latitudes = static_cast<std::size_t>(bands);
  const std::size_t meridians = 2 * latitudes;
  const double step = std::numbers::pi / bands;

  Mesh mesh;
  mesh.computed = true;
  mesh.vertices.push_back({0, radius, 0});
  for (int circle = 1; circle < bands; ++circle) {
    const double y = radius * std::cos(circle * step);
    const double around = radius * std::sin(circle * step);
    for (int meridian = 0; meridian < 2 * bands; ++meridian) {
      mesh.vertices.push_back(
          {-around * std::cos(meridian * step), y, around * std::sin(meridian * step)});
    }
  }
  mesh.vertices.push_back({0, -radius, 0});

  const auto on_circle = [&](std::size_t circle, std::size_t meridian) {
    return 1 + (circle - 1) * meridians + meridian % meridians;
  };
  for (std::size_t band = 0; band < latitudes; ++band) {
    for (std::size_t east = 1; east <= meridians; ++east) {
      const std::size_t west = east - 1;
      std::vector<std::size_t> face;
      if (band == 0) {
        face = {0, on_circle(1, east), on_circle(1, west)};
      } else if (band + 1 == latitudes) {
        face = {on_circle(band, west), on_circle(band, east), mesh.vertices.size() - 1};
      } else {
        face = {on_circle(band, west), on_circle(band, east), on_circle(band + 1, east),
                on_circle(band + 1, west)};
      }
      mesh.faces.push_back({std::move(face), std::nullopt});
    }
  }
  return mesh;
}

/// The same body prepared for diffuse light (chapter 54): appends, for each face that needs it, the
/// end of the outward unit normal that starts at the face's first vertex. A face without area gets
/// a normal without length, which validate() rejects.
/// @param needs_normal takes the index of a face
/// @pre the indices of faces are valid
template <std::predicate<std::size_t> NeedsNormal>
[[nodiscard]] Mesh with_normals(Mesh mesh, const NeedsNormal& needs_normal) {
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    Face& face = mesh.faces[i];
    if (face.vertices.empty() || !needs_normal(i)) continue;
    const Triple area = outward_area(mesh, face);
    const double size = length(area);
    const Triple unit = size > 0 ? scaled(area, 1 / size) : Triple{};
    face.normal_end = mesh.vertices.size();
    mesh.vertices.push_back(sum(mesh.vertices[face.vertices[0]], unit));
  }
  return mesh;
}

/// The same, with a normal for every face.
[[nodiscard]] inline Mesh with_normals(Mesh mesh) {
  return with_normals(std::move(mesh), [](std::size_t) { return true; });
}

}  // namespace xsharp

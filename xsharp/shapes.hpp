/// @file
/// Bodies that are computed: the cube as chapter 52 prints it, and a ball. Chapter 53 says that its
/// ball has 72 faces in bands, and that radius and bands can be chosen. It does not print the
/// generator. Faces and vertices are in the order that the original program's pictures show.
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

/// The cube of chapter 52 about the origin: its order of vertices, its faces and where they begin,
/// so that colours of faces and products of edges are the published ones.
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

/// Of a ball; with one more it would have more faces than a scene may have.
inline constexpr int most_bands = 45;

/// A ball about the origin: `bands` of equal latitude from the pole at +y to that at -y, each of
/// 2 * bands faces. The faces come band by band, and within a band in the order of a full turn from
/// -x towards +z, as in X-Sharp. Those at the poles are triangles, the others flat trapezoids.
/// Vertices: the pole at +y, the circles between bands downward, the pole at -y.
/// @throws std::invalid_argument unless there are 2 to most_bands bands
[[nodiscard]] inline Mesh ball(double radius, int bands) {
  if (bands < 2 || bands > most_bands) throw std::invalid_argument("a ball has 2 to 45 bands");
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

/// The same body ready for diffuse light (chapter 54): behind its vertices, for each face that
/// needs one, the end of the unit normal that starts at the face's first vertex and points out of
/// the body. A face without area gets a normal without length, which validate() refuses.
/// @param needs_normal of the index of a face
/// @pre the indices of faces are those of vertices
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

/// With a normal for every face.
[[nodiscard]] inline Mesh with_normals(Mesh mesh) {
  return with_normals(std::move(mesh), [](std::size_t) { return true; });
}

}  // namespace xsharp

/// @file
/// A mesh: vertices and faces in object space.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "xsharp/triple.hpp"

namespace xsharp {

/// The maximum number of vertices of a face.
inline constexpr std::size_t max_polygon_vertices = 16;

/// A convex polygon whose vertices run clockwise seen from outside, in a right-handed object space.
/// It is visible if the screen-space cross product of (vertex 1 - vertex 0) and (last vertex -
/// vertex 0) is positive, with y down.
struct Face {
  std::vector<std::size_t> vertices;
  /// The vertex at the end of the unit normal that starts at vertices[0]; required for shaded
  /// faces.
  std::optional<std::size_t> normal_end{};
};

/// Faces and their vertices, which include the ends of normals. Vertices after the last one that a
/// face uses are transformed, but not projected.
struct Mesh {
  std::vector<Triple> vertices;
  std::vector<Face> faces;
  /// Empty, or for each vertex of a face the vertex at the end of its unit normal.
  std::vector<std::size_t> vertex_normal_ends{};
  /// Whether the vertices were computed in double. If so, whole coordinates go through the scene's
  /// Conversion like all others; typed-in whole coordinates are exact.
  bool computed = false;
};

/// Twice the area of a face, as a vector normal to it that points out of the body.
/// @pre the indices of the face are valid
[[nodiscard]] inline Triple outward_area(const Mesh& mesh, const Face& face) {
  Triple area{};
  // Relative to the first vertex: far from the origin, products of coordinates would lose the area.
  const Triple first = face.vertices.empty() ? Triple{} : mesh.vertices[face.vertices[0]];
  for (std::size_t i = 2; i < face.vertices.size(); ++i) {
    area = sum(area, cross(difference(mesh.vertices[face.vertices[i]], first),
                           difference(mesh.vertices[face.vertices[i - 1]], first)));
  }
  return area;
}

}  // namespace xsharp

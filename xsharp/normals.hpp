/// @file
/// Vertex normals, and normalisation of vectors.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <utility>

#include "xsharp/arithmetic.hpp"
#include "xsharp/mesh.hpp"
#include "xsharp/transform.hpp"

namespace xsharp {

/// The same body with vertex normals: appends for each vertex the end of the unit normal that
/// starts there, which is transformed like a vertex. A vertex normal is the mean of the normals of
/// its faces, each counted once. If they cancel out, or there is no face, the end is the vertex.
/// @pre the indices of faces are valid
[[nodiscard]] inline Mesh with_vertex_normals(Mesh mesh) {
  std::vector<Triple> normals(mesh.vertices.size());
  for (const Face& face : mesh.faces) {
    const Triple area = outward_area(mesh, face);
    const double size = length(area);
    if (!(size > 0)) continue;
    for (const std::size_t v : face.vertices) {
      normals[v] = sum(normals[v], scaled(area, 1 / size));
    }
  }
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const double size = length(normals[v]);
    mesh.vertex_normal_ends.push_back(mesh.vertices.size());
    // If the normals cancel out, the direction of the remainder is arbitrary.
    const double scale = size > 1e-6 ? 1 / size : 0;
    mesh.vertices.push_back(sum(mesh.vertices[v], scaled(normals[v], scale)));
  }
  return mesh;
}

/// Normalises a vector of length 0.5 to 1.5 by Newton steps towards 1 / |v|. Uses only products,
/// because an arithmetic's divide may use only a part of its divisor. Stops within four units of
/// 2^-16 of 1 in the square, or after eight steps. A shorter vector comes as near as it can. In
/// floating point, any length becomes 1 and 0 stays 0.
template <Scalar N>
Vec3<N> unit(Vec3<N> v) {
  if constexpr (std::floating_point<N>) {
    const N size = std::hypot(v.x, v.y, v.z);
    return size > 0 ? v * (1 / size) : v;
  } else {
    const N three = from_whole<N>(3);
    const N half = Arithmetic<N>::from_raw(0x8000);
    const N least = Arithmetic<N>::from_raw(0xFFFC);
    const N most = Arithmetic<N>::from_raw(0x10004);
    for (int steps = 0; steps < 8; ++steps) {
      const N square = dot(v, v);
      if (least <= square && square <= most) break;
      v = v * ((three - square) * half);
    }
    return v;
  }
}

}  // namespace xsharp

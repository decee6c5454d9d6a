/// @file
/// A convex body: its vertices and faces, in object space.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace xsharp {

/// A place or a direction before it becomes fixed point.
using Triple = std::array<double, 3>;

/// A convex polygon whose vertices run so that it shows when the screen-space cross product of its
/// first and last edges is positive (y down): counterclockwise seen from outside in a right-handed
/// object space.
struct Face {
  std::vector<std::size_t> vertices;
  /// The vertex at the end of the unit normal that starts at vertices[0]; a shaded face has one.
  std::optional<std::size_t> normal_end{};
};

struct Mesh {
  std::vector<Triple> vertices;
  std::vector<Face> faces;
};

}  // namespace xsharp

/// @file
/// Subpixel screen positions of the corners of an object.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "xsharp/clip.hpp"
#include "xsharp/motion.hpp"
#include "xsharp/reach.hpp"

namespace fixproof::trade {

/// Pixels from the centre of the page, y up.
using ScreenPlace = std::array<double, 2>;

/// One moving object under a number type. It computes the same as xsharp::Polyhedron before
/// rounding to pixels, for vertices that are corners of faces.
template <xsharp::Scalar N>
class ScreenCorners {
 public:
  ScreenCorners(const xsharp::ObjectDescription& object, const xsharp::RotationStyle& style)
      : motion_(object, style) {
    std::vector<bool> is_corner(object.mesh.vertices.size());
    for (const xsharp::Face& face : object.mesh.faces) {
      for (const std::size_t v : face.vertices) is_corner[v] = true;
    }
    for (std::size_t i = 0; i < is_corner.size(); ++i) {
      const xsharp::Triple& v = object.mesh.vertices[i];
      // Ends of normals count too, because the pipeline tests the whole mesh for being in range.
      radius_ = std::max(radius_, xsharp::length(v));
      if (!is_corner[i]) continue;
      vertices_.push_back(xsharp::vertex_of<N>(object.mesh, v, style.conversion));
    }
  }

  /// Advances one frame. @return whether anything changed
  bool advance() { return motion_.advance(); }

  /// The corners in view space; empty if the object is out of range.
  const std::vector<xsharp::Vec3<N>>& view(const xsharp::View<N>& from) {
    seen_.clear();
    const auto to_world = xsharp::within_reach(motion_, from, radius_);
    if (!to_world) return seen_;
    const auto to_view =
        xsharp::Arithmetic<N>::concatenate(from.world_to_view, *to_world, from.concatenation);
    for (const auto& v : vertices_) seen_.push_back(xsharp::Arithmetic<N>::apply(to_view, v));
    return seen_;
  }

 private:
  xsharp::Motion<N> motion_;
  std::vector<xsharp::Vec3<N>> vertices_;
  std::vector<xsharp::Vec3<N>> seen_;
  double radius_ = 0;
};

/// Projects a point. Returns nothing on #DE, which cannot happen inside the clip volume.
template <xsharp::Scalar N>
std::optional<ScreenPlace> screen_place(const xsharp::Vec3<N>& view,
                                        const xsharp::Projection<N>& projection) {
  const auto place = xsharp::project_unrounded(view, projection);
  if (!place) return std::nullopt;
  return ScreenPlace{static_cast<double>(place->x), static_cast<double>(place->y)};
}

}  // namespace fixproof::trade

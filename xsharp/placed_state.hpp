/// @file
/// The state of an object from its placed vertices.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "xsharp/clip.hpp"
#include "xsharp/object.hpp"
#include "xsharp/project.hpp"

namespace xsharp {

/// The state without the visible faces. Projects the ends of normals, which drawing does not need.
/// @param view   all vertices in view space
/// @param screen the first of them on the screen
template <Scalar N>
ObjectState placed_state(const Transform<N>& to_view, std::span<const Vec3<N>> view,
                         std::span<const std::optional<ScreenPoint>> screen,
                         const Projection<N>& projection) {
  ObjectState state;
  for (std::size_t i = 0; i < 12; ++i) {
    state.xform[i] = Arithmetic<N>::raw(to_view.rows[i / 4][i % 4]);
  }
  for (const Vec3<N>& v : view) {
    state.view.push_back(
        {Arithmetic<N>::raw(v.x), Arithmetic<N>::raw(v.y), Arithmetic<N>::raw(v.z)});
  }
  state.screen.assign(screen.begin(), screen.end());
  for (const Vec3<N>& v : view.subspan(screen.size())) {
    state.screen.push_back(inside(v, projection.slope) ? project(v, projection) : std::nullopt);
  }
  return state;
}

}  // namespace xsharp

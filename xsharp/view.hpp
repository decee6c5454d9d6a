/// @file
/// The camera.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "xsharp/arithmetic.hpp"
#include "xsharp/look_at.hpp"
#include "xsharp/project.hpp"
#include "xsharp/rotation.hpp"
#include "xsharp/scene.hpp"
#include "xsharp/transform.hpp"

namespace xsharp {

/// The view of the scene.
template <Scalar N>
struct View {
  Transform<N> world_to_view{};
  /// The origin page of world space; see ObjectDescription::page.
  std::array<std::int32_t, 3> page{};
  Projection<N> projection{};
  /// Whether polygons need depths, regardless of their surface.
  bool depth_buffer = false;
  DepthMeasure depth_measure = DepthMeasure::inverse;
  N near{};
  /// Whether objects are sorted by their centres, which are then transformed like vertices.
  bool sorts_by_center = false;
  Concatenation concatenation = Concatenation::published;
};

/// The world-to-view matrix in double, for directions and measurements.
inline std::array<std::array<double, 3>, 3> turn_to_view(const Camera& camera) {
  const auto turned = camera.look_at
                          ? look_at_rotation<double>(difference(*camera.look_at, camera.position))
                          : rotation_after(camera.turn_tenths, 1);
  // The inverse of a rotation is its transpose.
  std::array<std::array<double, 3>, 3> inverse{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) inverse[i][j] = turned[j][i];
  }
  return inverse;
}

/// World to view: translates to the camera's position, then applies the inverse rotation.
template <Scalar N>
View<N> view_of(const Scene& scene, Concatenation concatenation = Concatenation::published) {
  const auto turn = turn_to_view(scene.camera);
  View<N> view{identity<N>(),
               scene.camera.page,
               projection_of<N>(scene),
               scene.depth_buffer != DepthBuffering::off,
               scene.depth_measure,
               Arithmetic<N>::constant(scene.near, Conversion::nearest),
               scene.depth_key == DepthKey::center,
               concatenation};
  const auto& position = scene.camera.position;
  for (std::size_t i = 0; i < 3; ++i) {
    double moved = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      view.world_to_view.rows[i][j] = coordinate<N>(turn[i][j], Conversion::nearest);
      moved -= turn[i][j] * position[j];
    }
    view.world_to_view.rows[i][3] = coordinate<N>(moved, Conversion::nearest);
  }
  return view;
}

}  // namespace xsharp

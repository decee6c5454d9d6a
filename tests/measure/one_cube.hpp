/// @file
/// A scene that is small enough to work out by hand.
#pragma once

#include "xsharp/shapes.hpp"

namespace fixproof {

/// One cube at (0, 0, z) that does not move.
inline xsharp::Scene one_cube(double half_edge, double z) {
  xsharp::Scene scene;
  xsharp::ObjectDescription cube;
  cube.mesh = xsharp::cube(half_edge);
  cube.paints.resize(cube.mesh.faces.size(), {true, 1, {}});
  cube.position = {0, 0, z};
  scene.objects.push_back(cube);
  return scene;
}

}  // namespace fixproof

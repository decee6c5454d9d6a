/// @file
/// The distance of a matrix from the exact rotation.
#pragma once

#include <array>

#include "xsharp/mesh.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::trade {

/// The transform from object to view space in double, row-major; column 4 is the translation.
using Placement = std::array<std::array<double, 4>, 3>;

/// The largest values found. Lengths are relative: 0.02 is 2 %.
struct Distortion {
  double skew = 0;    ///< |cosine| of the angle between two axes that should be at right angles
  double length = 0;  ///< of an edge
  double volume = 0;
  double pixels = 0;  ///< distance between a vertex's screen position and the exact one

  /// Keeps the larger value of each member.
  void add(const Distortion& other);
};

/// @param is        the actual placement of the object
/// @param should_be the placement with an exact rotation
/// @param mesh      only vertices that are corners of faces count
/// @param scene     gives the projection; a vertex nearer than z = -1 has no screen error
Distortion distortion(const Placement& is, const Placement& should_be, const xsharp::Mesh& mesh,
                      const xsharp::Scene& scene);

}  // namespace fixproof::trade

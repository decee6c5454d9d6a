/// @file
/// How far a matrix is from the rotation that it should be.
#pragma once

#include <array>

#include "xsharp/mesh.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::trade {

/// Object to view in double, row by row; the fourth column is the place.
using Placement = std::array<std::array<double, 4>, 3>;

/// Greatest values found. Lengths are relative: 0.02 is 2 %.
struct Distortion {
  double skew = 0;    ///< |cosine| of the angle between two axes that should be at right angles
  double length = 0;  ///< of an edge
  double volume = 0;
  double pixels = 0;  ///< between a vertex on the screen and where it should be

  /// The greater of each.
  void add(const Distortion& other);
};

/// @param is        what has become of the object
/// @param should_be the same, from a rotation without error
/// @param mesh      vertices that are corners of faces count
/// @param scene     for its projection; a vertex nearer than z = -1 does not count on the screen
Distortion distortion(const Placement& is, const Placement& should_be, const xsharp::Mesh& mesh,
                      const xsharp::Scene& scene);

}  // namespace fixproof::trade

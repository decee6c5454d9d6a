/// @file
/// Orientations of objects and cameras that face a point.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "xsharp/arithmetic.hpp"
#include "xsharp/transform.hpp"
#include "xsharp/triple.hpp"
#include "xsharp/unit_vector.hpp"

namespace xsharp {

/// The unit vector of a direction in double. The direction may have any length above 0. A power of
/// two scales the direction, so that it keeps 29 bits when it is converted.
template <Scalar N>
Vec3<N> unit_vector_of(const Triple& direction) {
  const double longest =
      std::max({std::fabs(direction[0]), std::fabs(direction[1]), std::fabs(direction[2])});
  const int scale = 13 - std::ilogb(longest);
  const auto part = [scale](double x) {
    return Arithmetic<N>::constant(std::ldexp(x, scale), Conversion::nearest);
  };
  return unit_vector(Vec3<N>{part(direction[0]), part(direction[1]), part(direction[2])});
}

/// The rotation that turns the -z axis to a direction, and leaves the x axis level. Its columns: x
/// is the unit vector of the cross product of the world's y axis and z; y is the cross product of z
/// and x, of unit length up to rounding. For a direction straight up or down, x is the world's x.
/// @param toward not 0
template <Scalar N>
std::array<std::array<N, 3>, 3> look_at_rotation(const Triple& toward) {
  const Vec3<N> back = unit_vector_of<N>(scaled(toward, -1));
  const N zero = from_whole<N>(0);
  Vec3<N> right{from_whole<N>(1), zero, zero};
  // From the direction itself: its rounded unit vector may have almost no level part.
  if (toward[0] != 0 || toward[2] != 0) right = unit_vector_of<N>({-toward[2], 0, toward[0]});
  const Vec3<N> up = cross(back, right);
  return {{{right.x, up.x, back.x}, {right.y, up.y, back.y}, {right.z, up.z, back.z}}};
}

}  // namespace xsharp

/// @file
/// Points and directions in double, before conversion to fixed point.
#pragma once

#include <array>
#include <cmath>

namespace xsharp {

/// A point or a direction in double.
using Triple = std::array<double, 3>;

[[nodiscard]] inline Triple sum(const Triple& a, const Triple& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

[[nodiscard]] inline Triple difference(const Triple& a, const Triple& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

[[nodiscard]] inline Triple scaled(const Triple& a, double by) {
  return {a[0] * by, a[1] * by, a[2] * by};
}

[[nodiscard]] inline double dot(const Triple& a, const Triple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

[[nodiscard]] inline Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Does not overflow on the way. @pre finite: the standard library may treat a NaN as 0
[[nodiscard]] inline double length(const Triple& a) { return std::hypot(a[0], a[1], a[2]); }

}  // namespace xsharp

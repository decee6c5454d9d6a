#include "measure/trade/drift/distortion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fixproof::trade {

namespace {

using Point = xsharp::Triple;

Point column(const Placement& m, std::size_t j) { return {m[0][j], m[1][j], m[2][j]}; }

Point turned(const Placement& m, const xsharp::Triple& v) {
  Point p{};
  for (std::size_t i = 0; i < 3; ++i) p[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return p;
}

double determinant(const Placement& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

}  // namespace

void Distortion::add(const Distortion& other) {
  skew = std::max(skew, other.skew);
  length = std::max(length, other.length);
  volume = std::max(volume, other.volume);
  pixels = std::max(pixels, other.pixels);
}

Distortion distortion(const Placement& is, const Placement& should_be, const xsharp::Mesh& mesh,
                      const xsharp::Scene& scene) {
  Distortion d;
  for (std::size_t j = 0; j < 3; ++j) {
    const Point a = column(is, j);
    const Point b = column(is, (j + 1) % 3);
    const double lengths = xsharp::length(a) * xsharp::length(b);
    // A collapsed axis has no direction, so the skew is total.
    d.skew = std::max(d.skew, lengths == 0 ? 1 : std::fabs(xsharp::dot(a, b)) / lengths);
  }
  d.volume = std::fabs(determinant(is) - 1);

  const double constant = xsharp::projection_constant(scene);
  for (const xsharp::Face& face : mesh.faces) {
    for (std::size_t i = 0; i < face.vertices.size(); ++i) {
      const xsharp::Triple& from = mesh.vertices[face.vertices[i]];
      const xsharp::Triple& to = mesh.vertices[face.vertices[(i + 1) % face.vertices.size()]];
      const xsharp::Triple edge = xsharp::difference(to, from);
      const double stretch = xsharp::length(turned(is, edge)) / xsharp::length(edge);
      d.length = std::max(d.length, std::fabs(stretch - 1));

      Point at = turned(is, from);
      Point wanted = turned(should_be, from);
      for (std::size_t k = 0; k < 3; ++k) {
        at.at(k) += is.at(k)[3];
        wanted.at(k) += should_be.at(k)[3];
      }
      if (at[2] > -1 || wanted[2] > -1) continue;
      d.pixels = std::max(d.pixels, std::hypot(constant * (at[0] / at[2] - wanted[0] / wanted[2]),
                                               constant * (at[1] / at[2] - wanted[1] / wanted[2])));
    }
  }
  return d;
}

}  // namespace fixproof::trade

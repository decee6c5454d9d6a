#include "verify/drift/distortion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace fixproof {

namespace {

using Point = std::array<double, 3>;

Point column(const Placement& m, std::size_t j) { return {m[0][j], m[1][j], m[2][j]}; }

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double length(const Point& p) { return std::sqrt(dot(p, p)); }

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
    d.skew = std::max(d.skew, std::fabs(dot(a, b)) / (length(a) * length(b)));
  }
  d.volume = std::fabs(determinant(is) - 1);

  const double constant = scene.projection_ratio *
                          (scene.width / 2);  // NOLINT(bugprone-integer-division): as published
  for (const xsharp::Face& face : mesh.faces) {
    for (std::size_t i = 0; i < face.vertices.size(); ++i) {
      const xsharp::Triple& from = mesh.vertices[face.vertices[i]];
      const xsharp::Triple& to = mesh.vertices[face.vertices[(i + 1) % face.vertices.size()]];
      const xsharp::Triple edge{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
      d.length = std::max(d.length, std::fabs(length(turned(is, edge)) / length(edge) - 1));

      const auto on_screen = [constant](const Placement& m, const xsharp::Triple& v) {
        const Point p = turned(m, v);
        const double z = std::min(p[2] + m[2][3], -1.0);
        return std::array{constant * (p[0] + m[0][3]) / z, constant * (p[1] + m[1][3]) / z};
      };
      const auto [x, y] = on_screen(is, from);
      const auto [want_x, want_y] = on_screen(should_be, from);
      d.pixels = std::max(d.pixels, std::hypot(x - want_x, y - want_y));
    }
  }
  return d;
}

}  // namespace fixproof

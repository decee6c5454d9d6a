/// @file
/// Checks that a mesh is a convex body that fits 16.16 numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "xsharp/mesh.hpp"
#include "xsharp/scene_error.hpp"
#include "xsharp/text_of.hpp"

namespace xsharp {

inline constexpr std::size_t max_faces = 4096;
inline constexpr std::size_t max_vertices = 8192;
/// Half a page: a body that rotates about its origin and is added to a position stays within 16.16,
/// with a margin for the errors of many rotations.
inline constexpr double max_vertex = 8192;

namespace detail {

/// Checks one mesh; every check throws SceneError, without the name of the body.
class MeshCheck {
 public:
  explicit MeshCheck(const Mesh& mesh) : mesh_(mesh) {}

  void run() {
    check_counts();
    check_vertices();
    for (face_ = 0; face_ < mesh_.faces.size(); ++face_) check_indices();
    measure();
    for (face_ = 0; face_ < mesh_.faces.size(); ++face_) {
      check_polygon();
      check_body();
      check_normal();
    }
  }

 private:
  template <class... Words>
  [[noreturn]] void fail_face(const Words&... words) const {
    throw SceneError(text_of("face ", face_, words...));
  }

  [[nodiscard]] const Face& face() const { return mesh_.faces[face_]; }
  /// Vertex `i` of the face, modulo the number of vertices.
  [[nodiscard]] const Triple& corner(std::size_t i) const {
    return mesh_.vertices[face().vertices[i % face().vertices.size()]];
  }

  void check_counts() const {
    if (mesh_.faces.empty()) throw SceneError("the mesh has no faces");
    if (mesh_.faces.size() > max_faces) {
      throw SceneError(
          text_of("the mesh has ", mesh_.faces.size(), " faces, more than ", max_faces));
    }
    if (mesh_.vertices.size() > max_vertices) {
      throw SceneError(
          text_of("the mesh has ", mesh_.vertices.size(), " vertices, more than ", max_vertices));
    }
  }

  void check_vertices() const {
    for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
      const Triple& vertex = mesh_.vertices[i];
      if (!std::isfinite(vertex[0]) || !std::isfinite(vertex[1]) || !std::isfinite(vertex[2])) {
        throw SceneError(text_of("vertex ", i, " is not finite"));
      }
      if (length(vertex) > max_vertex) {
        throw SceneError(text_of("vertex ", i, " is ", length(vertex),
                                 " from the origin of the body, more than ", max_vertex));
      }
    }
  }

  void check_indices() const {
    const auto& vertices = face().vertices;
    if (vertices.size() < 3) fail_face(" has ", vertices.size(), " vertices, fewer than 3");
    if (vertices.size() > max_polygon_vertices) {
      fail_face(" has ", vertices.size(), " vertices, more than ", max_polygon_vertices);
    }
    const auto in_range = [this](std::size_t index) {
      if (index < mesh_.vertices.size()) return;
      fail_face(" has vertex ", index, " of ", mesh_.vertices.size());
    };
    std::ranges::for_each(vertices, in_range);
    if (face().normal_end) in_range(*face().normal_end);
  }

  /// Finds the vertices of faces, because ends of normals are outside the body, and sets the
  /// tolerance.
  void measure() {
    for (const Face& face : mesh_.faces) {
      used_.insert(used_.end(), face.vertices.begin(), face.vertices.end());
    }
    std::ranges::sort(used_);
    used_.erase(std::unique(used_.begin(), used_.end()), used_.end());
    double size = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [least, most] = std::ranges::minmax(
          used_, {}, [&](std::size_t index) { return mesh_.vertices[index][axis]; });
      size = std::max(size, mesh_.vertices[most][axis] - mesh_.vertices[least][axis]);
    }
    // 4 units of 16.16 for rounded coordinates, plus 1 in 16384 of the size.
    tolerance_ = std::ldexp(1 + size, -14);
  }

  /// Checks that the face is a planar convex polygon. Sets out_ and middle_.
  void check_polygon() {
    const std::size_t count = face().vertices.size();
    double widest = 0;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i + 1; j < count; ++j) {
        const double distance = length(difference(corner(i), corner(j)));
        if (distance <= tolerance_) {
          fail_face(" has vertices ", face().vertices[i], " and ", face().vertices[j],
                    " at one place");
        }
        widest = std::max(widest, distance);
      }
    }
    const Triple area = outward_area(mesh_, face());
    if (length(area) <= tolerance_ * widest) fail_face(" has no area");
    out_ = scaled(area, 1 / length(area));

    middle_ = {};
    for (std::size_t i = 0; i < count; ++i) middle_ = sum(middle_, corner(i));
    middle_ = scaled(middle_, 1 / static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
      const double off = std::fabs(dot(out_, difference(corner(i), middle_)));
      if (off > tolerance_) {
        fail_face(" is not flat: vertex ", face().vertices[i], " is ", off, " off its plane");
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Triple edge = difference(corner(i + 1), corner(i));
      const Triple in = scaled(cross(edge, out_), 1 / length(edge));
      for (std::size_t j = 0; j < count; ++j) {
        if (dot(in, difference(corner(j), corner(i))) < -tolerance_) {
          fail_face(" is not convex: vertex ", face().vertices[j],
                    " is outside the edge that begins at vertex ", face().vertices[i]);
        }
      }
    }
    // The test by which the pipeline distinguishes front and back.
    const Triple first = difference(corner(1), corner(0));
    const Triple last = difference(corner(count - 1), corner(0));
    if (length(cross(first, last)) <= tolerance_ * length(difference(first, last))) {
      fail_face(" begins at vertex ", face().vertices[0], ", where it has no corner");
    }
  }

  /// Checks that the whole body is behind the plane of the face.
  void check_body() const {
    double before = 0;
    double behind = 0;
    std::size_t worst = 0;
    for (const std::size_t index : used_) {
      const double distance = dot(out_, difference(mesh_.vertices[index], middle_));
      if (distance > before) worst = index;
      before = std::max(before, distance);
      behind = std::min(behind, distance);
    }
    if (before <= tolerance_) return;
    if (behind >= -tolerance_)
      fail_face(" faces into the body: its vertices run the wrong way round");
    fail_face(": the body is not convex: vertex ", worst, " is ", before, " before the face");
  }

  void check_normal() const {
    if (!face().normal_end) return;
    const Triple normal = difference(mesh_.vertices[*face().normal_end], corner(0));
    if (std::fabs(length(normal) - 1) > std::ldexp(1, -12)) {
      fail_face(" has a normal of length ", length(normal), " instead of 1");
    }
    if (length(difference(normal, out_)) > std::ldexp(1, -8)) {
      fail_face(" has a normal that is not at right angles to it, outward");
    }
  }

  const Mesh& mesh_;
  std::vector<std::size_t> used_;
  double tolerance_ = 0;
  // of the current face
  std::size_t face_ = 0;
  Triple out_{};
  Triple middle_{};
};

}  // namespace detail

/// Accepts a convex body, or a part of the surface of one, with faces as in mesh.hpp. The tolerance
/// is 2^-14 of (1 + the longest side of the body's bounding box) for positions, and 2^-12 in length
/// and 2^-8 in direction for unit normals.
/// @throws SceneError with the face or vertex
inline void validate_mesh(const Mesh& mesh) { detail::MeshCheck(mesh).run(); }

}  // namespace xsharp

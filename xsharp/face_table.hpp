/// @file
/// The faces of a mesh in compact form.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "xsharp/mesh.hpp"

namespace xsharp {

/// Faces as indices of vertices. Uses 32 bits: a mesh has fewer, and scenes may have millions.
class FaceTable {
 public:
  explicit FaceTable(const std::vector<Face>& faces) {
    for (const Face& face : faces) {
      faces_.push_back({static_cast<std::uint32_t>(vertices_.size()),
                        static_cast<std::uint32_t>(face.vertices.size()),
                        static_cast<std::uint32_t>(face.normal_end.value_or(0))});
      for (const std::size_t v : face.vertices) {
        vertices_.push_back(static_cast<std::uint32_t>(v));
        vertex_count_ = std::max(vertex_count_, v + 1);
      }
    }
  }

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(faces_.size()); }

  [[nodiscard]] std::span<const std::uint32_t> vertices_of(std::uint32_t face) const {
    return std::span(vertices_).subspan(faces_[face].first, faces_[face].count);
  }

  /// The vertices of all faces, with repetitions.
  [[nodiscard]] std::span<const std::uint32_t> vertices() const { return vertices_; }

  /// Face::normal_end; 0 without one.
  [[nodiscard]] std::uint32_t normal_end(std::uint32_t face) const {
    return faces_[face].normal_end;
  }

  /// The number of vertices up to the last one of a face; the rest are ends of normals.
  [[nodiscard]] std::size_t vertex_count() const { return vertex_count_; }

 private:
  struct Range {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t normal_end = 0;
  };

  std::vector<Range> faces_{};
  std::vector<std::uint32_t> vertices_{};
  std::size_t vertex_count_ = 0;
};

}  // namespace xsharp

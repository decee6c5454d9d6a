/// @file
/// The convex polyhedron: the one kind of object that scenes describe.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "xsharp/clip.hpp"
#include "xsharp/motion.hpp"
#include "xsharp/object.hpp"
#include "xsharp/reach.hpp"
#include "xsharp/surface_values.hpp"

namespace xsharp {

/// Whether a convex polygon of the screen shows its front: the cross product of its first and last
/// edges is positive (y grows downward).
inline bool faces_viewer(std::span<const ScreenPoint> polygon) {
  if (polygon.size() < 3) return false;
  const ScreenPoint& corner = polygon.front();
  const auto edge = [&corner](const ScreenPoint& to) {
    return std::pair{std::int64_t{to.x} - corner.x, std::int64_t{to.y} - corner.y};
  };
  const auto [first_x, first_y] = edge(polygon[1]);
  const auto [last_x, last_y] = edge(polygon.back());
  return first_x * last_y - first_y * last_x > 0;
}

/// The same for a polygon that clipping has given new corners, whose first and last edges may have
/// no length to speak of: by twice its area.
inline bool shows_front_area(std::span<const ScreenPoint> polygon) {
  std::int64_t area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ScreenPoint& a = polygon[i];
    const ScreenPoint& b = polygon[(i + 1) % polygon.size()];
    area += std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
  }
  return area > 0;
}

template <Scalar N>
class Polyhedron final : public Object<N> {
 public:
  /// @param index which object of the scene it is
  Polyhedron(const ObjectDescription& object, std::uint32_t index, const RotationStyle& style)
      : index_(index),
        shading_(object.shading),
        surface_(object.surface),
        faces_(object.mesh.faces),
        paints_(object.paints),
        normal_ends_(object.mesh.vertex_normal_ends),
        motion_(object, style) {
    for (const Triple& v : object.mesh.vertices) {
      vertices_.push_back({coordinate<N>(v[0], style.conversion),
                           coordinate<N>(v[1], style.conversion),
                           coordinate<N>(v[2], style.conversion)});
      radius_ = std::max(radius_, length(v));
    }
    view_.resize(vertices_.size());
    screen_.resize(vertices_.size());
  }

  void prepare(const View<N>& view, Tally& tally) override {
    if (prepared_) {
      tally.out_of_reach += in_reach_ ? 0 : 1;
      return;
    }
    prepared_ = true;
    visible_.clear();
    corners_.clear();
    carried_.clear();
    has_values_ = view.depth_buffer || surface_.kind != SurfaceKind::flat;
    near_ = view.near;
    const auto to_world = within_reach(motion_, view, radius_);
    in_reach_ = to_world.has_value();
    if (!to_world) {
      ++tally.out_of_reach;
      return;
    }
    to_view_ = Arithmetic<N>::concatenate(view.world_to_view, *to_world);
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      view_[i] = Arithmetic<N>::apply(to_view_, vertices_[i]);
      screen_[i] = project_inside(view_[i], view.projection, tally);
    }
    for (std::size_t f = 0; f < faces_.size(); ++f) hide_or_keep(f, view.projection, tally);
  }

  [[nodiscard]] N depth(DepthKey key) const override {
    N farthest = to_view_.rows[2][3];
    N nearest = farthest;
    // The centre is the origin of object space.
    if (key == DepthKey::none || key == DepthKey::center || !in_reach_) return farthest;
    for (const Face& face : faces_) {
      for (const std::size_t v : face.vertices) {
        farthest = std::min(farthest, view_[v].z);
        nearest = std::max(nearest, view_[v].z);
      }
    }
    return key == DepthKey::nearest ? nearest : farthest;
  }

  void draw(const Lighting<N>& lighting, Picture& picture) const override {
    std::size_t corner = 0;
    for (const Seen& seen : visible_) {
      const Face& face = faces_[seen.face];
      Paint paint = paints_[seen.face];
      if (shading_.ambient || shading_.diffuse) {
        // A face that answers to ambient light alone has no normal.
        const Vec3<N> normal =
            shading_.diffuse ? view_[*face.normal_end] - view_[face.vertices[0]] : Vec3<N>{};
        paint = {false, 0, shade(normal, paint.color, shading_, lighting)};
      }
      picture.polygons.push_back(
          {index_, static_cast<std::uint32_t>(picture.points.size()), seen.corners, paint});
      const auto from = corners_.begin() + static_cast<std::ptrdiff_t>(corner);
      picture.points.insert(picture.points.end(), from, from + seen.corners);
      corner += seen.corners;
    }
    if (has_values_) add_values(lighting, picture);
  }

  void move() override {
    if (motion_.advance()) prepared_ = false;
  }

  [[nodiscard]] ObjectState state() const override {
    ObjectState state;
    if (!in_reach_) return state;
    for (std::size_t i = 0; i < 12; ++i) {
      state.xform[i] = Arithmetic<N>::raw(to_view_.rows[i / 4][i % 4]);
    }
    for (const Vec3<N>& v : view_) {
      state.view.push_back(
          {Arithmetic<N>::raw(v.x), Arithmetic<N>::raw(v.y), Arithmetic<N>::raw(v.z)});
    }
    state.screen = screen_;
    for (const Seen& seen : visible_) state.visible.push_back(seen.face);
    return state;
  }

 private:
  /// A face that shows, and how many of `corners_` are its polygon's.
  struct Seen {
    std::size_t face = 0;
    std::uint32_t corners = 0;
  };

  static std::optional<ScreenPoint> project_inside(const Vec3<N>& point,
                                                   const Projection<N>& projection, Tally& tally) {
    if (!inside(point, projection.slope)) return std::nullopt;
    return project_counted(point, projection, tally);
  }

  static std::optional<ScreenPoint> project_counted(const Vec3<N>& point,
                                                    const Projection<N>& projection, Tally& tally) {
    const auto on_screen = project(point, projection);
    if (!on_screen) ++tally.faults;
    return on_screen;
  }

  /// Keeps the face's polygon if it shows.
  void hide_or_keep(std::size_t f, const Projection<N>& projection, Tally& tally) {
    const std::vector<std::size_t>& corners = faces_[f].vertices;
    const std::size_t first = corners_.size();
    bool clipped = false;
    for (const std::size_t v : corners) {
      if (screen_[v]) {
        corners_.push_back(*screen_[v]);
      } else {
        clipped = true;
      }
    }
    if (clipped) {
      corners_.resize(first);
      std::vector<Corner<N>> polygon;
      for (std::size_t i = 0; i < corners.size(); ++i) polygon.push_back(corner_of(f, i));
      for (const Corner<N>& point : clip_polygon<Corner<N>>(polygon, projection.slope)) {
        if (const auto on_screen = project_counted(point.place, projection, tally)) {
          corners_.push_back(*on_screen);
          if (has_values_) carried_.push_back(point);
        }
      }
    } else if (has_values_) {
      for (std::size_t i = 0; i < corners.size(); ++i) carried_.push_back(corner_of(f, i));
    }
    const auto polygon = std::span<const ScreenPoint>(corners_).subspan(first);
    if (clipped ? shows_front_area(polygon) : faces_viewer(polygon)) {
      visible_.push_back({f, static_cast<std::uint32_t>(polygon.size())});
    } else {
      corners_.resize(first);
      if (has_values_) carried_.resize(first);
    }
  }

  /// Corner `i` of a face, with what its surface needs.
  [[nodiscard]] Corner<N> corner_of(std::size_t f, std::size_t i) const {
    const std::vector<std::size_t>& corners = faces_[f].vertices;
    const std::size_t v = corners[i];
    if (needs_normals(surface_) && v < normal_ends_.size()) {
      return {view_[v], view_[normal_ends_[v]] - view_[v]};
    }
    if (surface_.kind != SurfaceKind::texture) return {view_[v], {}};
    const Triple place = bitmap_place(i, corners.size());
    return {view_[v],
            {Arithmetic<N>::constant(place[0], Conversion::nearest),
             Arithmetic<N>::constant(place[1], Conversion::nearest), from_whole<N>(0)}};
  }

  /// Of the points that draw() has added; those of objects before that have none get zeros.
  void add_values(const Lighting<N>& lighting, Picture& picture) const {
    const Vec3<N> light = light_vector(lighting);
    picture.values.resize(picture.points.size() - carried_.size());
    for (const Corner<N>& corner : carried_) {
      picture.values.push_back(point_values(surface_, corner, light, near_));
    }
  }

  std::uint32_t index_;
  Shading shading_;
  Surface surface_;
  std::vector<Face> faces_;
  std::vector<Paint> paints_;
  std::vector<std::size_t> normal_ends_;
  Motion<N> motion_;
  double radius_ = 0;
  std::vector<Vec3<N>> vertices_;

  bool prepared_ = false;
  bool in_reach_ = true;
  Transform<N> to_view_{};
  std::vector<Vec3<N>> view_;
  std::vector<std::optional<ScreenPoint>> screen_;
  std::vector<Seen> visible_;
  std::vector<ScreenPoint> corners_;
  /// Whether faces have values at their corners; then these are beside corners_.
  bool has_values_ = false;
  N near_{};
  std::vector<Corner<N>> carried_;
};

}  // namespace xsharp

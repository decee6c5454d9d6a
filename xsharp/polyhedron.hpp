/// @file
/// The convex polyhedron: the only kind of object that scenes describe.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "xsharp/clip.hpp"
#include "xsharp/face_table.hpp"
#include "xsharp/facing.hpp"
#include "xsharp/highlight.hpp"
#include "xsharp/motion.hpp"
#include "xsharp/object.hpp"
#include "xsharp/place.hpp"
#include "xsharp/placed_state.hpp"
#include "xsharp/reach.hpp"
#include "xsharp/surface_values.hpp"

namespace xsharp {

template <Scalar N>
class Polyhedron final : public Object<N> {
 public:
  /// @param index of the object in the scene
  Polyhedron(const ObjectDescription& object, std::uint32_t index, const RotationStyle& style)
      : index_(index),
        shadings_(object.shadings),
        surface_(object.surface),
        faces_(object.mesh.faces),
        paints_(object.paints),
        normal_ends_(object.mesh.vertex_normal_ends),
        motion_(object, style) {
    for (const Triple& v : object.mesh.vertices) {
      vertices_.push_back(vertex_of<N>(object.mesh, v, style.conversion));
      radius_ = std::max(radius_, length(v));
    }
    view_.resize(vertices_.size());
    screen_.resize(faces_.vertex_count());
  }

  void prepare(const View<N>& view, Tally& tally) override {
    if (!prepared_) {
      place_and_hide(view);
      // Set last, so that an object that has thrown throws again instead of disappearing.
      prepared_ = true;
    }
    tally = tally + tally_;
  }

  [[nodiscard]] N depth(DepthKey key) const override {
    N farthest = center_z_;
    N nearest = farthest;
    if (key == DepthKey::none || key == DepthKey::center || !in_reach_) return farthest;
    for (const std::uint32_t v : faces_.vertices()) {
      farthest = std::min(farthest, view_[v].z);
      nearest = std::max(nearest, view_[v].z);
    }
    return key == DepthKey::nearest ? nearest : farthest;
  }

  void draw(const Lighting<N>& lighting, Picture& picture) const override {
    auto clipped = corners_.begin();
    for (const VisibleFace& seen : visible_) {
      const auto vertices = faces_.vertices_of(seen.face);
      Paint paint = paints_[seen.face];
      const Shading shading = shadings_.empty() ? Shading{} : shadings_[seen.face];
      if (is_lit(shading)) {
        // A face with only ambient light has no normal.
        const Vec3<N> normal = needs_normals(shading)
                                   ? view_[faces_.normal_end(seen.face)] - view_[vertices[0]]
                                   : Vec3<N>{};
        paint = {false, 0, shade(normal, paint.color, shading, lighting)};
        if (shading.highlight) {
          paint.color = with_highlight(paint.color, normal, to_viewer_from(seen.face),
                                       *shading.highlight, lighting);
        }
      }
      const auto first = static_cast<std::uint32_t>(picture.points.size());
      if (seen.clipped_corners == 0) {
        for (const std::uint32_t v : vertices) picture.points.push_back(*screen_[v]);
      } else {
        const auto end = clipped + static_cast<std::ptrdiff_t>(seen.clipped_corners);
        picture.points.insert(picture.points.end(), clipped, end);
        clipped = end;
      }
      picture.polygons.push_back(
          {index_, first, static_cast<std::uint32_t>(picture.points.size()) - first, paint});
    }
    if (has_values_) add_values(lighting, picture);
  }

  void move() override {
    if (motion_.advance()) prepared_ = false;
  }

  [[nodiscard]] ObjectState state() const override {
    if (!in_reach_) return {};
    ObjectState state = placed_state<N>(to_view_, view_, screen_, projection_);
    for (const VisibleFace& seen : visible_) state.visible.push_back(seen.face);
    return state;
  }

 private:
  /// A visible face. Its polygon has the corners of the face, or a number of entries of corners_.
  struct VisibleFace {
    std::uint32_t face = 0;
    std::uint32_t clipped_corners = 0;
  };

  /// The part of prepare() that depends on the position.
  void place_and_hide(const View<N>& view) {
    tally_ = {};
    visible_.clear();
    corners_.clear();
    carried_.clear();
    has_values_ = view.depth_buffer || surface_.kind != SurfaceKind::flat;
    near_ = view.near;
    depth_measure_ = view.depth_measure;
    projection_ = view.projection;
    const auto to_world = within_reach(motion_, view, radius_);
    in_reach_ = to_world.has_value();
    if (!to_world) {
      ++tally_.out_of_reach;
      return;
    }
    to_view_ = Arithmetic<N>::concatenate(view.world_to_view, *to_world, view.concatenation);
    const std::span<const Vec3<N>> vertices = vertices_;
    const std::span<Vec3<N>> to = view_;
    const std::size_t placed = faces_.vertex_count();
    const Unplaced unplaced = place(to_view_, vertices.first(placed), view.projection,
                                    Places<N>{to.first(placed), screen_});
    transform_to_view(to_view_, vertices.subspan(placed), to.subspan(placed));
    // The centre is the origin of object space. Chapter 53 transforms it along with the vertices.
    center_z_ =
        view.sorts_by_center ? Arithmetic<N>::apply(to_view_, Vec3<N>{}).z : to_view_.rows[2][3];
    tally_.faults += unplaced.faults;
    const bool all_on_screen = unplaced == Unplaced{};
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      if (all_on_screen || is_on_screen(f)) {
        hide_or_keep(f);
      } else {
        clip_or_hide(f, view.projection);
      }
    }
  }

  std::optional<ScreenPoint> project_counted(const Vec3<N>& point,
                                             const Projection<N>& projection) {
    const auto on_screen = project(point, projection);
    if (!on_screen) ++tally_.faults;
    return on_screen;
  }

  [[nodiscard]] bool is_on_screen(std::uint32_t face) const {
    const auto vertices = faces_.vertices_of(face);
    return std::all_of(vertices.begin(), vertices.end(),
                       [this](std::uint32_t v) { return screen_[v].has_value(); });
  }

  /// Keeps a face that shows its front. @pre is_on_screen(f)
  void hide_or_keep(std::uint32_t f) {
    const auto v = faces_.vertices_of(f);
    if (v.size() < 3 || !faces_viewer(*screen_[v[0]], *screen_[v[1]], *screen_[v.back()])) return;
    visible_.push_back({f, 0});
    if (!has_values_) return;
    for (std::size_t i = 0; i < v.size(); ++i) carried_.push_back(corner_of(f, i));
  }

  /// Clips any other face and keeps what is visible of it.
  void clip_or_hide(std::uint32_t f, const Projection<N>& projection) {
    const std::size_t first = corners_.size();
    const std::size_t first_carried = carried_.size();
    std::vector<Corner<N>> polygon;
    for (std::size_t i = 0; i < faces_.vertices_of(f).size(); ++i)
      polygon.push_back(corner_of(f, i));
    for (const Corner<N>& point : clip_polygon<Corner<N>>(polygon, projection.slope)) {
      if (const auto on_screen = project_counted(point.place, projection)) {
        corners_.push_back(*on_screen);
        if (has_values_) carried_.push_back(point);
      }
    }
    const auto on_screen = std::span<const ScreenPoint>(corners_).subspan(first);
    if (shows_front_area(on_screen)) {
      visible_.push_back({f, static_cast<std::uint32_t>(on_screen.size())});
    } else {
      corners_.resize(first);
      carried_.resize(first_carried);
    }
  }

  /// Corner `i` of a face, with the values that its surface needs.
  [[nodiscard]] Corner<N> corner_of(std::uint32_t f, std::size_t i) const {
    const auto corners = faces_.vertices_of(f);
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

  /// The unit vector to the viewer from a face: from the middle between its first corner and the
  /// one opposite.
  [[nodiscard]] Vec3<N> to_viewer_from(std::uint32_t f) const {
    const auto corners = faces_.vertices_of(f);
    const Vec3<N> middle = between(view_[corners[0]], view_[corners[corners.size() / 2]]);
    return unit_vector(Vec3<N>{-middle.x, -middle.y, -middle.z});
  }

  /// Adds the values for the points that draw() has added, if the object has any, and zeros for
  /// previous objects without values.
  void add_values(const Lighting<N>& lighting, Picture& picture) const {
    if (carried_.empty()) return;
    const Vec3<N> light = light_vector(lighting);
    picture.values.resize(picture.points.size() - carried_.size());
    for (const Corner<N>& corner : carried_) {
      picture.values.push_back(point_values(surface_, corner, light, near_, depth_measure_));
    }
  }

  std::uint32_t index_;
  std::vector<Shading> shadings_;
  Surface surface_;
  FaceTable faces_;
  std::vector<Paint> paints_;
  std::vector<std::size_t> normal_ends_;
  Motion<N> motion_;
  double radius_ = 0;
  std::vector<Vec3<N>> vertices_;

  bool prepared_ = false;
  /// The tally of the last prepare().
  Tally tally_{};
  bool in_reach_ = true;
  Transform<N> to_view_{};
  N center_z_{};
  Projection<N> projection_{};
  std::vector<Vec3<N>> view_;
  std::vector<std::optional<ScreenPoint>> screen_;
  std::vector<VisibleFace> visible_;
  /// The corners of the clipped polygons, in the order of visible_.
  std::vector<ScreenPoint> corners_;
  /// Whether faces have values at their corners; if so, for all visible faces.
  bool has_values_ = false;
  N near_{};
  DepthMeasure depth_measure_ = DepthMeasure::inverse;
  std::vector<Corner<N>> carried_;
};

}  // namespace xsharp

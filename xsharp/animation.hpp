/// @file
/// A scene in motion: the stages in their order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "xsharp/depth.hpp"
#include "xsharp/object.hpp"
#include "xsharp/player.hpp"
#include "xsharp/polyhedron.hpp"

namespace xsharp {

/// World to view: moved to the camera's place, then turned the other way about.
template <Scalar N>
View<N> view_of(const Scene& scene) {
  const auto& tenths = scene.camera.turn_tenths;
  const auto turned = rotation_after(tenths, 1);
  View<N> view{identity<N>(), scene.camera.page, projection_of<N>(scene)};
  const auto& position = scene.camera.position;
  for (std::size_t i = 0; i < 3; ++i) {
    double moved = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      // The inverse of a rotation is its transpose.
      view.world_to_view.rows[i][j] = coordinate<N>(turned[j][i], Conversion::nearest);
      moved -= turned[j][i] * position[j];
    }
    view.world_to_view.rows[i][3] = coordinate<N>(moved, Conversion::nearest);
  }
  return view;
}

/// The matrix of world to view in double, for directions.
inline std::array<std::array<double, 3>, 3> turn_to_view(const Camera& camera) {
  const auto turned = rotation_after(camera.turn_tenths, 1);
  std::array<std::array<double, 3>, 3> inverse{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) inverse[i][j] = turned[j][i];
  }
  return inverse;
}

template <Scalar N>
class Animation final : public Player {
 public:
  explicit Animation(const Scene& scene)
      : key_(scene.depth_key),
        view_(view_of<N>(scene)),
        lighting_(lighting_of<N>(scene.lights, scene.conversion, turn_to_view(scene.camera))) {
    const RotationStyle style{scene.trigonometry, scene.conversion, scene.from_scratch,
                              scene.restore_every};
    for (const ObjectDescription& object : scene.objects) {
      add(std::make_unique<Polyhedron<N>>(object, static_cast<std::uint32_t>(objects_.size()),
                                          style));
    }
  }

  /// Adds an object of any kind, drawn last until the scene is sorted.
  void add(std::unique_ptr<Object<N>> object) {
    order_.push_back(objects_.size());
    objects_.push_back(std::move(object));
  }

  Tally draw(Picture& picture) override {
    Tally tally;
    depths_.clear();
    for (const auto& object : objects_) {
      object->prepare(view_, tally);
      depths_.push_back(object->depth(key_));
    }
    if (key_ != DepthKey::none) sort_by_depth(order_, std::span<const N>(depths_));
    picture.clear();
    for (const std::size_t i : order_) objects_[i]->draw(lighting_, picture);
    return tally;
  }

  void move() override {
    for (const auto& object : objects_) object->move();
  }

  [[nodiscard]] std::span<const std::size_t> order() const override { return order_; }
  [[nodiscard]] ObjectState state(std::size_t object) const override {
    return objects_[object]->state();
  }

  void switch_light(std::size_t light) override {
    if (light == 0) {
      lighting_.ambient_on = !lighting_.ambient_on;
    } else if (light <= lighting_.rays.size()) {
      lighting_.rays[light - 1].on = !lighting_.rays[light - 1].on;
    }
  }

 private:
  DepthKey key_;
  View<N> view_;
  Lighting<N> lighting_;
  std::vector<std::unique_ptr<Object<N>>> objects_;
  std::vector<std::size_t> order_;
  std::vector<N> depths_;
};

}  // namespace xsharp

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
#include "xsharp/view.hpp"

namespace xsharp {

template <Scalar N>
class Animation final : public Player {
 public:
  explicit Animation(const Scene& scene)
      : key_(scene.depth_key),
        front_to_back_(scene.depth_buffer != DepthBuffering::off),
        view_(view_of<N>(scene)),
        lighting_(lighting_of<N>(scene.lights, scene.conversion, turn_to_view(scene.camera))) {
    const RotationStyle style{scene.trigonometry, scene.conversion, scene.from_scratch,
                              scene.restore_every};
    for (const ObjectDescription& object : scene.objects) {
      add(std::make_unique<Polyhedron<N>>(object, static_cast<std::uint32_t>(objects_.size()),
                                          style));
      shades_pixels_ = shades_pixels_ || object.surface.kind == SurfaceKind::phong;
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
      const N depth = object->depth(key_);
      depths_.push_back(front_to_back_ ? -depth : depth);
    }
    if (key_ != DepthKey::none) sort_by_depth(order_, std::span<const N>(depths_));
    picture.clear();
    for (const std::size_t i : order_) objects_[i]->draw(lighting_, picture);
    // Those of the last objects, if these have none.
    if (!picture.values.empty()) picture.values.resize(picture.points.size());
    if (shades_pixels_) {
      const Vec3<N> light = light_vector(lighting_);
      picture.light = {static_cast<double>(light.x), static_cast<double>(light.y),
                       static_cast<double>(light.z)};
    }
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
  bool front_to_back_;
  bool shades_pixels_ = false;
  View<N> view_;
  Lighting<N> lighting_;
  std::vector<std::unique_ptr<Object<N>>> objects_;
  std::vector<std::size_t> order_;
  std::vector<N> depths_;
};

}  // namespace xsharp

/// @file
/// Runs the stages of the pipeline on a scene, frame by frame.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "support/thread_pool.hpp"
#include "xsharp/depth.hpp"
#include "xsharp/object.hpp"
#include "xsharp/player.hpp"
#include "xsharp/polyhedron.hpp"
#include "xsharp/view.hpp"

namespace xsharp {

/// The fewest vertices for which waking a thread and waiting for it takes less than it saves; see
/// "Large scenes" in docs/performance.md.
inline constexpr std::size_t vertices_per_thread = 40'000;

/// Returns how many of `threads` threads shorten the frames of a scene. No thread has less than an
/// object.
inline std::size_t useful_threads(const Scene& scene, std::size_t threads) {
  std::size_t vertices = 0;
  for (const ObjectDescription& object : scene.objects) vertices += object.mesh.vertices.size();
  const std::size_t most = std::min(vertices / vertices_per_thread, scene.objects.size());
  return std::max<std::size_t>(1, std::min(threads, most));
}

template <Scalar N>
class Animation final : public Player {
 public:
  /// @param threads that move, prepare and draw objects, as far as useful_threads() of the scene,
  /// whatever add() adds; the number does not affect the pictures
  explicit Animation(const Scene& scene, std::size_t threads = 1,
                     Concatenation concatenation = Concatenation::published)
      : pool_(useful_threads(scene, threads)),
        tallies_(pool_.workers()),
        key_(scene.depth_key),
        front_to_back_(scene.depth_buffer != DepthBuffering::off),
        view_(view_of<N>(scene, concatenation)),
        lighting_(lighting_of<N>(scene.lights, scene.conversion, view_.world_to_view)) {
    const RotationStyle style{scene.trigonometry, scene.conversion, scene.from_scratch,
                              scene.restore_every, scene.restore_rows};
    for (const ObjectDescription& object : scene.objects) {
      objects_.push_back(std::make_unique<Polyhedron<N>>(
          object, static_cast<std::uint32_t>(objects_.size()), style));
      shades_pixels_ = shades_pixels_ || object.surface.kind == SurfaceKind::phong;
    }
    // The order that add() gives. For many objects, inserting each at the front would be slow.
    order_.resize(objects_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    if (last_goes_first()) std::reverse(order_.begin(), order_.end());
  }

  /// Adds an object of any kind. Unsorted objects are drawn in the order in which they were added.
  /// In a sorted scene the new object goes before all others until the next draw(), which keeps it
  /// before those of equal depth. Objects of equal depth are therefore drawn in the reverse of the
  /// order in which they were added (listing 53.2). Under a depth buffer the list is drawn from its
  /// other end.
  void add(std::unique_ptr<Object<N>> object) {
    order_.insert(last_goes_first() ? order_.begin() : order_.end(), objects_.size());
    objects_.push_back(std::move(object));
  }

  Tally draw(Picture& picture) override {
    depths_.resize(objects_.size());
    tallies_.assign(pool_.workers(), {});
    pool_.run([this](std::size_t worker) {
      const auto [first, end] = pool_.part(objects_.size(), worker);
      Tally tally;
      for (std::size_t i = first; i < end; ++i) {
        objects_[i]->prepare(view_, tally);
        const N depth = objects_[i]->depth(key_);
        depths_[i] = front_to_back_ ? -depth : depth;
      }
      tallies_[worker] = tally;
    });
    if (key_ != DepthKey::none) sort_by_depth(order_, std::span<const N>(depths_));
    draw_in_order(picture);
    // The values of the last objects may be missing, if these have none.
    if (!picture.values.empty()) picture.values.resize(picture.points.size());
    if (shades_pixels_) {
      const Vec3<N> light = light_vector(lighting_);
      picture.light = {static_cast<double>(light.x), static_cast<double>(light.y),
                       static_cast<double>(light.z)};
    }
    return std::accumulate(tallies_.begin(), tallies_.end(), Tally{});
  }

  void move() override {
    pool_.run([this](std::size_t worker) {
      const auto [first, end] = pool_.part(objects_.size(), worker);
      for (std::size_t i = first; i < end; ++i) objects_[i]->move();
    });
  }

  /// The threads in use.
  [[nodiscard]] std::size_t threads() const { return pool_.workers(); }

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
  /// Whether add() puts the new object before all others.
  [[nodiscard]] bool last_goes_first() const { return key_ != DepthKey::none && !front_to_back_; }

  void draw_in_order(Picture& picture) {
    parts_.resize(pool_.workers());
    pool_.run([&](std::size_t worker) {
      // The first worker starts the picture; the parts of the others are appended.
      Picture& mine = worker == 0 ? picture : parts_[worker];
      mine.clear();
      const auto [first, end] = pool_.part(order_.size(), worker);
      for (std::size_t i = first; i < end; ++i) objects_[order_[i]]->draw(lighting_, mine);
    });
    for (std::size_t worker = 1; worker < parts_.size(); ++worker) picture.add(parts_[worker]);
  }

  fixproof::support::ThreadPool pool_;
  std::vector<Tally> tallies_;
  std::vector<Picture> parts_;
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

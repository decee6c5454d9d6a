/// @file
/// What every kind of object in a scene can do.
#pragma once

#include <array>
#include <boost/noncopyable.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "xsharp/picture.hpp"
#include "xsharp/scene.hpp"
#include "xsharp/shade.hpp"
#include "xsharp/view.hpp"

namespace xsharp {

/// What became of an object in one frame.
struct Tally {
  std::uint64_t faults = 0;        ///< divides that faulted: none, as long as clipping works
  std::uint64_t out_of_reach = 0;  ///< objects not drawn, too far away for 16.16

  friend constexpr Tally operator+(const Tally& a, const Tally& b) {
    return {a.faults + b.faults, a.out_of_reach + b.out_of_reach};
  }
};

/// An object's state for people and files, in units of 2^-16. Nothing, and a transform of 0, for
/// one that is out of reach.
struct ObjectState {
  std::array<std::int32_t, 12> xform{};  ///< object to view, row by row
  std::vector<std::array<std::int32_t, 3>> view;
  /// Of every vertex, also of ends of normals, which drawing does not project; nothing for a vertex
  /// that is clipped.
  std::vector<std::optional<ScreenPoint>> screen;
  std::vector<std::size_t> visible;  ///< faces drawn, in order
};

/// One object. Preparing, drawing and moving are its own affair: a scene may hold any kind.
template <Scalar N>
class Object : private boost::noncopyable {
 public:
  virtual ~Object() = default;

  /// Works out all that drawing needs. Called before each frame; an object that has not moved
  /// since, under the same view, need only add what became of it to the tally again.
  virtual void prepare(const View<N>& view, Tally& tally) = 0;
  /// View z of the part that `key` names; any value under DepthKey::none.
  [[nodiscard]] virtual N depth(DepthKey key) const = 0;
  /// Adds its polygons to the picture.
  virtual void draw(const Lighting<N>& lighting, Picture& picture) const = 0;
  /// Moves and turns by one frame.
  virtual void move() = 0;
  [[nodiscard]] virtual ObjectState state() const = 0;
};

}  // namespace xsharp

/// @file
/// The interface of an object in a scene.
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

/// The counts for the objects of one frame.
struct Tally {
  std::uint64_t faults = 0;        ///< divide errors; 0 as long as clipping works
  std::uint64_t out_of_reach = 0;  ///< objects too far away for 16.16, which are not drawn

  friend constexpr Tally operator+(const Tally& a, const Tally& b) {
    return {a.faults + b.faults, a.out_of_reach + b.out_of_reach};
  }
};

/// The state of an object for output, in units of 2^-16. Empty, with a transform of 0, for an
/// object out of reach.
struct ObjectState {
  std::array<std::int32_t, 12> xform{};  ///< object to view, row by row
  std::vector<std::array<std::int32_t, 3>> view;
  /// For every vertex, including ends of normals, which drawing does not project; empty for a
  /// vertex that is clipped.
  std::vector<std::optional<ScreenPoint>> screen;
  std::vector<std::size_t> visible;  ///< faces drawn, in order
};

/// An object of any kind, which prepares, draws and moves itself.
template <Scalar N>
class Object : private boost::noncopyable {
 public:
  virtual ~Object() = default;

  /// Computes everything that drawing needs. Called before each frame. If neither the object nor
  /// the view has changed, it need only add its counts to the tally again.
  virtual void prepare(const View<N>& view, Tally& tally) = 0;
  /// The view z that `key` selects; any value under DepthKey::none.
  [[nodiscard]] virtual N depth(DepthKey key) const = 0;
  /// Adds its polygons to the picture.
  virtual void draw(const Lighting<N>& lighting, Picture& picture) const = 0;
  /// Moves and rotates by one frame.
  virtual void move() = 0;
  [[nodiscard]] virtual ObjectState state() const = 0;
};

}  // namespace xsharp

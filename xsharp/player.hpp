/// @file
/// A running scene, independent of the arithmetic.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstddef>
#include <span>

#include "xsharp/object.hpp"
#include "xsharp/picture.hpp"

namespace xsharp {

/// Plays a scene: each frame is a draw(), then a move().
class Player : private boost::noncopyable {
 public:
  virtual ~Player() = default;

  /// Prepares and sorts the objects and replaces the contents of `picture` with what is visible.
  virtual Tally draw(Picture& picture) = 0;
  /// Moves every object by one frame.
  virtual void move() = 0;

  /// The objects in the order they were last drawn.
  [[nodiscard]] virtual std::span<const std::size_t> order() const = 0;
  /// The state when the object was last prepared.
  [[nodiscard]] virtual ObjectState state(std::size_t object) const = 0;
  /// Turns a light on or off: 0 is the ambient light, 1 the first spot, and so on. Ignores other
  /// numbers.
  virtual void switch_light(std::size_t light) = 0;
};

}  // namespace xsharp

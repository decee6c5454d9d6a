/// @file
/// A scene in motion, whatever the arithmetic.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstddef>
#include <span>

#include "xsharp/object.hpp"
#include "xsharp/picture.hpp"

namespace xsharp {

/// A frame is draw(), then move().
class Player : private boost::noncopyable {
 public:
  virtual ~Player() = default;

  /// Prepares and sorts the objects and puts what shows into `picture`, in place of what was there.
  virtual Tally draw(Picture& picture) = 0;
  /// Moves every object by one frame.
  virtual void move() = 0;

  /// Objects in the order they were last drawn.
  [[nodiscard]] virtual std::span<const std::size_t> order() const = 0;
  /// As it was last prepared.
  [[nodiscard]] virtual ObjectState state(std::size_t object) const = 0;
  /// Turns a light on or off: 0 the ambient light, 1 the first spot, and so on; no other does
  /// anything.
  virtual void switch_light(std::size_t light) = 0;
};

}  // namespace xsharp

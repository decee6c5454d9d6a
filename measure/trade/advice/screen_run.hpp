/// @file
/// Draws the corners of a scene in several arithmetics at once and compares them with double.
#pragma once

#include <array>
#include <atomic>
#include <boost/noncopyable.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "measure/trade/advice/screen_corners.hpp"
#include "measure/trade/advice/screen_error.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::trade {

/// The exact corners of one object; a clipped corner is empty, an object out of range has none.
using ExactPlaces = std::vector<std::optional<ScreenPlace>>;

/// The objects of a scene in one arithmetic.
class ScreenRun : private boost::noncopyable {
 public:
  ScreenRun() = default;
  virtual ~ScreenRun() = default;
  virtual void advance(std::size_t object) = 0;
  /// Compares the corners of an object, each with its exact place.
  virtual void compare(std::size_t object, const ExactPlaces& exact) = 0;
};

/// Enlarges the largest squared distance `worst` by that of one corner.
void add_error(double& worst, const std::optional<ScreenPlace>& is, const ScreenPlace& should_be);

/// Updates the error of a run by the squared distance of an object in a frame.
void note_error(ScreenError& error, double squared, std::uint64_t frame, std::size_t object,
                double budget);

/// Draws every frame with every run that is not null.
/// @param frames the number of frames; if `stop` ends the drawing early, the number that were done
/// @param compared called after each object that moved in double
/// @param frame_done called after each frame with the number of frames done
void compare_with_exact(
    const xsharp::Scene& scene, const std::vector<std::unique_ptr<ScreenRun>>& runs,
    std::uint64_t& frames, const std::atomic<bool>& stop,
    const std::function<void(std::uint64_t frame, std::size_t object)>& compared,
    const std::function<void(std::uint64_t)>& frame_done);

}  // namespace fixproof::trade

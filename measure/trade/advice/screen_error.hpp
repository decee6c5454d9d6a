/// @file
/// The screen error of a scene's corners under each choice.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "measure/trade/advice/choice.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::trade {

/// The largest error of any corner of any object in any frame.
struct ScreenError {
  double pixels = 0;
  std::uint64_t frame = 0;
  std::size_t object = 0;
  /// The first frame in which a corner's error exceeds the budget.
  std::optional<std::uint64_t> over;
};

/// Draws every frame under every choice and compares each corner with its position computed from
/// scratch in double. The comparison precedes rounding to whole pixels, which moves a point by up
/// to half a pixel under any arithmetic. The error includes the divides, products and motions of
/// the choice. Clipped corners do not count.
/// @param frames the number of frames; if `stop` ends the run early, the number that were done
/// @param frame_done called after each frame with the number of frames done
std::vector<ScreenError> screen_errors(const xsharp::Scene& scene, std::span<const Choice> choices,
                                       double budget, std::uint64_t& frames,
                                       const std::atomic<bool>& stop,
                                       const std::function<void(std::uint64_t)>& frame_done);

}  // namespace fixproof::trade

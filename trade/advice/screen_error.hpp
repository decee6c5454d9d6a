/// @file
/// How far the corners of a scene are from where they should be on the screen, choice by choice.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "trade/advice/choice.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::trade {

/// The worst of any corner of any object in any frame.
struct ScreenError {
  double pixels = 0;
  std::uint64_t frame = 0;
  std::size_t object = 0;
  /// The first frame in which some corner is farther off than the budget.
  std::optional<std::uint64_t> over;
};

/// Draws every frame under every choice and compares each corner with where it is in double, worked
/// out from scratch: before rounding to whole pixels, which moves a point by half a pixel under any
/// arithmetic. Divides, products and motions of the choice all have their part. Corners that are
/// clipped do not count.
/// @param frames is set to the number done when `stop` ended the run before its time
/// @param frame_done is called after each, with their number
std::vector<ScreenError> screen_errors(const xsharp::Scene& scene, std::span<const Choice> choices,
                                       double budget, std::uint64_t& frames,
                                       const std::atomic<bool>& stop,
                                       const std::function<void(std::uint64_t)>& frame_done);

}  // namespace fixproof::trade

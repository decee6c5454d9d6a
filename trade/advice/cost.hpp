/// @file
/// What a frame costs under each choice.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "trade/advice/choice.hpp"
#include "x86model/clocks.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::trade {

/// Of a frame, in clocks or in nanoseconds.
struct Cost {
  double least = 0;
  double most = 0;
  double ranked = 0;  ///< what choices are ranked by
  double spread = 0;  ///< of what ranks, from round to round: less than that is no difference
  std::optional<double> bus{};  ///< of an 8088; the others are at least as large
};

/// The frames that are looked at for clocks: so many in a row, so that delays of 2, 3 and 4 frames
/// have their share, at so many places of the first minute.
struct ClockSample {
  static constexpr std::uint64_t in_a_row = 12;
  static constexpr std::uint64_t places = 5;
  static constexpr std::uint64_t apart = 720;
};

/// The frames that are timed: the first minute, in every round anew.
struct TimeSample {
  static constexpr std::uint64_t frames = 3600;
  static constexpr std::uint64_t rounds = 15;
};

/// Clocks of the listings alone, not of the C around them, as the mean of a sample of frames. Two
/// numbers where the tables of clocks give a range, whose middle ranks. On an 8088 the larger of
/// table and bus time.
///
/// Restoring is counted after every rotation and shared out among the frames between two. From
/// scratch, an orientation is made in double, for which there is no table of clocks: it is counted
/// as what FIXED.ASM would need for it, one CosSin and the twelve products of a rotation for each
/// axis that turns.
///
/// @param counted called with how many choices are done
/// @return fewer than there are choices when `stop` ended the run
std::vector<Cost> clocks_a_frame(
    const xsharp::Scene& scene, std::span<const Choice> choices, x86model::Cpu cpu,
    const std::atomic<bool>& stop,
    const std::function<void(std::uint64_t)>& counted = [](std::uint64_t) {});

/// Nanoseconds of this processor for moving, transforming, projecting, hiding and sorting by the
/// type: the least and the median, which ranks, of rounds that take the choices in turn. The spread
/// is the third quartile less the first. Restoring is shared out as clocks are.
/// @return fewer than there are choices when `stop` ended the run
std::vector<Cost> nanoseconds_a_frame(const xsharp::Scene& scene, std::span<const Choice> choices,
                                      const std::atomic<bool>& stop);

}  // namespace fixproof::trade

/// @file
/// The cost of a frame under each choice.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "measure/trade/advice/choice.hpp"
#include "x86model/clocks.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::trade {

/// The cost per frame, in clocks or in nanoseconds.
struct Cost {
  double least = 0;
  double most = 0;
  double ranked = 0;            ///< the ranking compares this value
  double spread = 0;            ///< of `ranked` between rounds; smaller differences do not count
  std::optional<double> bus{};  ///< bus time on an 8088; the other figures are at least as large
};

/// The frames whose clocks are counted: `consecutive` consecutive frames, so that delays of 2, 3
/// and 4 frames have their share, at each of `places` points in the first minute.
struct ClockSample {
  static constexpr std::uint64_t consecutive = 12;
  static constexpr std::uint64_t places = 5;
  static constexpr std::uint64_t apart = 720;
};

/// The timed frames: the first minute, replayed in every round.
struct TimeSample {
  static constexpr std::uint64_t frames = 3600;
  static constexpr std::uint64_t rounds = 15;
};

/// Counts the clocks of the listings, without the C around them, as the mean of a sample of frames.
/// If the tables give a range, the ranking uses its middle. An 8088 takes the larger of table and
/// bus time.
///
/// Restorations are counted after every rotation and shared out among the frames between two of
/// them. From-scratch orientations use double, which has no clock table. They count as the
/// FIXED.ASM work: per turning axis, one CosSin and the twelve products of a rotation.
///
/// @param counted called with the number of finished choices
/// @return nothing if `stop` ended the run
std::vector<Cost> clocks_per_frame(
    const xsharp::Scene& scene, std::span<const Choice> choices, x86model::Cpu cpu,
    const std::atomic<bool>& stop,
    const std::function<void(std::uint64_t)>& counted = [](std::uint64_t) {});

/// Times moving, transforming, projecting, hiding and sorting with the type, in nanoseconds on this
/// processor. Each round times every choice in turn. The figures are the minimum and the median
/// over the rounds, and the median ranks. The spread is the interquartile range. Restorations are
/// shared out as in clocks_per_frame().
/// @return nothing if `stop` ended the run
std::vector<Cost> nanoseconds_per_frame(const xsharp::Scene& scene, std::span<const Choice> choices,
                                        const std::atomic<bool>& stop);

}  // namespace fixproof::trade

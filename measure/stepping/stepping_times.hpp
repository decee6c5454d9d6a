/// @file
/// Times the C++ loops and the setup of spans.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "measure/host/host_times.hpp"

namespace fixproof::measure {

/// The times of a loop per pixel, or of a setup per value.
struct SteppingTimes {
  std::string what;
  std::string of;  ///< "pixel" or "value"
  Times times;
};

/// Times spans of the longest length with xsharp::PlainLoops and the loops that it lacks, as
/// compiled here.
/// @param timed called with the number of finished rounds
/// @return nothing if `stop` ended the run
/// @throws WrongContender if a loop's pixels differ from multiplying for each pixel
std::vector<SteppingTimes> time_stepping(std::uint64_t seed, std::uint64_t rounds,
                                         const std::atomic<bool>& stop,
                                         const std::function<void(std::uint64_t)>& timed);

/// Nanoseconds per pixel of a stepping variant, including its share of the setup of a span of 160
/// pixels: the sum of the minimum times of its parts. Empty if its arithmetic was not timed.
std::optional<double> nanoseconds_per_pixel(const std::string& value, const std::string& rule,
                                            const std::vector<SteppingTimes>& times);

}  // namespace fixproof::measure

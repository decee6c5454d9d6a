/// @file
/// Nanoseconds of the loops in C++, and of what a span begins with.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "measure/host/host_times.hpp"

namespace fixproof::measure {

/// Of one loop a pixel; of what a span begins with a value.
struct SteppingTimes {
  std::string what;
  std::string of;  ///< "pixel" or "value"
  Times times;
};

/// Spans of the most pixels, of xsharp::PlainLoops and what it lacks, as they are compiled here.
/// @param timed is told how many rounds are done
/// @return nothing where `stop` ended the run
/// @throws WrongContender for a loop whose pixels are not what a multiplication makes of each
std::vector<SteppingTimes> time_stepping(std::uint64_t seed, std::uint64_t rounds,
                                         const std::atomic<bool>& stop,
                                         const std::function<void(std::uint64_t)>& timed);

/// Nanoseconds a pixel of a way of stepping, with its share of what a span of 160 pixels begins
/// with: the sum of the least times of its parts. Nothing where its arithmetic is not what was
/// timed.
std::optional<double> nanoseconds_a_pixel(const std::string& value, const std::string& rule,
                                          const std::vector<SteppingTimes>& times);

}  // namespace fixproof::measure

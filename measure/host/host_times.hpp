/// @file
/// How long loops take, timed in turn: what slows the machine for a while slows all alike.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "support/json.hpp"

namespace fixproof::measure {

/// What this thread has used of its processor. What others take meanwhile does not count.
std::chrono::nanoseconds thread_time();

/// Of many samples, in nanoseconds of processor time of one operation.
struct Times {
  double min = 0;
  double median = 0;
  double spread = 0;  ///< the third quartile less the first, by the median
};

/// {min, median, spread}
support::Json to_json(const Times& times);

/// @param samples at least one, in any order
Times times_of(std::vector<double> samples);

/// A loop to be timed.
struct TimedLoop {
  std::function<void()> pass;
  std::size_t operations;  ///< of a pass
};

/// The times of every loop, from so many rounds in which each is timed once, for about a
/// millisecond, after a pass that is not.
/// @return nothing where `stop` ended the run; `done` is told how many rounds are done
std::vector<Times> time_in_turn(const std::vector<TimedLoop>& loops, std::uint64_t rounds,
                                const std::atomic<bool>& stop,
                                const std::function<void(std::uint64_t)>& done);

}  // namespace fixproof::measure

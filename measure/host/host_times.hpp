/// @file
/// Times loops in turn, so that a slow phase of the machine affects all of them.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <vector>

#include "support/json.hpp"

namespace fixproof::measure {

/// The processor time of this thread. Other threads and processes do not count.
std::chrono::nanoseconds thread_time();

/// Timed code breaks its documented rule; what() names the case.
class WrongContender : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Statistics of samples, in nanoseconds of processor time per operation.
struct Times {
  double min = 0;
  double median = 0;
  double spread = 0;  ///< interquartile range over the median
};

/// {min, median, spread}
void to_json(support::Json& json, const Times& times);

/// @param samples at least one, in any order
Times times_of(std::vector<double> samples);

struct TimedLoop {
  std::function<void()> pass;
  std::size_t operations;  ///< per pass
};

/// Times every loop once per round, for about a millisecond after an untimed pass.
/// @param done called with the number of finished rounds
/// @return nothing if `stop` ended the run
std::vector<Times> time_in_turn(const std::vector<TimedLoop>& loops, std::uint64_t rounds,
                                const std::atomic<bool>& stop,
                                const std::function<void(std::uint64_t)>& done);

}  // namespace fixproof::measure

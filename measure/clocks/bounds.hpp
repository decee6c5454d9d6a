/// @file
/// Clock counts that are known within bounds.
#pragma once

#include <algorithm>

namespace fixproof::measure {

/// A figure that lies between two values, both included.
struct Bounds {
  double min = 0;
  double max = 0;
};

/// The clocks of some code on one processor.
struct Clocks {
  Bounds table;    ///< by Intel's table, which gives ranges in places
  double bus = 0;  ///< on an 8088, see x86model/bus.hpp; 0 on other processors

  /// An 8088 executes and fetches at the same time: it takes at least the larger of the two times.
  [[nodiscard]] Bounds at_least() const {
    return {std::max(table.min, bus), std::max(table.max, bus)};
  }
  /// Which of the two times is certainly the larger: `bus` or `table`.
  [[nodiscard]] const char* limit() const { return bus > table.max ? "bus" : "table"; }
};

}  // namespace fixproof::measure

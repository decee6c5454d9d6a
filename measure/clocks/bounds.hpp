/// @file
/// Clock counts with lower and upper bounds.
#pragma once

#include <algorithm>

namespace fixproof::measure {

/// A range with both ends included.
struct Bounds {
  double min = 0;
  double max = 0;
};

/// The clocks of some code on one processor.
struct Clocks {
  Bounds table;    ///< by Intel's table, which gives ranges in places
  double bus = 0;  ///< on an 8088, see x86model/bus.hpp; 0 on other processors

  /// An 8088 fetches while it executes, so it takes at least the larger of the two times.
  [[nodiscard]] Bounds at_least() const {
    return {std::max(table.min, bus), std::max(table.max, bus)};
  }
  /// The time that is certainly the larger: `bus` or `table`.
  [[nodiscard]] const char* limit() const { return bus > table.max ? "bus" : "table"; }
};

}  // namespace fixproof::measure

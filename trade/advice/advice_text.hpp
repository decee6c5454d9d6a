/// @file
/// Advice as people and as programs read it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "trade/advice/advice.hpp"
#include "x86model/clocks.hpp"

namespace fixproof::trade {

/// All that was asked and found.
struct AdviceReport {
  std::string scene;
  std::uint64_t frames = 0;  ///< done
  double budget = 0;         ///< in pixels
  /// Whose clocks were counted; without one, costs are nanoseconds of this processor.
  std::optional<x86model::Cpu> cpu{};
  bool repaired = false;       ///< whether 8088 code has ConcatXforms repaired
  std::vector<Tried> tried{};  ///< sorted by cost
  /// Of what to take: the worst of the motion alone, as `drift` measures it over the same frames.
  std::optional<double> drift_pixels{};
};

/// Frames a second, for which times stand.
inline constexpr std::uint64_t advised_rate = 60;

/// A row for every choice, the cheapest first.
std::string table_of(const AdviceReport& report);

/// What to take, in sentences.
std::string sentences_of(const AdviceReport& report);

/// made: {command, compiler, date; processor: null where clocks are counted}. worst_pixels is null
/// where the projection has no place for a corner, infinitely far off: JSON has no such number.
std::string json_of(const AdviceReport& report);

}  // namespace fixproof::trade

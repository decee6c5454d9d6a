/// @file
/// Which choice to take.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "support/json.hpp"
#include "trade/advice/choice.hpp"
#include "trade/advice/cost.hpp"
#include "trade/advice/screen_error.hpp"
#include "x86model/clocks.hpp"

namespace fixproof::trade {

/// A choice, what it costs and how far off it is.
struct Tried {
  Choice choice{};
  Cost cost{};
  ScreenError error{};
};

/// Whether a difference is within the spread of both: one noisy time is not the same as all.
bool costs_the_same(const Cost& a, const Cost& b);

/// Cheapest first; of two that cost the same, the one that is less far off.
void sort_by_cost(std::vector<Tried>& tried);

/// Places in what was tried, sorted by cost.
struct Advice {
  /// The cheapest within the budget: of those that cost as little, the least far off.
  std::optional<std::size_t> take;
  std::optional<std::size_t> runner_up;     ///< the same of the others
  std::optional<std::size_t> next_cheaper;  ///< the dearest that is cheaper; all those are over
  std::size_t as_cheap = 0;                 ///< others within the budget that cost as little
  std::size_t nearest = 0;                  ///< the one that is least far off
};

/// @param tried at least one, sorted by cost
Advice advise(std::span<const Tried> tried, double budget);

/// Everything that was asked and found.
struct AdviceReport {
  std::string scene;
  std::uint64_t frames = 0;  ///< measured
  double budget = 0;         ///< in pixels
  /// The processor whose clocks were counted; nothing if costs are nanoseconds of this processor.
  std::optional<x86model::Cpu> cpu{};
  bool repaired = false;       ///< 8088 code has the repaired ConcatXforms
  std::vector<Tried> tried{};  ///< sorted by cost
  /// The largest error of the advised choice's motion alone, as `drift` measures it.
  std::optional<double> drift_pixels{};
};

/// Frames per second.
inline constexpr std::uint64_t advised_rate = 60;

/// `clocks a frame` or `ns a frame`
inline const char* cost_unit(const AdviceReport& report) {
  return report.cpu ? "clocks a frame" : "ns a frame";
}

/// made: {command, compiler, date; processor: null if clocks are counted}. worst_pixels is null if
/// a divide error leaves a corner without a place: JSON has no number for an infinite error.
support::Json to_json(const AdviceReport& report);

}  // namespace fixproof::trade

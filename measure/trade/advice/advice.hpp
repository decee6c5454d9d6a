/// @file
/// The recommendation of `advise`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "measure/trade/advice/choice.hpp"
#include "measure/trade/advice/cost.hpp"
#include "measure/trade/advice/screen_error.hpp"
#include "support/json.hpp"
#include "x86model/clocks.hpp"

namespace fixproof::trade {

struct Tried {
  Choice choice{};
  Cost cost{};
  ScreenError error{};
};

/// Whether the difference is within the smaller spread of the two, so that one noisy measurement
/// does not make everything equal.
bool has_equal_cost(const Cost& a, const Cost& b);

/// Sorts by cost; of equal costs, the smaller error comes first.
void sort_by_cost(std::vector<Tried>& tried);

/// Indices into the tried choices, which are sorted by cost.
struct Advice {
  /// The cheapest choice within the budget; of those that cost the same, the most accurate.
  std::optional<std::size_t> take;
  std::optional<std::size_t> runner_up;  ///< the best of the remaining choices within the budget
  std::optional<std::size_t>
      next_cheaper;  ///< the dearest cheaper choice; every cheaper one is over budget
  std::size_t equal_cost_count = 0;  ///< how many others within the budget cost the same
  std::size_t nearest = 0;           ///< the choice with the smallest error
};

/// @param tried at least one, sorted by cost
Advice advise(std::span<const Tried> tried, double budget);

struct AdviceReport {
  std::string scene;
  std::uint64_t frames = 0;  ///< measured
  double budget = 0;         ///< in pixels
  /// The processor whose clocks were counted; nothing if costs are nanoseconds of this processor.
  std::optional<x86model::Cpu> cpu{};
  bool repaired = false;       ///< 8088 code has the repaired ConcatXforms
  std::vector<Tried> tried{};  ///< sorted by cost
  /// The largest error from the motion of the advised choice alone, as `drift` measures it.
  std::optional<double> drift_pixels{};
};

/// Frames per second.
inline constexpr std::uint64_t advised_rate = 60;

/// `clocks a frame` or `ns a frame`
inline const char* cost_unit(const AdviceReport& report) {
  return report.cpu ? "clocks a frame" : "ns a frame";
}

/// made: {command, compiler, date; processor: null if clocks are counted}. worst_pixels is null if
/// a divide error leaves a corner without a position, because JSON has no infinity.
void to_json(support::Json& json, const AdviceReport& report);

}  // namespace fixproof::trade

/// @file
/// Which choice to take.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "trade/advice/choice.hpp"
#include "trade/advice/cost.hpp"
#include "trade/advice/screen_error.hpp"

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

}  // namespace fixproof::trade

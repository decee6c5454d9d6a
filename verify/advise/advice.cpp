#include "verify/advise/advice.hpp"

#include <algorithm>

namespace fixproof {

void sort_by_cost(std::vector<Tried>& tried) {
  std::ranges::stable_sort(tried, [](const Tried& a, const Tried& b) {
    const double difference = a.cost.ranked - b.cost.ranked;
    return difference < 0 || (difference == 0 && a.error.pixels < b.error.pixels);
  });
}

Advice advise(std::span<const Tried> tried, double budget) {
  Advice advice;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    if (tried[i].error.pixels < tried[advice.nearest].error.pixels) advice.nearest = i;
    if (tried[i].error.pixels > budget) continue;
    if (!advice.take) {
      advice.take = i;
      if (i > 0) advice.next_cheaper = i - 1;
    } else if (!advice.runner_up) {
      advice.runner_up = i;
    }
  }
  return advice;
}

}  // namespace fixproof

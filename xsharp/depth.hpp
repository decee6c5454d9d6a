/// @file
/// Depth sorting.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <span>
#include <vector>

namespace xsharp {

/// Sorts `order`, indices into `depths`, by ascending depth: view z, so the farthest first. The
/// sort is stable.
///
/// Uses insertion sort, because little changes from one frame to the next: n steps and one more per
/// swapped pair. Beyond about 8 n log2 n steps a merge sort takes over and finds the same order,
/// because insertion has left objects of equal depth in place.
template <class N>
void sort_by_depth(std::vector<std::size_t>& order, std::span<const N> depths) {
  const auto bits = static_cast<int>(std::bit_width(order.size()));
  const std::size_t most = 8 * order.size() * static_cast<std::size_t>(bits);
  std::size_t moves = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::size_t moved = order[i];
    std::size_t place = i;
    for (; place > 0 && depths[moved] < depths[order[place - 1]]; --place) {
      order[place] = order[place - 1];
    }
    order[place] = moved;
    moves += i - place;
    if (moves <= most) continue;
    std::stable_sort(order.begin(), order.end(),
                     [&depths](std::size_t a, std::size_t b) { return depths[a] < depths[b]; });
    return;
  }
}

}  // namespace xsharp

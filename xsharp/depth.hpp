/// @file
/// Depth sorting.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace xsharp {

/// Sorts `order`, indices into `depths`, by ascending depth: view z, so the farthest first. Objects
/// of equal depth keep their places. By insertion: from one frame to the next little changes.
template <class N>
void sort_by_depth(std::vector<std::size_t>& order, std::span<const N> depths) {
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::size_t moved = order[i];
    std::size_t place = i;
    for (; place > 0 && depths[moved] < depths[order[place - 1]]; --place) {
      order[place] = order[place - 1];
    }
    order[place] = moved;
  }
}

}  // namespace xsharp

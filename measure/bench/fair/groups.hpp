/// @file
/// All groups of contenders, from three files that are compiled by themselves.
#pragma once

#include <vector>

#include "measure/bench/fair/contender.hpp"

namespace fair {

inline Sizes batch_sizes() {
  return {{1, 0},  {4, 0},   {8, 0},    {15, 0},   {16, 0},    {31, 0},       {64, 0},
          {64, 4}, {64, 16}, {4096, 0}, {4096, 4}, {4096, 16}, {1'000'000, 0}};
}

void add_arithmetic(std::vector<Group>& to);
void add_angles(std::vector<Group>& to);
void add_sums(std::vector<Group>& to);

}  // namespace fair

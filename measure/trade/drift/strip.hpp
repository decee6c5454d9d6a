/// @file
/// Pictures of one object after long rotations under several arithmetics.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "xsharp/scene.hpp"

namespace fixproof::trade {

struct StripRow {
  std::string name;
  xsharp::Scene scene;  ///< under its own arithmetic
};

/// Returns an SVG with a row for each arithmetic and a column for each of `frames`. The object
/// stays centreed in its cell and has the orientation of the scene.
/// @param labels one for each column
std::string drift_strip(const std::vector<StripRow>& rows, std::size_t object,
                        const std::vector<std::uint64_t>& frames,
                        const std::vector<std::string>& labels);

}  // namespace fixproof::trade

/// @file
/// The same object after a while under several arithmetics, as a picture.
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

/// An SVG: a row for each arithmetic, a column for each of `frames`; the object stands still in the
/// middle of its field, turned as in the scene.
/// @param labels one for each column
std::string drift_strip(const std::vector<StripRow>& rows, std::size_t object,
                        const std::vector<std::uint64_t>& frames,
                        const std::vector<std::string>& labels);

}  // namespace fixproof::trade

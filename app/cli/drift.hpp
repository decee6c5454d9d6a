/// @file
/// The drift experiment of `fixproof drift` and the report.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "measure/trade/drift/run.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::cli {

struct DriftRequest {
  std::uint64_t minutes = 30;       ///< length of the animation at 60 frames per second
  std::int32_t restore_every = 60;  ///< rotations between restorations of orthogonality
  std::size_t object = 0;           ///< index of the object in the strip
};

/// Shows progress on the terminal and stops early when support::Interrupt::flag() is set. Ignores
/// the scene's own settings for restoring orthogonality.
/// @param scene must have at least one object
trade::DriftFigures measure_drift(const xsharp::Scene& scene, const DriftRequest& request);

/// Returns an SVG of one object after 0, 1, 5, 15 and 30 minutes in each arithmetic.
std::string drift_strip(const xsharp::Scene& scene, const DriftRequest& request);

}  // namespace fixproof::cli

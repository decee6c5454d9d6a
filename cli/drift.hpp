/// @file
/// The drift experiment, as `fixproof drift` and the report run it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "support/json.hpp"
#include "trade/drift/run.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::cli {

struct DriftRequest {
  std::uint64_t minutes = 30;       ///< of animation at 60 frames per second
  std::int32_t restore_every = 60;  ///< rotations, in the cases that restore orthogonality
  std::size_t object = 0;           ///< the object that the strip shows, by its index
};

struct DriftFigures {
  std::string scene;
  std::uint64_t frames = 0;  ///< drawn; fewer than wanted after an interrupt
  std::uint64_t wanted = 0;
  std::vector<trade::DriftCase> cases;
  std::vector<trade::DriftResult> results;  ///< one for each case

  [[nodiscard]] bool complete() const { return frames == wanted; }
};

/// Shows its progress on the terminal, and stops early when support::Interrupt::flag() is set. The
/// scene's own way of restoring orthogonality does not apply.
/// @param scene with at least one object
DriftFigures measure_drift(const xsharp::Scene& scene, const DriftRequest& request);

support::Json to_json(const DriftFigures& figures);

/// An SVG of one object after 0, 1, 5, 15 and 30 minutes under each arithmetic.
std::string drift_strip(const xsharp::Scene& scene, const DriftRequest& request);

}  // namespace fixproof::cli

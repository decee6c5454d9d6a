/// @file
/// The drift experiment: how objects deform during long rotations.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "measure/trade/drift/distortion.hpp"
#include "support/json.hpp"
#include "verify/cases/build.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::trade {

/// A source of error that a run leaves out.
enum class Without {
  nothing,
  offset,    ///< the published conversion's unit: constants are rounded to nearest
  step,      ///< the rounding of sines and cosines, including the offset
  products,  ///< the rounding of products
  all,       ///< all three
};

struct DriftCase {
  /// Only the target and `mul_round` count: rotations neither divide nor overflow.
  cases::Build build{};
  Without without = Without::nothing;
  std::int32_t restore_every = 0;
  bool from_scratch = false;
  xsharp::RestoredRows restore_rows = xsharp::RestoredRows::all;
};

/// `8088 off, without step, restored every 60`
std::string name_of(const DriftCase& c);

/// The distortions whose first frame is reported.
struct Thresholds {
  static constexpr double pixels = 1;
  static constexpr double some = 0.02;
  static constexpr double much = 0.10;
};

/// Points in the time series of a case.
inline constexpr std::uint64_t series_points = 200;

/// Frames that one point stands for.
constexpr std::uint64_t frames_a_point(std::uint64_t frames) {
  return (frames + series_points - 1) / series_points;
}

struct DriftResult {
  DriftCase of{};
  Distortion worst{};
  /// Point i is the worst of frames i * frames_a_point() and following; the last may have fewer.
  std::vector<Distortion> series{};
  /// First frames at which a vertex is a pixel off; an edge 2 %, 10 % too long or short.
  std::optional<std::uint64_t> pixel{};
  std::optional<std::uint64_t> some{};
  std::optional<std::uint64_t> much{};
};

struct DriftFigures {
  std::string scene;
  std::uint64_t rate = 0;    ///< frames per second, to convert frames to times
  std::uint64_t frames = 0;  ///< frames done; less than `wanted` after an interrupt
  std::uint64_t wanted = 0;
  std::vector<DriftResult> results;

  [[nodiscard]] bool complete() const { return frames == wanted; }
};

void to_json(support::Json& json, const DriftFigures& figures);

/// Runs all cases side by side over the same frames, on all processors.
/// @param frames the number of frames; if `stop` ends the run early, the number that were done
/// @param frames_done called with the number of frames done, now and then
/// @return one result for each case
std::vector<DriftResult> run_drift(const xsharp::Scene& scene, const std::vector<DriftCase>& cases,
                                   std::uint64_t& frames, const std::atomic<bool>& stop,
                                   const std::function<void(std::uint64_t)>& frames_done);

}  // namespace fixproof::trade

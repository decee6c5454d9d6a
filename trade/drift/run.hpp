/// @file
/// The stability experiment: what becomes of the objects of a scene that turn for a long time.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trade/drift/distortion.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::trade {

/// Which multiply the rotations are made with. Divides and overflow play no part in them.
enum class Multiply { i386_on, i386_off, i8088_on, i8088_off };

/// What is left out of a run.
enum class Without {
  nothing,
  offset,    ///< the published conversion's unit: constants are rounded to nearest
  step,      ///< the rounding of sines and cosines, and the offset with it
  products,  ///< the rounding of products
  all,       ///< all three
};

/// One row of the table.
struct DriftCase {
  Multiply multiply = Multiply::i386_on;
  Without without = Without::nothing;
  std::int32_t restore_every = 0;
  bool from_scratch = false;
  xsharp::RestoredRows restore_rows = xsharp::RestoredRows::all;
};

std::string name_of(Multiply multiply);
std::string name_of(Without without);
std::string name_of(const DriftCase& c);

/// Which distortion is looked for the first time.
struct Thresholds {
  static constexpr double pixels = 1;
  static constexpr double some = 0.02;
  static constexpr double much = 0.10;
};

/// How many points a case's way through time has.
inline constexpr std::uint64_t series_points = 200;

/// How many frames one of them stands for.
constexpr std::uint64_t frames_a_point(std::uint64_t frames) {
  return (frames + series_points - 1) / series_points;
}

struct DriftResult {
  Distortion worst{};
  /// Point i is the worst of frames_a_point() frames, from the i-th such; the last may be of fewer.
  std::vector<Distortion> series;
  /// First frames at which a vertex is a pixel off; an edge 2 %, 10 % too long or short.
  std::optional<std::uint64_t> pixel;
  std::optional<std::uint64_t> some;
  std::optional<std::uint64_t> much;
};

/// Every case, side by side over the same frames. `frame_done` is called after each, with their
/// number. @return one result for each case; @param frames is set to the number done when `stop`
/// ended the run before its time
std::vector<DriftResult> run_drift(const xsharp::Scene& scene, const std::vector<DriftCase>& cases,
                                   std::uint64_t& frames, const std::atomic<bool>& stop,
                                   const std::function<void(std::uint64_t)>& frame_done);

}  // namespace fixproof::trade

/// @file
/// What `fixproof measure` can measure. Each function prints its tables, writes the file that was
/// asked for, and returns the exit status.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "xsharp/scene.hpp"

namespace fixproof::trade {

/// What was asked, whatever is measured.
struct MeasureRequest {
  std::vector<std::string> scenes;     ///< files whose operands are recorded
  std::uint64_t seed = 1994;           ///< of random operands
  std::optional<std::uint64_t> cases;  ///< random cases of one kind; by default as many as serve
  std::uint64_t rounds = 101;          ///< in which every loop is timed
  std::string json;                    ///< a file for the same figures; empty for none
};

/// The scenes that were asked for. Before anything long begins it is known that the file can be
/// written, and is none of theirs.
/// @throws xsharp::SceneError for a scene that is refused, UsageError for such a file,
///         std::runtime_error for one that cannot be written
std::vector<xsharp::Scene> read_scenes(const MeasureRequest& request);

int measure_accuracy(const MeasureRequest& request);
int measure_clocks(const MeasureRequest& request);
int measure_host(const MeasureRequest& request);
int measure_stepping(const MeasureRequest& request);

}  // namespace fixproof::trade

/// @file
/// How a scene uses the arithmetic while it runs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "measure/player/model_call.hpp"
#include "measure/trade/profile/value_range.hpp"
#include "support/json.hpp"
#include "verify/cases/variant.hpp"
#include "x86model/assemble.hpp"
#include "xsharp/player.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::trade {

/// Statistics of the calls of one routine. Values are in units of 2^-16, angles in tenths of a
/// degree.
struct RoutineProfile {
  cases::Variant variant{};
  x86model::Program program{};
  std::uint64_t calls = 0;
  std::uint64_t least_in_frame = 0;
  std::uint64_t max_in_frame = 0;
  std::uint64_t instructions = 0;
  std::uint64_t faults = 0;
  /// Calls with a result that does not fit in 32 bits.
  std::uint64_t wrapped = 0;
  std::vector<ValueRange> operands;  ///< indexed like operand_names()
  std::vector<ValueRange> results;   ///< indexed like result_names()
  std::vector<bool> executed;        ///< one for each instruction of the program
};

/// How close the divides come to a divide error.
struct DivideProfile {
  std::optional<std::int64_t> least_divisor;      ///< smallest magnitude, in units of 2^-16
  std::optional<std::int64_t> greatest_quotient;  ///< largest magnitude, in units of 2^-16
};

/// Visible vertices and faces over all objects and frames.
struct ViewProfile {
  std::optional<std::int32_t> nearest;  ///< greatest view-space z of an unclipped vertex
  std::uint64_t faces = 0;              ///< of objects within range
  std::uint64_t clipped_faces = 0;      ///< those with a corner outside the clip volume
  std::uint64_t out_of_reach = 0;       ///< objects too far away to be drawn
};

struct SceneProfile {
  std::string scene;  ///< its name
  xsharp::ArithmeticChoice arithmetic{};
  std::uint64_t frames = 0;
  std::vector<RoutineProfile> routines;
  DivideProfile divides{};
  ViewProfile view{};
};

/// Profiles a run of the model.
class Profiler {
 public:
  /// @param choice must select a listing
  Profiler(const xsharp::Scene& scene, const xsharp::ArithmeticChoice& choice);

  /// Adds one frame.
  /// @param log the calls of the frame
  /// @param player in its state after drawing the frame
  void add(const player::OperandLog& log, const xsharp::Player& player);

  [[nodiscard]] const SceneProfile& profile() const { return profile_; }

 private:
  void add_view(const xsharp::Player& player);

  const xsharp::Scene& scene_;
  SceneProfile profile_;
};

/// The instruction forms of the processor's listings, by whether the scene executed them. Sorted.
struct FormUse {
  std::vector<std::string> executed;
  std::vector<std::string> never;
};
FormUse forms_of(const SceneProfile& profile);

/// {made: {command, compiler, date}, scene, ...}
void to_json(support::Json& json, const SceneProfile& profile);

}  // namespace fixproof::trade

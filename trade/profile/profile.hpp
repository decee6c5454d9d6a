/// @file
/// What a scene asks of the arithmetic while it runs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cases/variant.hpp"
#include "player/model_call.hpp"
#include "support/json.hpp"
#include "trade/profile/value_range.hpp"
#include "x86model/assemble.hpp"
#include "xsharp/player.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::trade {

/// The calls of one routine. Values are in units of 2^-16, angles in tenths of a degree.
struct RoutineProfile {
  cases::Variant variant{};
  x86model::Program program{};
  std::uint64_t calls = 0;
  std::uint64_t least_in_frame = 0;
  std::uint64_t most_in_frame = 0;
  std::uint64_t instructions = 0;
  std::uint64_t faults = 0;
  /// Calls of which some result does not fit.
  std::uint64_t wrapped = 0;
  std::vector<ValueRange> operands;  ///< as operand_names()
  std::vector<ValueRange> results;   ///< as result_names()
  std::vector<bool> executed;        ///< of the instructions of the program
};

/// How near a divide error is.
struct DivideProfile {
  std::optional<std::int64_t> least_divisor;      ///< by magnitude, in units of 2^-16
  std::optional<std::int64_t> greatest_quotient;  ///< the same
};

/// Vertices and faces before the viewer, over all objects and frames.
struct ViewProfile {
  std::optional<std::int32_t> nearest;  ///< greatest view z of a vertex that is not clipped
  std::uint64_t faces = 0;              ///< of objects within reach
  std::uint64_t clipped_faces = 0;      ///< of these, with a corner outside the clip volume
  std::uint64_t out_of_reach = 0;       ///< objects too far away to be drawn
};

struct SceneProfile {
  xsharp::ArithmeticChoice arithmetic{};
  std::uint64_t frames = 0;
  std::vector<RoutineProfile> routines;
  DivideProfile divides{};
  ViewProfile view{};
};

/// Takes part in a run of the model.
class Profiler {
 public:
  /// @param choice the arithmetic, of the model
  Profiler(const xsharp::Scene& scene, const xsharp::ArithmeticChoice& choice);

  /// One frame: its calls, and the player after it has been drawn.
  void add(const player::OperandLog& log, const xsharp::Player& player);

  [[nodiscard]] const SceneProfile& profile() const { return profile_; }

 private:
  void add_view(const xsharp::Player& player);

  const xsharp::Scene& scene_;
  SceneProfile profile_;
};

/// Forms of instructions of the listings for the processor, by what the scene made of them. Sorted.
struct FormUse {
  std::vector<std::string> executed;
  std::vector<std::string> never;
};
FormUse forms_of(const SceneProfile& profile);

/// {made: {command, compiler, date}, scene, ...}
/// @param scene the name of the scene
support::Json to_json(const SceneProfile& profile, const std::string& scene);

}  // namespace fixproof::trade

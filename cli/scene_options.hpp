/// @file
/// The options of the commands that draw a scene: which one, and with what arithmetic.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "xsharp/scene.hpp"

namespace fixproof::cli {

/// What was given on the command line; what was not given is the scene's.
struct SceneOptions {
  std::string file;
  std::optional<std::string> by;
  std::optional<std::string> target;
  std::optional<bool> mul_round;
  std::optional<bool> div_round;
  bool repaired = false;
  std::optional<std::int32_t> restore_every;
  std::optional<std::string> restore_rows;
  bool from_scratch = false;

  /// Adds SCENE, --arith, --target, --round, --mul-round, --div-round, --repaired, --reortho,
  /// --reortho-rows and --from-scratch.
  void add_to(CLI::App& command);

  /// The scene as it is to be drawn.
  /// @throws xsharp::SceneError for a scene that is refused, UsageError for options that contradict
  ///         one another
  [[nodiscard]] xsharp::Scene read() const;
  /// The same for a scene that is read already.
  [[nodiscard]] xsharp::Scene applied_to(xsharp::Scene scene) const;
};

}  // namespace fixproof::cli

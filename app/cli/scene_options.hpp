/// @file
/// Options that select a scene and its arithmetic.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "xsharp/scene.hpp"

namespace fixproof::cli {

/// @throws UsageError if the scene has no objects
void require_objects(const xsharp::Scene& scene);

/// The scene options of a command line. Options that are not given keep the scene's settings.
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
  std::optional<std::uint64_t> frames;

  /// Adds the options to a command, which must not outlive this object.
  void add_to(CLI::App& command);

  /// Reads the scene and applies the options.
  /// @throws xsharp::SceneError if the scene is invalid or cannot be read, UsageError if options
  ///         contradict each other
  [[nodiscard]] xsharp::Scene read() const;
  /// Returns the number of frames to draw: by default ten seconds, and at least one.
  [[nodiscard]] std::uint64_t frame_count(const xsharp::Scene& scene) const;
  /// Applies the options to a scene. Throws as read() does.
  [[nodiscard]] xsharp::Scene applied_to(xsharp::Scene scene) const;
};

}  // namespace fixproof::cli

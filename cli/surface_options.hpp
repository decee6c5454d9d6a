/// @file
/// The options that choose a variant of a scene's surfaces.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>

#include "xsharp/scene.hpp"

namespace fixproof::cli {

/// What was given on the command line; what was not given is the scene's.
struct SurfaceOptions {
  std::optional<xsharp::SurfaceKind> kind;
  std::optional<xsharp::PhongForm> phong;
  std::optional<std::int32_t> exact_every;
  std::optional<xsharp::DepthBuffering> depth_buffer;
  std::optional<xsharp::DepthMeasure> depth_measure;

  /// Adds --surface, --phong, --texture-every, --depth-buffer and --depth-measure.
  void add_to(CLI::App& command);

  /// Changes the scene.
  /// @throws UsageError for a scene that has no such surface, or is refused with it
  void apply(xsharp::Scene& scene) const;
};

}  // namespace fixproof::cli

/// @file
/// Options that change the surfaces of a scene.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>

#include "xsharp/scene.hpp"

namespace fixproof::cli {

/// The surface options of a command line. Options that are not given keep the scene's settings.
struct SurfaceOptions {
  std::optional<xsharp::SurfaceKind> kind;
  std::optional<xsharp::PhongForm> phong;
  std::optional<std::int32_t> exact_every;
  std::optional<xsharp::DepthBuffering> depth_buffer;
  std::optional<xsharp::DepthMeasure> depth_measure;

  /// Adds the options to a command, which must not outlive this object.
  void add_to(CLI::App& command);

  /// Applies the options to a scene.
  /// @throws UsageError if the scene lacks the surface or depth buffer that an option needs, or if
  ///         the changed scene is invalid
  void apply(xsharp::Scene& scene) const;
};

}  // namespace fixproof::cli

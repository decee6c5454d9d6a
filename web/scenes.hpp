/// @file
/// The scenes of the page. write_scenes.py writes their source from scenes/ during the build.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "xsharp/scene.hpp"

namespace fixproof::web {

inline constexpr std::size_t scene_count = 7;

/// The files of scenes/, without their ending.
extern const std::array<std::string_view, scene_count> scene_names;

/// The first scene for an index beyond the last.
xsharp::Scene scene_at(std::size_t index);

}  // namespace fixproof::web

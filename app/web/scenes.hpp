/// @file
/// The scenes of the page. During the build, write_scenes.py generates their source from
/// xsharp/scenes/.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "xsharp/scene.hpp"

namespace fixproof::web {

inline constexpr std::size_t scene_count = 7;

/// The names of the files in xsharp/scenes/, without the extension.
extern const std::array<std::string_view, scene_count> scene_names;

/// Returns a scene, or the first one if the index is beyond the last.
xsharp::Scene scene_at(std::size_t index);

}  // namespace fixproof::web

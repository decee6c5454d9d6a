/// @file
/// Scenes from JSON; docs/scenes.md states the format.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "xsharp/scene.hpp"
#include "xsharp/scene_error.hpp"

namespace xsharp {

/// A scene that validate() accepts, from a file of up to 1 MiB. A scene without a name is named
/// after the file.
/// @throws SceneError naming the file and the place in it; that the file cannot be read is one too
Scene read_scene(const std::filesystem::path& file);

/// The same from the text of a file.
/// @param name   of the scene, unless the text has one
/// @param folder where the files that the text names are
/// @throws SceneError naming the place
Scene parse_scene(std::string_view text, const std::string& name,
                  const std::filesystem::path& folder);

}  // namespace xsharp

/// @file
/// Reads scenes from JSON; docs/scenes.md states the format.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "xsharp/scene.hpp"
#include "xsharp/scene_error.hpp"

namespace xsharp {

/// Reads a scene that validate() accepts, from a file of up to 16 MiB. A scene without a name gets
/// that of the file.
/// @throws SceneError with the file and the position in it, also if the file cannot be read
Scene read_scene(const std::filesystem::path& file);

/// The same from the text of a file.
/// @param name   of the scene, unless the text has one
/// @param folder of the files that the text names
/// @throws SceneError with the position
Scene parse_scene(std::string_view text, const std::string& name,
                  const std::filesystem::path& folder);

}  // namespace xsharp

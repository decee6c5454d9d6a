/// @file
/// A whole file of bounded size.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace xsharp {

/// What the file holds. @throws SceneError saying why not, without its name: not a regular file,
/// not to be read, longer than `most` bytes
std::string read_text(const std::filesystem::path& file, std::size_t most);

}  // namespace xsharp

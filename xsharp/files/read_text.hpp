/// @file
/// Reads a whole file of bounded size.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace xsharp {

/// The contents of a file. @throws SceneError with the reason, without the file name, if it is not
/// a regular file, cannot be read, or is longer than `most` bytes
std::string read_text(const std::filesystem::path& file, std::size_t most);

}  // namespace xsharp

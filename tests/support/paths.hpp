/// @file
/// Where the tree and its build are. Their names stand in paths.cpp alone: every other file
/// compiles to the same object in every clone, so ccache has it.
#pragma once

#include <string>

namespace paths {

/// A file of the tree, as in `source("xsharp/scenes/solid.json")`.
[[nodiscard]] std::string source(const std::string& file);

/// A file of the build.
[[nodiscard]] std::string built(const std::string& file);

/// `fixproof`.
[[nodiscard]] inline std::string command() { return built("fixproof"); }

/// A file of `xsharp/scenes/`.
[[nodiscard]] inline std::string scene(const std::string& file) {
  return source("xsharp/scenes/" + file);
}

}  // namespace paths

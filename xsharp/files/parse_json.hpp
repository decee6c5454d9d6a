/// @file
/// JSON with comments, strictly.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace xsharp {

/// @throws SceneError for what is not JSON with comments, has a key twice, or is nested deeper than
///         any scene
nlohmann::json parse_json(std::string_view text);

}  // namespace xsharp

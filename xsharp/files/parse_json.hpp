/// @file
/// Strict parsing of JSON with comments.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace xsharp {

/// @throws SceneError if the text is not JSON with comments, has a zero byte, has a duplicate key,
/// or is nested deeper than any scene
nlohmann::json parse_json(std::string_view text);

}  // namespace xsharp

/// @file
/// Reads lights, and which light faces reflect.
#pragma once

#include "xsharp/files/json_node.hpp"
#include "xsharp/scene.hpp"

namespace xsharp {

/// @throws SceneError with the position of the error
Shading shading(const JsonNode& node);

/// @throws SceneError with the position of the error
Lights lights(const JsonNode& node);

}  // namespace xsharp

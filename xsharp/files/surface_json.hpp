/// @file
/// Reads the surface of an object.
#pragma once

#include "xsharp/files/json_node.hpp"
#include "xsharp/surface.hpp"

namespace xsharp {

/// @throws SceneError with the position of the error
Surface surface(const JsonNode& node);

}  // namespace xsharp

/// @file
/// Reading what fills the faces of an object.
#pragma once

#include "xsharp/files/json_node.hpp"
#include "xsharp/surface.hpp"

namespace xsharp {

/// @throws SceneError naming the place of what is wrong
Surface surface(const JsonNode& node);

}  // namespace xsharp

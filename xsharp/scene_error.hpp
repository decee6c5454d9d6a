/// @file
/// The exception for a scene that cannot be drawn.
#pragma once

#include <stdexcept>

namespace xsharp {

/// A scene or scene file is invalid; what() says where and why.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace xsharp

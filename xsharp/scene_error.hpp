/// @file
/// What is thrown for a scene that cannot be drawn.
#pragma once

#include <stdexcept>

namespace xsharp {

/// A scene, or a file of one, that is refused; what() says where and why.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace xsharp

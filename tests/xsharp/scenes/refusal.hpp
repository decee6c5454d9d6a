/// The message of a rejected scene, and numbers that no scene may contain.
#pragma once

#include <limits>
#include <string>

#include "xsharp/scene_error.hpp"

namespace xsharp_test {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// The message of the SceneError that `act` throws, or "accepted" if it throws none.
template <class Act>
std::string refusal(const Act& act) {
  try {
    act();
  } catch (const xsharp::SceneError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace xsharp_test

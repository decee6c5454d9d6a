/// What a refused scene says.
#pragma once

#include <string>

#include "xsharp/scene_error.hpp"

namespace xsharp_test {

/// The message of the SceneError that `act` throws; "accepted" if it throws none.
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

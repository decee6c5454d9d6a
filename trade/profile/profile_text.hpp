/// @file
/// A profile as people and as programs read it.
#pragma once

#include <string>

#include "trade/profile/profile.hpp"

namespace fixproof::trade {

/// Calls, ranges, how near overflow, faults and the near plane came, and what was never needed.
std::string text_of(const SceneProfile& profile);

/// made: {command, compiler, date}, then the figures of text_of().
/// @param scene the name of the scene
std::string json_of(const SceneProfile& profile, const std::string& scene);

}  // namespace fixproof::trade

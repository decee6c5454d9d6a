/// @file
/// The tables of `fixproof profile`.
#pragma once

#include <string>

#include "trade/profile/profile.hpp"

namespace fixproof::cli {

/// Calls, ranges, distances from overflow, faults and the near plane, and unused instructions.
std::string text_of(const trade::SceneProfile& profile);

}  // namespace fixproof::cli

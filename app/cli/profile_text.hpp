/// @file
/// Tables of `fixproof profile`.
#pragma once

#include <string>

#include "measure/trade/profile/profile.hpp"

namespace fixproof::cli {

/// Formats calls, ranges, margins to overflow, faults and the near plane, and unused instructions.
std::string text_of(const trade::SceneProfile& profile);

}  // namespace fixproof::cli

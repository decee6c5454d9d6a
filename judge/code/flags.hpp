/// @file
/// What instructions do to the six arithmetic flags, according to Intel's Software Developer's
/// Manual, volume 2.
#pragma once

#include <cstdint>

#include "judge/code/listing.hpp"

namespace fixproof::judge {

struct FlagEffects {
  std::uint16_t reads = 0;
  std::uint16_t defines = 0;
  std::uint16_t undefines = 0;
};

/// Returns the effects of an instruction. An instruction that this function does not know has none,
/// like one that leaves the flags alone.
FlagEffects flag_effects(const Line& line);

}  // namespace fixproof::judge

/// @file
/// The ways a call of machine code can end.
#pragma once

#include <cstdint>

namespace fixproof::machine_code {

enum class CallEnding : std::uint8_t {
  returned,      ///< the routine returned to its caller
  divide_error,  ///< #DE
  fault,         ///< any other fault: the code is not a routine
};

}  // namespace fixproof::machine_code

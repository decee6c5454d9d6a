/// @file
/// How a call of machine code ends.
#pragma once

#include <cstdint>

namespace fixproof::machine_code {

/// How a call ended.
enum class CallEnding : std::uint8_t {
  returned,      ///< the routine came back to its caller
  divide_error,  ///< #DE
  fault,         ///< any other fault: the code is not that of a routine
};

}  // namespace fixproof::machine_code

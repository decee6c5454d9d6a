/// @file
/// The part of the x87's state that a routine must leave as it finds it.
#pragma once

#include <cstdint>

namespace fixproof::machine_code {

/// By default, as in a new process.
struct X87 {
  std::uint16_t control = 0x37F;  ///< exceptions masked, 64 bits of precision, round to nearest
  std::uint16_t tags = 0xFFFF;    ///< two bits for each register of the stack; both are set: empty

  friend bool operator==(const X87&, const X87&) = default;
};

}  // namespace fixproof::machine_code

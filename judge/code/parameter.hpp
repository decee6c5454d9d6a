/// @file
/// What a routine takes and gives, before a calling convention places it.
#pragma once

#include <cstddef>

namespace fixproof::judge {

/// One operand or result of an operation, as a routine's parameter.
struct Parameter {
  int bits = 32;
  std::size_t numbers = 1;  ///< more than 1 only behind a pointer
  bool is_pointer = false;  ///< in the stack conventions
  bool is_result = false;
  bool is_signed = true;
};

}  // namespace fixproof::judge

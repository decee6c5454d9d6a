/// @file
/// What a routine takes and gives, before a calling convention places it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace fixproof::judge {

/// One parameter of a routine: an operand, a result, or a value that is always the same.
struct Parameter {
  int bits = 32;            ///< of the number as the routine takes it, at least those of a word
  std::size_t numbers = 1;  ///< more than 1 only behind a pointer
  bool is_pointer = false;  ///< in the stack conventions
  bool is_result = false;
  bool is_signed = true;
  std::optional<std::int64_t> constant{};  ///< what the routine gets in every call
};

struct Signature {
  std::vector<Parameter> operands{};  ///< also pointers to results, and constants
  int result_bits = 0;  ///< of the value that the routine returns; 0 if it returns no result
};

}  // namespace fixproof::judge

/// @file
/// A path in progress of the symbolic run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "x86model/symbolic/state.hpp"

namespace x86model::symbolic {

struct Thread {
  State state;
  Term condition;
  Term in_table;  ///< see Path::in_table
  std::size_t position = 0;
  std::map<std::size_t, int> jumps;   ///< number of jumps by position
  std::vector<std::uint64_t> values;  ///< of the enumerated operand that take this path
  bool has_begun = false;             ///< whether it has executed an instruction
};

}  // namespace x86model::symbolic

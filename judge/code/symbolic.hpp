/// @file
/// Runs a routine for all operands at once, with the terms of x86model.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "judge/code/listing.hpp"
#include "judge/code/runner.hpp"
#include "x86model/symbolic/state.hpp"
#include "x86model/symbolic/term.hpp"

namespace fixproof::judge {

/// One way through the routine.
struct Path {
  x86model::symbolic::Term condition;
  bool divide_error = false;          ///< whether it ends in #DE, not in a return
  x86model::symbolic::Term result{};  ///< one word
  x86model::symbolic::Term kept{};    ///< whether all registers that must be preserved are
};

struct SymbolicRun {
  std::vector<Path> paths{};
  /// Why there are no paths: an instruction that is not modelled, with its address, or a limit.
  std::string obstacle{};
};

/// Returns the name of an operand's variable in the terms: a, b or c. The variable is one word.
std::string operand_name(std::size_t index);

/// Follows every path of a routine that takes and returns plain numbers. Products and quotients
/// become the abstract functions of x86model/symbolic/domain.hpp.
SymbolicRun run_symbolically(const Subject& subject, Listing& listing,
                             x86model::symbolic::Terms& terms);

}  // namespace fixproof::judge

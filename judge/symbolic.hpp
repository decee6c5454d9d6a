/// @file
/// Runs a routine for all operands at once, on x86model's terms.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "judge/listing.hpp"
#include "judge/runner.hpp"
#include "x86model/symbolic/state.hpp"
#include "x86model/symbolic/term.hpp"

namespace fixproof::judge {

/// One way through the routine.
struct Path {
  x86model::symbolic::Term condition;
  bool divide_error = false;          ///< otherwise it returned
  x86model::symbolic::Term result{};  ///< as wide as a word
  x86model::symbolic::Term kept{};    ///< whether all that must be kept is
};

struct SymbolicRun {
  std::vector<Path> paths{};
  /// Why there are none: the instruction that is not modelled, with its address, or a limit.
  std::string obstacle{};
};

/// The name of an operand as a variable of the terms, as wide as a word: a, b, c.
std::string operand_name(std::size_t index);

/// Follows every path of a routine that takes and returns plain numbers. Products and quotients are
/// applications of the abstract functions of x86model/symbolic/alu.hpp.
SymbolicRun run_symbolically(const Subject& subject, Listing& listing,
                             x86model::symbolic::Terms& terms);

}  // namespace fixproof::judge

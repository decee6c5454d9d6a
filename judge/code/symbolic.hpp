/// @file
/// Runs a routine for all operands at once, with the terms of x86model.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "judge/code/frame.hpp"
#include "judge/code/listing.hpp"
#include "judge/code/parameter.hpp"
#include "x86model/symbolic/state.hpp"
#include "x86model/symbolic/term.hpp"

namespace fixproof::judge {

/// One way through the routine.
struct Path {
  x86model::symbolic::Term condition;
  bool divide_error = false;          ///< whether it ends in #DE
  bool traps = false;                 ///< whether it ends in UD2
  x86model::symbolic::Term result{};  ///< if it returns
  /// Whether all registers that must be preserved are, if it returns.
  x86model::symbolic::Term kept{};

  [[nodiscard]] bool returns() const { return !divide_error && !traps; }
};

struct SymbolicRun {
  std::vector<Path> paths{};
  /// Why there are no paths: an instruction that is not modelled, with its address, or a limit.
  std::string obstacle{};
};

/// Returns the name of an operand's variable in the terms: a, b, c or d. The variable has the bits
/// of the operand.
std::string operand_name(std::size_t index);

/// Tells whether some operands satisfy a condition. True if that is not known.
using MayHold = std::function<bool(x86model::symbolic::Term condition)>;

/// Follows every path of a routine that takes and returns plain numbers. Products and quotients
/// become the abstract functions of x86model/symbolic/domain.hpp.
/// @param may_hold asked about both ways of a jump that the path has taken before, so that loops
///                 and recursion end that only the condition of the path ends
SymbolicRun run_symbolically(const Image& image, const Frame& frame, const Signature& signature,
                             Listing& listing, x86model::symbolic::Terms& terms,
                             const MayHold& may_hold);

}  // namespace fixproof::judge

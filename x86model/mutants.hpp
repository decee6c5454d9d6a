/// @file
/// Programs with one instruction changed: what checks are measured by.
#pragma once

#include <string>
#include <vector>

#include "x86model/assemble.hpp"

namespace x86model {

struct Mutant {
  Program program;
  std::size_t position;  ///< of the changed instruction
  std::string
      change;  ///< as "12 adc cx, dx -> add cx, dx"; the number is the instruction's position
};

/// Every change of one instruction of `sound`, in the order of its instructions:
///   - its mnemonic, to each that it may be mistaken for (rounding, carry, sign, direction)
///   - its two operands exchanged, a register for the next one, a constant or displacement by one
///     step up and down, half a unit left out
///   - a jump made to go always, or to each other label
///   - the instruction left out, or there twice
/// A change that leaves the instruction as it is is left out; one that its processor does not have
/// is not: the interpreter runs it.
std::vector<Mutant> mutants(const Program& sound);

}  // namespace x86model

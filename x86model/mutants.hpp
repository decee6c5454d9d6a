/// @file
/// Mutation of programs, one instruction at a time, to measure how many errors the checks detect.
#pragma once

#include <string>
#include <vector>

#include "x86model/assemble.hpp"

namespace x86model {

struct Mutant {
  Program program;
  std::size_t position;  ///< of the mutated instruction
  std::string change;    ///< "12 adc cx, dx -> add cx, dx", the position first
};

/// All mutants of `original`, in the order of its instructions:
///   - another mnemonic that could be confused with it (rounding, carry, sign, direction)
///   - swapped operands, the next register, a constant or displacement one step up or down, no
///     half unit
///   - a jump made unconditional, or to each other label
///   - the instruction deleted or duplicated
/// Excludes changes without effect on the instruction. Includes instructions that the processor
/// does not have, because the interpreter runs them.
std::vector<Mutant> mutants(const Program& original);

}  // namespace x86model

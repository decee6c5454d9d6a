/// @file
/// Questions whose answers are known, to test a solver.
#pragma once

#include <span>
#include <string>

#include "verify/proof/solver_program.hpp"

namespace fixproof::proof {

struct KnownAnswer {
  const char* subject;
  Satisfiability verdict;
  std::string script;
};

/// Returns questions in the theories of the real ones: vectors of 8 to 64 bits, functions, memory,
/// multiplication and division, linear and nonlinear integers. They come in pairs that differ
/// little, one of them satisfiable.
std::span<const KnownAnswer> known_answers();

}  // namespace fixproof::proof

/// @file
/// Proves a user's routine for all operands, or finds a case that fails.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "judge/check/judged_case.hpp"
#include "judge/code/runner.hpp"
#include "verify/proof/prove.hpp"

namespace fixproof::judge {

struct RoutineProof {
  proof::Standing standing = proof::Standing::open;
  std::string why{};  ///< why there is no proof
  std::size_t paths = 0;
  double seconds = 0;
  std::optional<check::JudgedCase> counterexample{};  ///< it fails on the machine, too
};

/// Where the solver is.
struct ProofStep {
  std::size_t attempt =
      0;                 ///< each states the result in another way; 0 while the paths are followed
  std::size_t path = 0;  ///< from 1
  std::size_t paths = 0;
};

/// First checks on a thousand cases that the terms of the paths give what the machine gives. Then
/// asks the solver under abstract arithmetic, with each shape of the exact result, and at last
/// under exact arithmetic. Only a case that fails on the machine disproves the routine.
/// @param max_seconds limits each question to the solver
/// @param observe     told each step before it begins
/// @throws as proof::Solver::ask()
RoutineProof prove(const Subject& subject, const check::Rules& rules, On machine,
                   const proof::Solver& solver, int max_seconds,
                   const std::function<void(const ProofStep&)>& observe);

}  // namespace fixproof::judge

/// @file
/// Proves a user's routine for all operands, or finds a case that fails.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "check/judged_case.hpp"
#include "judge/runner.hpp"
#include "proof/prove.hpp"

namespace fixproof::judge {

struct RoutineProof {
  proof::Standing standing = proof::Standing::open;
  std::string why{};  ///< why there is no proof: the instruction that is not modelled, or a remark
  std::size_t paths = 0;
  double seconds = 0;
  std::optional<check::JudgedCase> counterexample{};  ///< that fails on the machine, too
};

/// Asks under abstract arithmetic in each shape of the exact result, then under exact arithmetic.
/// Only a case that fails on the machine disproves. Before that, the terms of the paths must give
/// what the machine gives for a thousand cases.
/// @param max_seconds limits each question
/// @throws as proof::Solver::ask()
RoutineProof prove(const Subject& subject, const check::Rules& rules, On machine,
                   const proof::Solver& solver, int max_seconds);

}  // namespace fixproof::judge

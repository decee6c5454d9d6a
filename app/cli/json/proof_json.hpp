/// @file
/// The results of `fixproof prove` and `prove type` as JSON.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "judge/type/prove_goal.hpp"
#include "support/json.hpp"
#include "verify/cases/variant.hpp"
#include "verify/proof/prove.hpp"

namespace fixproof::cli {

/// Returns the word for a standing, such as `proven`.
std::string_view word_of(proof::Standing standing);

/// The solver and its time limit per question.
struct SolverUse {
  std::string version;
  int seconds = 0;
};

/// A goal of `prove` and what came of it.
struct GoalResult {
  std::string name;
  proof::Proof proof;
  std::optional<cases::Variant> variant{};  ///< of a routine
  std::string replay{};                     ///< the command that shows a counterexample
};
/// @param all the number of goals; those that are not in `goals` have no answer
support::Json goals_json(const SolverUse& solver, const std::vector<GoalResult>& goals,
                         std::size_t all);

/// A function of the type as one compiler translates it, and what came of it.
struct FunctionResult {
  std::string compiler;
  std::string level;
  std::string operation;
  std::string type;
  judge::GoalProof proof;
};
/// @param all the number of functions; those that are not in `functions` have no answer
support::Json functions_json(const SolverUse& solver, const std::vector<FunctionResult>& functions,
                             std::size_t all);

}  // namespace fixproof::cli

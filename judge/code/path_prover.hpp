/// @file
/// Asks a solver whether every path of a routine keeps a claim.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "judge/code/claim.hpp"
#include "judge/code/quotient_claim.hpp"
#include "judge/code/symbolic.hpp"
#include "verify/proof/prove.hpp"

namespace fixproof::judge {

/// Asks one question, for at most `max_seconds` or a limit of its own. @throws as
/// proof::Solver::ask()
using Ask = std::function<proof::SolverAnswer(const std::string& script, int max_seconds)>;

/// The paths of a routine, with all that a question about them needs.
struct Paths {
  x86model::symbolic::Terms& terms;
  std::span<const Path> all;
  const std::vector<Parameter>& operands;
};

/// Returns what tells whether operands satisfy a condition, under abstract arithmetic: it asks for
/// a short time.
/// @param terms,ask,seconds must outlive the result, which adds the time that the solver takes
MayHold may_hold(x86model::symbolic::Terms& terms, const Ask& ask, double& seconds);

/// Returns the divide that a path depends on, if it is the only one.
std::optional<MachineDivide> divide_of(x86model::symbolic::Terms& terms, const Path& path);

/// Returns the question whether a path breaks its claim for operands of one of its cases. Its
/// script is satisfiable if it does.
std::string question(const Paths& paths, const Path& path, const Claim& claim,
                     const std::string& in_case, proof::Arithmetic arithmetic);

/// What asking about all paths has shown.
struct PathAnswer {
  proof::Standing standing = proof::Standing::open;
  double seconds = 0;
  std::string remark{};  ///< which path is not decided, and why
};

/// Asks about each path and each case of its claim, one after the other.
/// @param fails told the operands of a counterexample, which abstract arithmetic may have made up:
///              says whether the routine fails for them
PathAnswer ask_all(const Paths& paths, const std::function<Claim(const Path&)>& claim,
                   proof::Arithmetic arithmetic, const Ask& ask,
                   const std::function<bool(std::span<const std::uint64_t>)>& fails);

}  // namespace fixproof::judge

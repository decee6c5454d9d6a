/// @file
/// The SMT solvers that answer questions.
#pragma once

#include <string>
#include <vector>

#include "verify/proof/solver_program.hpp"

namespace fixproof::proof {

/// One solver, or two that must agree.
class Solver {
 public:
  /// Asks each solver the questions of known_answers() first.
  /// @param name z3, cvc5 or both
  /// @throws UsageError for another name, or if a program is not on the PATH or cannot print its
  /// version; SolverError if a solver does not give the known answers; support::Stopped
  explicit Solver(const std::string& name);

  /// The first line of `--version` of each.
  [[nodiscard]] std::string version() const;

  /// Asks one question, with a time limit of `max_seconds` for each solver. Two solvers decide it
  /// only if they agree; a solver that fails does not decide it.
  /// @throws SolverError if the only solver fails: see SolverProgram::ask(); support::Stopped
  [[nodiscard]] SolverAnswer ask(const std::string& script, int max_seconds) const;

 private:
  std::vector<SolverProgram> programs_;
};

}  // namespace fixproof::proof

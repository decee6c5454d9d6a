/// @file
/// The SMT solvers that answer questions.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "verify/proof/solver_program.hpp"

namespace fixproof::proof {

/// One solver, or two: they must agree, or the first answer counts.
class Solver {
 public:
  /// Asks each solver the questions of known_answers() first.
  /// @param name z3, cvc5, both or any
  /// @throws UsageError for another name, or if a program is not on the PATH or cannot print its
  /// version; SolverError if a solver does not give the known answers; support::Stopped
  explicit Solver(const std::string& name);

  /// The first line of `--version` of each.
  [[nodiscard]] std::string version() const;

  /// Asks one question, with a time limit of `max_seconds` for each solver. Both decide it only if
  /// they agree. Of any, the second starts if the first has no answer within a second, and the
  /// first answer ends the other. One of two that fails does not decide.
  /// @throws SolverError if the only solver fails: see SolverProgram::ask(); support::Stopped
  [[nodiscard]] SolverAnswer ask(const std::string& script, int max_seconds) const;

  /// Asks several questions in one run; see SolverProgram::ask_together(). With two solvers it asks
  /// nothing, and the answer is unknown. @throws support::Stopped
  [[nodiscard]] SolverAnswer ask_together(std::span<const std::string> scripts,
                                          int max_seconds) const;

 private:
  [[nodiscard]] SolverAnswer ask_both(const std::string& script, int max_seconds) const;
  [[nodiscard]] SolverAnswer ask_any(const std::string& script, int max_seconds) const;

  std::vector<SolverProgram> programs_;
  bool must_agree_ = false;
};

}  // namespace fixproof::proof

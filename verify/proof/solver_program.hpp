/// @file
/// Runs an SMT solver as a separate process.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "verify/proof/process.hpp"

namespace fixproof::proof {

/// A solver that fails, or whose answer is damaged or wrong. The message names the solver.
class SolverError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class Satisfiability {
  unsatisfiable,
  satisfiable,
  unknown,
  one_sided,  ///< one of two solvers decides, the other does not
  disputed,   ///< two solvers contradict each other
};

struct SolverAnswer {
  Satisfiability verdict = Satisfiability::unknown;
  std::string model{};  ///< satisfies the question; empty unless satisfiable
  double seconds = 0;
  std::string remark{};  ///< what each of two solvers says, unless they agree
};

/// The word for a verdict of one solver.
std::string name_of(Satisfiability verdict);

class SolverProgram {
 public:
  /// @param name z3 or cvc5
  /// @throws UsageError if the program is not on the PATH or cannot print its version;
  /// support::Stopped
  explicit SolverProgram(const std::string& name);

  [[nodiscard]] const std::string& name() const { return name_; }
  /// The first line of `--version`.
  [[nodiscard]] const std::string& version() const { return version_; }

  /// Asks one question, whose script ends in its only (check-sat), with a time limit of
  /// `max_seconds`. Without an answer if `cancelled` is set before there is one.
  /// @throws SolverError if the solver cannot run, exits with a status other than 0, says anything
  /// else than an answer, or "sat" without a model that satisfies the script; support::Stopped
  [[nodiscard]] SolverAnswer ask(const std::string& script, int max_seconds,
                                 const std::atomic<bool>& cancelled = never_cancelled) const;

  /// Asks several such questions in one run, which spares the start of the solver, with one time
  /// limit for all.
  /// @return the answers; none if an answer is missing or is what ask() throws for, since ask()
  /// tells why. @throws support::Stopped
  [[nodiscard]] std::vector<SolverAnswer> ask_in_one_run(std::span<const std::string> scripts,
                                                         int max_seconds) const;

  /// Asks them in one run, too.
  /// @return unsatisfiable if the solver says so of each question, and unknown otherwise.
  /// @throws support::Stopped
  [[nodiscard]] SolverAnswer ask_together(std::span<const std::string> scripts,
                                          int max_seconds) const;

 private:
  std::string name_;
  std::string version_;
};

/// Judges what the solver `name` printed about `script`.
/// @return the verdict, with the model if the question is satisfiable; `seconds` stays 0
/// @throws SolverError as SolverProgram::ask() does
SolverAnswer answer_in(const Output& output, const std::string& name, const std::string& script);

/// Judges what the solver `name` printed about several scripts in one run, with the line "end of an
/// answer" after each answer.
/// @return an answer for each; none if the solver failed or was late, or if a line is missing
/// @throws SolverError as answer_in() does
std::vector<SolverAnswer> answers_in(const Output& output, const std::string& name,
                                     std::span<const std::string> scripts);

}  // namespace fixproof::proof

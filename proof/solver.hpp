/// @file
/// Runs an SMT solver as a separate process.
#pragma once

#include <string>

namespace fixproof::proof {

enum class Satisfiability { unsatisfiable, satisfiable, unknown };

struct SolverAnswer {
  Satisfiability verdict = Satisfiability::unknown;
  std::string text{};  ///< its whole output, including the model if satisfiable
  double seconds = 0;
};

class Solver {
 public:
  /// @param name z3 or cvc5
  /// @throws UsageError for another name, or if the program is not on the PATH or cannot print its
  /// version; Stopped
  explicit Solver(const std::string& name);

  [[nodiscard]] const std::string& name() const { return name_; }
  /// The first line of `--version`.
  [[nodiscard]] const std::string& version() const { return version_; }

  /// Asks with a time limit of `max_seconds`.
  /// @throws std::runtime_error if the solver cannot run, reports an error or exits with a status
  /// other than 0; Stopped
  [[nodiscard]] SolverAnswer ask(const std::string& script, int max_seconds) const;

 private:
  std::string name_;
  std::string version_;
};

}  // namespace fixproof::proof

/// @file
/// An SMT solver, run as a program of its own.
#pragma once

#include <string>

namespace fixproof::proof {

enum class Verdict { unsatisfiable, satisfiable, unknown };

struct SolverAnswer {
  Verdict verdict = Verdict::unknown;
  std::string text{};  ///< all it said: where satisfiable, the model too
  double seconds = 0;
};

/// A solver that reads SMT-LIB from standard input.
class Solver {
 public:
  /// @param name z3 or cvc5
  /// @throws UsageError for another name, and where no such program is on the PATH or it cannot say
  /// its version; Stopped
  explicit Solver(const std::string& name);

  [[nodiscard]] const std::string& name() const { return name_; }
  /// The first line of `--version`.
  [[nodiscard]] const std::string& version() const { return version_; }

  /// Asks for at most so many seconds. @throws std::runtime_error where it cannot be run, complains
  /// of the script, or ends with a status other than 0; Stopped
  [[nodiscard]] SolverAnswer ask(const std::string& script, int most_seconds) const;

 private:
  std::string name_;
  std::string version_;
};

}  // namespace fixproof::proof

/// @file
/// An SMT solver, run as a program of its own.
#pragma once

#include <string>

namespace fixproof {

enum class Verdict { unsatisfiable, satisfiable, unknown };

struct SolverAnswer {
  Verdict verdict = Verdict::unknown;
  std::string text{};  ///< all it said
  double seconds = 0;
};

/// A solver that reads SMT-LIB from standard input.
class Solver {
 public:
  /// @param name z3 or cvc5
  /// @throws UsageError for another name, and where there is no such program on the PATH
  explicit Solver(const std::string& name);

  [[nodiscard]] const std::string& name() const { return name_; }
  /// The first line of `--version`.
  [[nodiscard]] const std::string& version() const { return version_; }

  /// Asks for at most so many seconds. @throws std::runtime_error where it cannot be run, or
  /// complains of the script
  [[nodiscard]] SolverAnswer ask(const std::string& script, int most_seconds) const;

 private:
  std::string name_;
  std::string version_;
};

}  // namespace fixproof

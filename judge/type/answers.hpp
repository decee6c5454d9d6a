/// @file
/// Remembers what a solver has answered.
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include "support/output_file.hpp"
#include "verify/proof/solver_program.hpp"

namespace fixproof::judge {

/// Remembers questions that have no counterexample. Compilers often make the same code at several
/// levels, and then the question is the same text. Threads may share it.
class Answers {
 public:
  /// @param path  if not empty: a file that keeps the digests of such questions, so that a later
  ///              run goes on from there; created if it does not exist
  /// @param asked whom the answers are of, in one line: the file may hold no other's
  /// @throws support::UsageError if the file is of another kind, or of another solver;
  /// std::runtime_error if it cannot be read or written, or another run is writing it
  Answers(const std::string& path, const std::string& asked);

  /// Returns the answer to `script`, from memory or by asking. @throws as `ask` and save()
  proof::SolverAnswer operator()(const std::string& script,
                                 const std::function<proof::SolverAnswer()>& ask);

  /// Writes the file. @throws std::runtime_error
  void save();
  [[nodiscard]] std::size_t remembered() const { return remembered_; }

 private:
  void write();

  std::string head_;
  std::optional<support::OutputFile> file_;
  std::mutex mutex_;
  std::set<std::string> proven_;  ///< digests
  std::size_t unsaved_ = 0;
  std::size_t remembered_ = 0;  ///< answers that were not asked for
};

}  // namespace fixproof::judge

/// @file
/// The options of the commands that ask a solver.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cli/arguments.hpp"

namespace fixproof::cli {

struct SolverOptions {
  std::string name = "z3";
  int seconds;  ///< that one question may take

  /// Adds --solver and --timeout to a command.
  void add_to(CLI::App& command) {
    command.add_option("--solver", name, "z3 or cvc5, from the PATH")
        ->check(not_empty())
        ->capture_default_str();
    command.add_option("--timeout", seconds, "seconds that one question may take")
        ->transform(whole_number(1, 86'400))
        ->capture_default_str();
  }
};

}  // namespace fixproof::cli

/// @file
/// Options of the commands that run an SMT solver.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/cli/arguments.hpp"

namespace fixproof::cli {

struct SolverOptions {
  std::string name = "z3";
  int seconds;  ///< time limit per query

  /// Adds the options to a command, which must not outlive this object.
  void add_to(CLI::App& command) {
    command
        .add_option("--solver", name,
                    "solver on the PATH: z3, cvc5, both, which must agree, or any, whose first "
                    "answer counts")
        ->check(not_empty())
        ->capture_default_str();
    command.add_option("--timeout", seconds, "time limit per question in seconds")
        ->transform(whole_number(1, 86'400))
        ->capture_default_str();
  }
};

}  // namespace fixproof::cli

/// @file
/// Options that select the program that `trace` and `list` show and `dos` writes.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "app/cli/options.hpp"
#include "verify/machine_code/programs.hpp"

namespace fixproof::cli {

/// A routine with the variant options and --as-scanned, or an inner loop with --loop.
struct ProgramOptions {
  std::string operation;
  VariantOptions variant;
  bool as_scanned = false;
  std::string counting;  ///< --loop of an inner loop; empty if not given

  /// @param with_loops whether the command also accepts inner loops
  void add_to(CLI::App& command, bool with_loops = false);
  /// @throws std::invalid_argument for an unknown routine, UsageError if the combination of options
  ///         does not exist
  [[nodiscard]] machine_code::ProgramKey choose() const;
  /// Returns the form of the inner loop, or nothing if the command names a routine.
  /// @throws UsageError if the combination of options does not exist
  [[nodiscard]] std::optional<x86model::LoopForm> choose_loop() const;
};

}  // namespace fixproof::cli

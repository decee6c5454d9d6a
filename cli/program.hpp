/// @file
/// Which program `trace` and `list` are to show, or `dos` to write.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/options.hpp"
#include "machine_code/programs.hpp"

namespace fixproof::cli {

/// The routine and the variant options, and --as-scanned; or an inner loop and --loop.
struct ProgramOptions {
  std::string operation;
  VariantOptions variant;
  bool as_scanned = false;
  std::string counting;  ///< of an inner loop; empty: not given

  /// @param with_loops whether an inner loop may be named too
  void add_to(CLI::App& command, bool with_loops = false);
  /// @throws std::invalid_argument for what is no routine; UsageError for a combination that does
  /// not exist
  [[nodiscard]] machine_code::ProgramKey choose() const;
  /// The form of an inner loop; nothing where none is named.
  /// @throws UsageError for a combination that does not exist
  [[nodiscard]] std::optional<x86model::LoopForm> choose_loop() const;
};

}  // namespace fixproof::cli

/// @file
/// Which program `trace` and `list` are to show, or `dos` to write.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "verify/machine_code/programs.hpp"
#include "verify/options.hpp"

namespace fixproof {

/// The routine and the variant options, and --as-scanned.
struct ProgramOptions {
  std::string operation;
  VariantOptions variant;
  bool as_scanned = false;

  void add_to(CLI::App& command);
  /// @throws std::invalid_argument for what is no routine; UsageError for a combination that does
  /// not exist
  [[nodiscard]] ProgramKey choose() const;
};

}  // namespace fixproof

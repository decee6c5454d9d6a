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
  /// @throws UsageError for what is no routine
  [[nodiscard]] ProgramKey choose() const;
};

}  // namespace fixproof

/// @file
/// Which program `trace` and `list` are to show.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "verify/options.hpp"
#include "x86model/routine.hpp"

namespace fixproof {

/// A routine of the model and the switches it is assembled with.
struct ProgramChoice {
  x86model::Routine routine = x86model::Routine::mul;
  x86model::Target target = x86model::Target::i386;
  x86model::Build build;
};

/// The routine and the variant options, and --as-scanned.
struct ProgramOptions {
  std::string operation;
  VariantOptions variant;
  bool as_scanned = false;

  void add_to(CLI::App& command);
  /// @throws UsageError for what is no routine
  [[nodiscard]] ProgramChoice choose() const;
};

}  // namespace fixproof

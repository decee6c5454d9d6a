/// @file
/// The options of `judge`.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>
#include <vector>

#include "app/cli/case_options.hpp"
#include "app/cli/judge_listing.hpp"
#include "app/cli/solver_options.hpp"
#include "judge/check/cases.hpp"

namespace fixproof::cli {

/// What --run takes besides.
struct RunOptions {
  std::string program;        ///< a command of the shell
  std::size_t processes = 0;  ///< 0: as many as pay

  /// Adds the options to a command, which must not outlive this object.
  void add_to(CLI::App& command);
};

struct JudgeOptions {
  std::string file;
  std::string operation;
  std::string format = "q16_16";
  std::string to;  ///< the format of the results; empty if it is that of the words
  std::size_t terms = cases::Variant{}.terms;
  std::string rule;
  std::string rounding;
  std::string within;
  std::string overflow = "any";
  std::string no_result = "any";
  std::string frame = "c";
  int bits = 0;  ///< 0: what the container implies
  std::string at;
  std::string symbol;
  check::CaseOptions cases;
  std::size_t shown = 3;
  bool list = false;
  bool prove = false;
  bool clocks = false;
  SolverOptions solver{.seconds = 30};
  std::string trace;
  ListingOptions listing;
  RunOptions run;

  [[nodiscard]] FormatOptions formats() const { return {format, to, terms}; }

  /// Adds the options and the help to a command, which must not outlive this object.
  void add_to(CLI::App& command);
};

/// Refuses options that have no effect beside --run, --list, --trace or --against-listing.
/// @throws support::UsageError
void expect_effects(const CLI::App& command);

}  // namespace fixproof::cli

/// @file
/// The options that gen, check and eval share: the formats of an operation, and the cases.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>

#include "judge/check/cases.hpp"

namespace fixproof::cli {

struct FormatOptions {
  std::string format;  ///< of the words; empty for q16_16
  std::string to;      ///< of the results; empty if it is that of the words
  std::size_t terms = cases::Variant{}.terms;
};

/// Adds --format, --to and --terms to a command. `options` must outlive it.
/// @param what which operations take a format, and how they round
void add_format_options(CLI::App& command, FormatOptions& options, const std::string& what);

/// Returns the operation in its formats.
/// @throws UsageError if an option is missing or does not apply, or if the operation lacks a format
cases::Variant variant_in(cases::Operation operation, const FormatOptions& options);

/// Adds --level, --seed, --shard and --cases to a command. `options` must outlive it.
void add_case_options(CLI::App& command, check::CaseOptions& options);

}  // namespace fixproof::cli

/// @file
/// Options of `gen` and `check` that select cases.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "judge/check/cases.hpp"

namespace fixproof::cli {

/// Adds --to, the format of the results of convert.
void add_result_format(CLI::App& command, std::string& to);

/// Returns the operation in its formats. `to` is empty unless the operation is convert.
/// @throws UsageError if --to is missing or does not apply
cases::Variant variant_in(cases::Operation operation, const cases::Format& format,
                          const std::string& to);

/// Adds --level, --seed, --shard and --cases to a command. `options` must outlive it.
void add_case_options(CLI::App& command, check::CaseOptions& options);

}  // namespace fixproof::cli

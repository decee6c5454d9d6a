/// @file
/// Options of `gen` and `check` that select cases.
#pragma once

#include <CLI/CLI.hpp>

#include "check/cases.hpp"

namespace fixproof::cli {

/// Adds --level, --seed, --shard and --cases to a command. `options` must outlive it.
void add_case_options(CLI::App& command, check::CaseOptions& options);

}  // namespace fixproof::cli

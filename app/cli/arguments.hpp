/// @file
/// Validators for option values.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace fixproof::cli {

/// Accepts a decimal integer from `first` to `last`. Pass it to transform(), which replaces the
/// text: CLI11 itself reads -1 as the largest unsigned number and 010 as octal.
CLI::Validator whole_number(std::uint64_t first, std::uint64_t last);

/// Adds --seed, with the current value of `seed` as default. `seed` must outlive the command.
void add_seed(CLI::App& command, std::uint64_t& seed);

/// Rejects an empty value, which a script may pass by way of an unset variable.
CLI::Validator not_empty();

}  // namespace fixproof::cli

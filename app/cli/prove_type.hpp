/// @file
/// `fixproof prove type`.
#pragma once

#include <CLI/CLI.hpp>

namespace fixproof::cli {

/// Adds the subcommand to `prove`.
void add_prove_type(CLI::App& prove, int& status);

}  // namespace fixproof::cli

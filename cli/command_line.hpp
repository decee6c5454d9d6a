/// @file
/// The whole command line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fixproof::cli {

/// Runs `fixproof ARGUMENT...`, and prints an error as one line on stderr.
/// @return the exit status
int run_command_line(std::vector<std::string> arguments);

/// The version that `fixproof --version` prints.
std::string_view program_version();

}  // namespace fixproof::cli

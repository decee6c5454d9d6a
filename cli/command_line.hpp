/// @file
/// Entry point of the command line.
#pragma once

#include <string>
#include <vector>

namespace fixproof::cli {

/// Runs `fixproof ARGUMENT...`, prints an error as one line on stderr and returns the exit status.
int run_command_line(std::vector<std::string> arguments);

}  // namespace fixproof::cli

/// @file
/// Entry point of the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace fixproof::cli {

/// Adds commands, as add_all_commands() does.
using AddCommands = void(CLI::App& app, int& status);

/// Runs `fixproof ARGUMENT...` with these commands, prints an error as one line on stderr and
/// returns the exit status.
int run_command_line(std::vector<std::string> arguments, AddCommands& add_commands);

}  // namespace fixproof::cli

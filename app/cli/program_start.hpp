/// @file
/// What main() does.
#pragma once

#include "app/cli/command_line.hpp"

namespace fixproof::cli {

/// Prepares descriptors, signals and streams, and runs the command line.
int start_program(int argc, char** argv, AddCommands& add_commands);

}  // namespace fixproof::cli

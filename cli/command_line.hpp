/// @file
/// The command line as a whole, for main() and for commands that run others.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fixproof::cli {

/// Runs `fixproof ARGUMENT...`; what goes wrong is said in one line on stderr.
/// @return the exit status
int run_command_line(std::vector<std::string> arguments);

/// What a command left behind.
struct Captured {
  int status = 0;
  std::string out;
};

/// As run_command_line(), with `input` to read, keeping what it writes to standard output.
Captured run_captured(std::vector<std::string> arguments, const std::string& input = {});

/// As `fixproof --version` says it.
std::string_view program_version();

}  // namespace fixproof::cli

#include "app/cli/program_start.hpp"

#include <csignal>
#include <iostream>

#include "support/error_text.hpp"

namespace fixproof::cli {

int start_program(int argc, char** argv, AddCommands& add_commands) {
  support::occupy_closed_descriptors();
  // Ignore these signals, so that a closed pipe or a file size limit becomes a write error.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // Reading line by line needs buffered streams. No command uses stdio for standard output.
  std::ios::sync_with_stdio(false);
  return run_command_line({argv + (argc > 0 ? 1 : 0), argv + argc}, add_commands);
}

}  // namespace fixproof::cli

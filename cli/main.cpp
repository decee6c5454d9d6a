#include <csignal>
#include <iostream>

#include "cli/command_line.hpp"
#include "support/error_text.hpp"

int main(int argc, char** argv) {
  fixproof::support::occupy_closed_descriptors();
  // Ignore these signals, so that a closed pipe or a file size limit becomes a write error.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // Reading line by line needs buffered streams. No command uses stdio for standard output.
  std::ios::sync_with_stdio(false);
  return fixproof::cli::run_command_line({argv + (argc > 0 ? 1 : 0), argv + argc});
}

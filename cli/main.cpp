// The command `fixproof`.
#include <csignal>
#include <iostream>

#include "cli/command_line.hpp"

int main(int argc, char** argv) {
  // A reader that goes away or a limit on files is an error that is reported, not a silent end.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // Commands that read a line at a time need a buffer of their own; none mixes the two libraries.
  std::ios::sync_with_stdio(false);
  return fixproof::cli::run_command_line({argv + (argc > 0 ? 1 : 0), argv + argc});
}

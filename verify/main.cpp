// The command `fixproof`.
#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "verify/commands/command_line.hpp"

int main(int argc, char** argv) {
  // A reader that goes away or a limit on files is an error that is reported, not a silent end.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // Commands that read a line at a time need a buffer of their own; none mixes the two libraries.
  std::ios::sync_with_stdio(false);
  const int status =
      fixproof::run_command_line(std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc));
  // A full disk or a closed pipe shows at the latest here.
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    fmt::print(stderr, "fixproof: cannot write standard output\n");
    return 2;
  }
  return status;
}

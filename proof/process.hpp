/// @file
/// Runs another program with a time limit and returns its output.
#pragma once

#include <chrono>
#include <stdexcept>
#include <string>
#include <vector>

namespace fixproof::proof {

/// Interrupt::flag() was set, so there is no result.
class Stopped : public std::runtime_error {
 public:
  Stopped() : std::runtime_error("stopped") {}
};

struct Output {
  std::string out;
  std::string err;
  int status = 0;       ///< the exit status
  bool in_time = true;  ///< if false, the program was killed and its output may be incomplete
};

/// Runs `arguments[0]`, found on the PATH, with `input` on standard input. Kills it and everything
/// that it started after `limit`, or when Interrupt::flag() is set.
/// @throws Stopped if the flag is set; std::system_error if the program cannot be started;
/// std::runtime_error if a signal ends it
Output run_program(const std::vector<std::string>& arguments, const std::string& input,
                   std::chrono::milliseconds limit);

}  // namespace fixproof::proof

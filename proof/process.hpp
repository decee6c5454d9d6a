/// @file
/// A program run for what it prints, and for so long and no longer.
#pragma once

#include <chrono>
#include <stdexcept>
#include <string>
#include <vector>

namespace fixproof::proof {

/// What was being done has no outcome: Interrupt was told to stop.
class Stopped : public std::runtime_error {
 public:
  Stopped() : std::runtime_error("stopped") {}
};

/// What a program left behind.
struct Printed {
  std::string out;
  std::string err;
  int status = 0;       ///< its exit status
  bool in_time = true;  ///< else it was ended, and the rest says little
};

/// Runs `arguments[0]`, looked up on the PATH, with that input. It is ended, with all that it has
/// started, after `most`, or once Interrupt::flag() is set.
/// @throws Stopped in that case; std::system_error where it cannot be started; std::runtime_error
/// where a signal ends it
Printed run_program(std::vector<std::string> arguments, const std::string& input,
                    std::chrono::milliseconds most);

}  // namespace fixproof::proof

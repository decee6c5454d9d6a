/// @file
/// Runs another program with a time limit and returns its output.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace fixproof::proof {

/// A signal ended the program.
class Killed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Output {
  std::string out{};
  std::string err{};
  int status = 0;       ///< the exit status
  bool in_time = true;  ///< if false, the program was killed and its output may be incomplete
};

inline constinit const std::atomic<bool> never_cancelled = false;

/// Runs `arguments[0]`, a path or a name on the PATH, with `input` on standard input. Kills it and
/// everything that it started after `limit`, or when Interrupt::flag() or `cancelled` is set. It
/// also ends when this process is killed.
/// @param confine if there is one, it runs in the child before the program, which then gets no
/// environment variables
/// @throws support::Stopped if the flag is set; std::system_error if the program cannot be started;
/// Killed if a signal ends it
Output run_program(const std::vector<std::string>& arguments, const std::string& input,
                   std::chrono::milliseconds limit, const std::function<void()>& confine = {},
                   const std::atomic<bool>& cancelled = never_cancelled);

}  // namespace fixproof::proof

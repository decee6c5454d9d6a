/// @file
/// The line that shows how far a run has come.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "verify/report.hpp"

namespace fixproof {

/// One line on a terminal, drawn again and again and erased at the end. If stderr is no terminal
/// nothing is written.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress(Progress&&) = delete;
  Progress& operator=(const Progress&) = delete;
  Progress& operator=(Progress&&) = delete;

  void show(const Report& report);

 private:
  bool terminal_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  /// Chunks that were done when this run began: they say nothing about its speed.
  std::uint64_t before_ = 0;
};

/// The text of the line, less than 80 columns: percent done, cases, time left, row at work. `fresh`
/// chunks were done in the last `seconds`; without any there is no estimate.
std::string progress_text(const Report& report, std::uint64_t fresh, double seconds);

}  // namespace fixproof

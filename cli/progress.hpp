/// @file
/// The line that shows how far a run has come.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "support/terminal_line.hpp"
#include "verify/report.hpp"

namespace fixproof::cli {

/// How far a verification is, and the row at work.
class Progress {
 public:
  void show(const verify::Report& report);

 private:
  support::TerminalLine line_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  /// Chunks that were done when this run began: they say nothing about its speed.
  std::uint64_t before_ = 0;
};

/// The text of the line, less than 80 columns: percent done, cases, time left, row at work. `fresh`
/// chunks were done in the last `seconds`; without any there is no estimate.
std::string progress_text(const verify::Report& report, std::uint64_t fresh, double seconds);

}  // namespace fixproof::cli

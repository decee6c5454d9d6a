/// @file
/// Progress line of a verification.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "support/terminal_line.hpp"
#include "verify/report.hpp"

namespace fixproof::cli {

class Progress {
 public:
  void show(const verify::Report& report);

 private:
  support::TerminalLine line_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::uint64_t before_ = 0;  ///< chunks done by earlier runs, which its speed excludes
};

/// Formats percent done, cases, time left and the current row in less than 80 columns.
/// @param fresh chunks done in the last `seconds`; if 0, the text omits the time left
std::string progress_text(const verify::Report& report, std::uint64_t fresh, double seconds);

}  // namespace fixproof::cli

/// @file
/// The line that shows how many frames are done.
#pragma once

#include <chrono>
#include <cstdint>

#include "verify/terminal_line.hpp"

namespace fixproof {

/// Drawn a few times a second.
class FrameProgress {
 public:
  /// @param all at least 1
  explicit FrameProgress(std::uint64_t all) : all_(all) {}

  void show(std::uint64_t done);

 private:
  using clock = std::chrono::steady_clock;

  std::uint64_t all_;
  TerminalLine line_;
  clock::time_point begin_ = clock::now();
  clock::time_point last_ = begin_;
};

}  // namespace fixproof

/// @file
/// The line that shows how many frames, or other things of equal work, are done.
#pragma once

#include <chrono>
#include <cstdint>
#include <string_view>

#include "support/terminal_line.hpp"

namespace fixproof::support {

/// How many of them are done and about how long the others will take, drawn a few times a second.
class FrameProgress {
 public:
  /// @param all  at least 1
  /// @param what they are, in the plural
  explicit FrameProgress(std::uint64_t all, std::string_view what = "frames")
      : all_(all), what_(what) {}

  void show(std::uint64_t done);

 private:
  using clock = std::chrono::steady_clock;

  std::uint64_t all_;
  std::string_view what_;
  TerminalLine line_;
  clock::time_point begin_ = clock::now();
  clock::time_point last_ = begin_;
};

}  // namespace fixproof::support

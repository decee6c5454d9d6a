/// @file
/// A progress line for frames, or for other items of equal work.
#pragma once

#include <chrono>
#include <cstdint>
#include <string_view>

#include "support/terminal_line.hpp"

namespace fixproof::support {

/// Draws the number of finished items and the estimated time left, a few times per second.
class FrameProgress {
 public:
  /// @param all  number of items, at least 1
  /// @param what name of the items, in the plural
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

/// @file
/// The line that shows how many frames are done.
#pragma once

#include <chrono>
#include <cstdint>

namespace fixproof {

/// One line on a terminal, drawn a few times a second and erased at the end. If stderr is no
/// terminal nothing is written.
class FrameProgress {
 public:
  /// @param all at least 1
  explicit FrameProgress(std::uint64_t all);
  ~FrameProgress();
  FrameProgress(const FrameProgress&) = delete;
  FrameProgress& operator=(const FrameProgress&) = delete;
  FrameProgress(FrameProgress&&) = delete;
  FrameProgress& operator=(FrameProgress&&) = delete;

  void show(std::uint64_t done);

 private:
  using clock = std::chrono::steady_clock;

  std::uint64_t all_;
  bool terminal_;
  bool drawn_ = false;
  clock::time_point begin_ = clock::now();
  clock::time_point last_ = begin_;
};

}  // namespace fixproof

#include "verify/frame_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "verify/text.hpp"

namespace fixproof {

FrameProgress::FrameProgress(std::uint64_t all)
    : all_(all), terminal_(::isatty(STDERR_FILENO) == 1) {}

FrameProgress::~FrameProgress() {
  if (drawn_) fmt::print(stderr, "\r\x1b[K");
}

void FrameProgress::show(std::uint64_t done) {
  const auto now = clock::now();
  if (!terminal_ || done == 0 || now - last_ < std::chrono::milliseconds(200)) return;
  last_ = now;
  const std::chrono::duration<double> passed = now - begin_;
  const double left = passed.count() / static_cast<double>(done) * static_cast<double>(all_ - done);
  fmt::print(stderr, "\r{:3} %, {} of {} frames, about {} left\x1b[K", done * 100 / all_,
             grouped(done), grouped(all_), duration(left));
  drawn_ = true;
}

}  // namespace fixproof

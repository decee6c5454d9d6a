#include "support/frame_progress.hpp"

#include <fmt/format.h>

#include "support/plain_text.hpp"

namespace fixproof::support {

void FrameProgress::show(std::uint64_t done) {
  const auto now = clock::now();
  if (!line_.is_seen() || done == 0 || now - last_ < std::chrono::milliseconds(200)) return;
  last_ = now;
  const std::chrono::duration<double> passed = now - begin_;
  const double left = passed.count() / static_cast<double>(done) * static_cast<double>(all_ - done);
  line_.show(fmt::format("{:3} %, {} of {} {}, about {} left", done * 100 / all_, grouped(done),
                         grouped(all_), what_, duration(left)));
}

}  // namespace fixproof::support

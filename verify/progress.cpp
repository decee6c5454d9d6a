#include "verify/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "verify/text.hpp"

namespace fixproof {

namespace {

/// The row of the first chunk that is still to be done.
std::string row_at_work(const Report& report) {
  for (std::uint64_t chunk = 0; chunk < report.done.size(); ++chunk) {
    if (!report.shard.has(chunk) || report.done[chunk]) continue;
    return name_of(report.plan.rows()[report.plan.chunk(chunk).job->row].variant);
  }
  return "";
}

}  // namespace

std::string progress_text(const Report& report, std::uint64_t fresh, double seconds) {
  const std::uint64_t done = report.chunks_done();
  const std::uint64_t all = report.chunks_in_shard();
  std::string text =
      fmt::format("{:3} %, {} cases", all == 0 ? 100 : done * 100 / all, grouped(report.cases()));
  if (fresh > 0) {
    // Chunks are cut to take about the same time.
    const double left = seconds * static_cast<double>(all - done) / static_cast<double>(fresh);
    text +=
        fmt::format(", about {} left", left < 60 ? fmt::format("{:.0f} s", left) : duration(left));
  }
  return text + ": " + row_at_work(report);
}

Progress::Progress() : terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (drawn_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::show(const Report& report) {
  if (!terminal_) return;
  const std::uint64_t done = report.chunks_done();
  if (!drawn_) before_ = done;
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
  fmt::print(stderr, "\r{}\x1b[K", progress_text(report, done - before_, passed.count()));
  drawn_ = true;
}

}  // namespace fixproof

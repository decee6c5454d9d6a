#include "app/cli/progress.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/plain_text.hpp"

namespace fixproof::cli {

namespace {

std::string row_at_work(const verify::Report& report) {
  for (std::uint64_t chunk = 0; chunk < report.done.size(); ++chunk) {
    if (!report.shard.has(chunk) || report.done[chunk]) continue;
    return cases::name_of(report.plan.rows()[report.plan.chunk(chunk).job->row].variant);
  }
  return "";
}

}  // namespace

std::string progress_text(const verify::Report& report, std::uint64_t fresh, double seconds) {
  const std::uint64_t done = report.chunks_done();
  const std::uint64_t all = report.chunks_in_shard();
  std::string text = fmt::format("{:3} %, {} cases", all == 0 ? 100 : done * 100 / all,
                                 support::grouped(report.cases()));
  if (fresh > 0) {
    // All chunks take about the same time.
    const double left = seconds * static_cast<double>(all - done) / static_cast<double>(fresh);
    text += fmt::format(", about {} left",
                        left < 60 ? fmt::format("{:.0f} s", left) : support::duration(left));
  }
  return text + ": " + row_at_work(report);
}

void Progress::show(const verify::Report& report) {
  if (!line_.is_seen()) return;
  const std::uint64_t done = report.chunks_done();
  if (!line_.is_drawn()) before_ = done;
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
  line_.show(progress_text(report, done - before_, passed.count()));
}

}  // namespace fixproof::cli

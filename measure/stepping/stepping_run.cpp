#include "measure/stepping/stepping_run.hpp"

#include <mutex>

#include "support/thread_pool.hpp"

namespace fixproof::measure {

namespace {

/// Keys of the random streams.
constexpr std::uint64_t place_key = 1;
constexpr std::uint64_t ends_key = 2;

std::uint64_t case_number(std::size_t pixels, std::uint64_t i) {
  return i * (xsharp::longest_span + 1) + pixels;
}

}  // namespace

SpanPlace span_place(std::uint64_t seed, std::size_t pixels, std::uint64_t i) {
  const auto whole = static_cast<std::int64_t>(pixels) * 65536;
  if (i % 8 < 2) return {pixels, whole, 0};
  cases::Draw draw(cases::mix(seed) + place_key, case_number(pixels, i));
  const bool extremes = span_ends(i) == Ends::extreme;
  const std::uint64_t extreme = extremes ? draw.below(8) : 8;
  const std::int64_t distance = extreme == 0   ? 65535
                                : extreme == 1 ? 0
                                               : static_cast<std::int64_t>(draw.below(65536));
  // The right end is at most one pixel beyond the last centre.
  const std::int64_t last = distance + whole - 65536;
  const std::uint64_t end = extremes ? draw.below(8) : 8;
  const std::int64_t behind = end == 0   ? 1
                              : end == 1 ? 65536
                                         : 1 + static_cast<std::int64_t>(draw.below(65536));
  return {pixels, last + behind, distance};
}

Ends span_ends(std::uint64_t i) { return i % 2 == 0 ? Ends::extreme : Ends::random; }

std::vector<SteppingVariant> stepping_variants() {
  std::vector<SteppingVariant> all = line_variants();
  for (const auto& more : {texture_variants(), phong_variants()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

std::vector<SteppingRow> measure_stepping_rows(const std::vector<SteppingVariant>& variants,
                                               std::uint64_t seed, std::uint64_t cases,
                                               const std::atomic<bool>& stop,
                                               const std::function<void(std::uint64_t)>& done) {
  std::vector<SteppingRow> rows;
  for (const SteppingVariant& variant : variants) rows.push_back({variant, {}});
  std::mutex mutex;
  std::uint64_t finished = 0;
  support::for_each_in_threads(rows.size(), [&](std::size_t k) {
    const SteppingVariant& variant = variants[k];
    SteppingStatistics& statistics = rows[k].statistics;
    SteppedSpan span;
    for (std::size_t pixels = 1; pixels <= xsharp::longest_span; ++pixels) {
      for (std::uint64_t i = 0; i < cases; ++i) {
        if (stop) return;
        const SpanPlace place = span_place(seed, pixels, i);
        span.clear();
        const Ends ends = span_ends(i);
        variant.step(place, ends, cases::Draw(cases::mix(seed) + ends_key, case_number(pixels, i)),
                     span);
        statistics.add_errors(place, span);
        if (ends == Ends::random) statistics.add_picture(span, variant.drawn == Drawn::texel);
      }
    }
    const std::lock_guard lock(mutex);
    done(++finished);
  });
  if (stop) rows.clear();
  return rows;
}

}  // namespace fixproof::measure

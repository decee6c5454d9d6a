#include "measure/stepping/stepping_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace fixproof::measure {

namespace {

/// The end of the run of equal pixels that begins at `from`.
std::size_t end_of_run(const std::vector<std::int64_t>& pixels, std::size_t from) {
  std::size_t to = from + 1;
  while (to < pixels.size() && pixels[to] == pixels[from]) ++to;
  return to;
}

std::uint64_t runs_of(const std::vector<std::int64_t>& pixels) {
  std::uint64_t runs = 0;
  for (std::size_t i = 0; i < pixels.size(); i = end_of_run(pixels, i)) ++runs;
  return runs;
}

/// The distance of two pixel values; for texels, in columns or rows.
std::int64_t apart(std::int64_t a, std::int64_t b, bool texels) {
  if (!texels) return std::abs(a - b);
  return std::max(std::abs(a % 256 - b % 256), std::abs(a / 256 - b / 256));
}

}  // namespace

void ErrorAndBound::add(const SteppedValue& value) {
  error = std::max(error, std::fabs(value.error));
  bound = std::max(bound, value.bound);
}

void SteppingStatistics::add_errors(const SpanPlace& place, const SteppedSpan& span) {
  ++spans;
  pixels += place.pixels;
  for (std::size_t k = 0; k < place.pixels; ++k) {
    const SteppedValue& value = span.values[k];
    all.add(value);
    if (value.error != 0)
      part_of_bound = std::max(part_of_bound, std::fabs(value.error) / value.bound);
    if (!value.within && beyond.empty()) {
      beyond = fmt::format(
          "pixel {} of {}, the first {}/65536 of {}/65536 pixels in, is off by {}, "
          "bound {}",
          k, place.pixels, place.distance, place.units, value.error, value.bound);
    }
  }
  last.add(span.values.back());
  for (std::size_t i = 0; i < lengths; ++i) {
    if (length(i) == place.pixels) last_of.at(i).add(span.values.back());
  }
  if (place.pixels == xsharp::longest_span) {
    for (std::size_t i = 0; i < places; ++i) along.at(i).add(span.values[pixel_at(i)]);
  }
}

void SteppingStatistics::add_picture(const SteppedSpan& span, bool texels) {
  drawn += span.drawn.size();
  for (std::size_t k = 0; k < span.drawn.size(); ++k) {
    if (span.drawn[k] == span.exact[k]) continue;
    ++wrong;
    max_error = std::max(max_error, apart(span.drawn[k], span.exact[k], texels));
  }
  add_bands(span);
  add_missed(span);
}

void SteppingStatistics::add_bands(const SteppedSpan& span) {
  bands.exact += runs_of(span.exact);
  std::uint64_t wrong_run = 0;
  for (std::size_t from = 0; from < span.drawn.size();) {
    const std::size_t to = end_of_run(span.drawn, from);
    ++bands.drawn;
    // A drawn run is right if the exact picture has the same run with the same ends.
    const bool begins = from == 0 || span.exact[from - 1] != span.exact[from];
    const bool same =
        begins && span.exact[from] == span.drawn[from] && end_of_run(span.exact, from) == to;
    if (!same) ++bands.wrong;
    from = to;
  }
  for (std::size_t k = 0; k < span.drawn.size(); ++k) {
    wrong_run = span.drawn[k] == span.exact[k] ? 0 : wrong_run + 1;
    bands.widest = std::max(bands.widest, wrong_run);
  }
}

void SteppingStatistics::add_missed(const SteppedSpan& span) {
  static thread_local std::vector<std::int64_t> is;
  static thread_local std::vector<std::int64_t> should_be;
  is = span.drawn;
  should_be = span.exact;
  std::ranges::sort(is);
  std::ranges::sort(should_be);
  should_be.erase(std::unique(should_be.begin(), should_be.end()), should_be.end());
  wanted += should_be.size();
  auto next = is.begin();
  for (const std::int64_t value : should_be) {
    while (next != is.end() && *next < value) ++next;
    if (next == is.end() || *next != value) ++missed;
  }
}

}  // namespace fixproof::measure

/// @file
/// Divides rows into pieces for one loop call each, and into stretches between exact values.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "xsharp/arithmetic.hpp"
#include "xsharp/raster/span_loops.hpp"
#include "xsharp/raster/step.hpp"
#include "xsharp/ratio.hpp"

namespace xsharp {

/// The stepped value at `units` of 2^-16 pixels from the first pixel, by one multiplication.
template <Scalar N>
N value_after(const Step<N>& step, std::int64_t units) {
  return units == 0 ? step.start : step.start + step.slope * distance_of<N>(units);
}

constexpr std::int64_t units_of(std::size_t pixels) {
  return static_cast<std::int64_t>(pixels) * 65536;
}

/// The same steps, starting at another pixel.
template <Scalar N>
Step<N> step_from(const Step<N>& step, std::size_t pixel) {
  return {value_after(step, units_of(pixel)), step.slope};
}

/// Calls draw(from, count) for pieces of at most longest_span pixels.
template <class Draw>
void in_pieces(std::size_t count, const Draw& draw) {
  for (std::size_t from = 0; from < count; from += longest_span) {
    draw(from, std::min(longest_span, count - from));
  }
}

/// The pixels from one exact value to the next.
struct Stretch {
  std::size_t from = 0;
  std::size_t to = 0;
  /// The number of pixels drawn. `to` belongs to the next stretch, unless it is the last of the
  /// row.
  std::size_t count = 0;
};

/// The straight line through two values `pixels` pixels apart; constant if `pixels` is 0.
template <Scalar N>
Step<N> line_between(N from, N to, std::size_t pixels) {
  if (pixels == 0) return {from, from_whole<N>(0)};
  return {from, ratio(to - from, from_whole<N>(static_cast<std::int32_t>(pixels)))};
}

/// Computes exact values at the first pixel, every `every` pixels and at the last, and calls
/// draw(stretch, lines) with straight lines between.
/// @param exact returns the std::array of the K values at a pixel
/// @pre count and every are above 0
template <class Exact, class Draw>
void in_stretches(std::size_t count, std::size_t every, const Exact& exact, const Draw& draw) {
  auto here = exact(std::size_t{0});
  for (std::size_t from = 0;;) {
    const std::size_t to = std::min(from + every, count - 1);
    const bool last = to + 1 == count;
    const auto next = exact(to);
    std::array<Step<typename decltype(here)::value_type>, here.size()> lines{};
    for (std::size_t i = 0; i < lines.size(); ++i) {
      lines[i] = line_between(here[i], next[i], to - from);
    }
    draw(Stretch{from, to, to - from + (last ? 1 : 0)}, lines);
    if (last) return;
    from = to;
    here = next;
  }
}

}  // namespace xsharp

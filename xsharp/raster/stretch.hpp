/// @file
/// Rows in parts: in pieces that a loop draws at once, and in stretches from one exact value to the
/// next.
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

/// A stepped value `units` of 2^-16 pixels from the first pixel, by one multiplication.
template <Scalar N>
N value_after(const Step<N>& step, std::int64_t units) {
  return units == 0 ? step.start : step.start + step.slope * distance_of<N>(units);
}

constexpr std::int64_t units_of(std::size_t pixels) {
  return static_cast<std::int64_t>(pixels) * 65536;
}

/// The same steps from another pixel on.
template <Scalar N>
Step<N> step_from(const Step<N>& step, std::size_t pixel) {
  return {value_after(step, units_of(pixel)), step.slope};
}

/// draw(from, count) for pieces of longest_span pixels at most.
template <class Draw>
void in_pieces(std::size_t count, const Draw& draw) {
  for (std::size_t from = 0; from < count; from += longest_span) {
    draw(from, std::min(longest_span, count - from));
  }
}

/// From an exact pixel to the next.
struct Stretch {
  std::size_t from = 0;
  std::size_t to = 0;
  /// Pixels drawn: `to` is drawn with what follows, unless it is the row's last.
  std::size_t count = 0;
};

/// The straight line through two values `pixels` pixels apart, of which 0 are one value.
template <Scalar N>
Step<N> line_between(N from, N to, std::size_t pixels) {
  if (pixels == 0) return {from, from_whole<N>(0)};
  return {from, ratio(to - from, from_whole<N>(static_cast<std::int32_t>(pixels)))};
}

/// Values that are exact at the first pixel, every `every` further and at the last, with straight
/// lines between: draw(stretch, lines).
/// @param exact std::array of the K values at a pixel
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

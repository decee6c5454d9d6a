/// @file
/// Linear stepping for edges and spans: one addition per pixel.
///
/// There are exactly three roundings:
/// - the slope, end minus start over pixels, rounds as the arithmetic's divide;
/// - the start, the value at the first pixel's centre, is computed from the end of the edge or span
///   by slope times distance and rounds as the arithmetic's multiply. Distances are exact
///   (edge.hpp), truncated to 16 bits after the point;
/// - drawing takes the whole part of the word, as the loops take it out of a register.
/// If a loop's word has fewer bits after the point than 16.16, start and slope are rounded half up
/// to the nearest word. Edges are always stepped in 16.16.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "xsharp/arithmetic.hpp"
#include "xsharp/ratio.hpp"

namespace xsharp {

/// A distance on the screen in units of 2^-16 pixels; saturates.
template <Scalar N>
N distance_of(std::int64_t units) {
  using limits = std::numeric_limits<std::int32_t>;
  return Arithmetic<N>::from_raw(
      static_cast<std::int32_t>(std::clamp<std::int64_t>(units, limits::min(), limits::max())));
}

/// The increment per pixel from one value to another.
/// @param units the distance, in 2^-16 pixels; at least one pixel
template <Scalar N>
N slope(N from, N to, std::int64_t units) {
  N difference = to - from;
  // Drawn pixels are within 4096 pixels, but the whole distance may exceed 16.16.
  for (; units > std::numeric_limits<std::int32_t>::max(); units /= 2) {
    difference = Arithmetic<N>::midpoint(difference, from_whole<N>(0));
  }
  return ratio(difference, distance_of<N>(units));
}

/// The value at the first pixel's centre, and the increment per pixel.
template <Scalar N>
struct Step {
  N start{};
  N slope{};
};

/// A value across a row.
/// @param units    the distance from where the value is `from` to where it is `to`, in 2^-16 pixels
/// @param distance from where it is `from` to the first pixel's centre, likewise; below `units`
///
/// If `units` is less than a pixel there is only one centre, and the slope would leave 16.16: the
/// start is then from + (to - from) * (distance / units), and the slope 0.
template <Scalar N>
Step<N> step_across(N from, N to, std::int64_t units, std::int64_t distance) {
  if (units < 65536) {
    const N part = ratio(distance_of<N>(distance), distance_of<N>(units));
    return {from + (to - from) * part, from_whole<N>(0)};
  }
  const N by = slope(from, to, units);
  return {from + by * distance_of<N>(distance), by};
}

/// The nearest word with 16 - dropped bits after the point, rounded half up.
constexpr std::uint32_t word_of(std::int32_t raw, unsigned dropped) {
  if (dropped == 0) return static_cast<std::uint32_t>(raw);
  const std::int64_t half = std::int64_t{1} << (dropped - 1);
  return static_cast<std::uint32_t>((raw + half) >> dropped);
}

/// The arguments of a loop.
struct StepWords {
  std::uint32_t start = 0;
  std::uint32_t step = 0;

  friend constexpr bool operator==(const StepWords&, const StepWords&) = default;
};

/// The bits of 16.16 that the loops' words lack: intensity is 8.8 and depth 16.8.
inline constexpr unsigned dropped_bits = 8;

template <Scalar N>
StepWords words_of(const Step<N>& step, unsigned dropped) {
  return {word_of(Arithmetic<N>::raw(step.start), dropped),
          word_of(Arithmetic<N>::raw(step.slope), dropped)};
}

}  // namespace xsharp

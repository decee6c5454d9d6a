/// @file
/// Spans as they are stepped and as they are exactly.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cases/draw.hpp"
#include "xsharp/raster/span_loops.hpp"

namespace fixproof::measure {

/// Where a span lies, in 2^-16 pixels: its left end is 0, pixel k's centre at
/// distance + 65536 k, and the last centre is the last left of the right end.
struct SpanPlace {
  std::size_t pixels = 1;     ///< 1 to xsharp::longest_span
  std::int64_t units = 1;     ///< where the right end is: above the last centre, 65536 at most
  std::int64_t distance = 0;  ///< where the first centre is, 0 to 65535

  [[nodiscard]] std::int64_t centre(std::size_t k) const {
    return distance + 65536 * static_cast<std::int64_t>(k);
  }
  /// Whether both ends are pixels' centres.
  [[nodiscard]] bool whole() const { return distance == 0 && units % 65536 == 0; }
};

/// A value at a pixel, in what is drawn of it: levels of light, units of depth, texels.
struct SteppedValue {
  double error = 0;    ///< the stepped value, before it is cut, less the exact one
  double bound = 0;    ///< what the magnitude of the error is at most, as derived
  bool within = true;  ///< whether it is, by integers where these can tell
};

/// Of two coordinates that which uses more of its bound; within where both are.
inline SteppedValue nearer_bound(SteppedValue a, const SteppedValue& b) {
  const bool within = a.within && b.within;
  if (std::fabs(b.error) * a.bound > std::fabs(a.error) * b.bound) a = b;
  a.within = within;
  return a;
}

/// Room for one span at a time. Of a texture, a pixel's value is that of its two coordinates that
/// is nearer its bound, and what is drawn is row * 256 + column.
struct SteppedSpan {
  std::vector<SteppedValue> values;
  std::vector<std::int64_t> drawn;
  std::vector<std::int64_t> exact;  ///< what the exact value is when it is cut

  void clear() {
    values.clear();
    drawn.clear();
    exact.clear();
  }
};

/// What the values at the ends of a span are: anything in their range, or what stepping errs by
/// most: the ends of the range, and what was worked out to be bad.
enum class Ends { random, extreme };

enum class Drawn { level, depth, texel };

/// One way of stepping one kind of value.
struct SteppingVariant {
  std::string value;  ///< "intensity 8.8"
  std::string rule;   ///< how slope and start come about
  Drawn drawn{};
  std::string range;  ///< of the values at the ends
  /// Appends a span's pixels to room that is clear.
  std::function<void(const SpanPlace&, Ends, cases::Draw, SteppedSpan&)> step;
};

/// Straight lines: intensity in 8.8 and 16.16, depth in 16.8, coordinates of a bitmap in 8.8.
std::vector<SteppingVariant> line_variants();
/// Textures in perspective, by exact places every so many pixels.
std::vector<SteppingVariant> texture_variants();
/// Phong's light in its three forms.
std::vector<SteppingVariant> phong_variants();

}  // namespace fixproof::measure

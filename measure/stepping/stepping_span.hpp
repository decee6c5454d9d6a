/// @file
/// The stepped and the exact values of a span.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "verify/cases/draw.hpp"
#include "xsharp/raster/span_loops.hpp"

namespace fixproof::measure {

/// The position of a span, in 2^-16 pixels. Its left end is 0 and pixel k's centre is distance +
/// 65536 k. The last centre is the last one left of the right end.
struct SpanPlace {
  std::size_t pixels = 1;     ///< 1 to xsharp::longest_span
  std::int64_t units = 1;     ///< right end: above the last centre by at most 65536
  std::int64_t distance = 0;  ///< the first centre, 0 to 65535

  [[nodiscard]] std::int64_t centre(std::size_t k) const {
    return distance + 65536 * static_cast<std::int64_t>(k);
  }
  /// Whether both ends are pixel centres.
  [[nodiscard]] bool whole() const { return distance == 0 && units % 65536 == 0; }
};

/// A pixel's error, in levels of light, units of depth or texels.
struct SteppedValue {
  double error = 0;    ///< the stepped value before truncation minus the exact one
  double bound = 0;    ///< the derived bound of the error's magnitude
  bool within = true;  ///< whether the bound holds, compared as integers if possible
};

/// The value that uses more of its bound. It is within its bound if both are.
inline SteppedValue nearer_bound(SteppedValue a, const SteppedValue& b) {
  const bool within = a.within && b.within;
  if (std::fabs(b.error) * a.bound > std::fabs(a.error) * b.bound) a = b;
  a.within = within;
  return a;
}

/// The pixels of one span. For a texture, a pixel's value is that of the coordinate that is nearer
/// its bound, and the drawn value is row * 256 + column.
struct SteppedSpan {
  std::vector<SteppedValue> values;
  std::vector<std::int64_t> drawn;
  std::vector<std::int64_t> exact;  ///< the truncated exact values

  void clear() {
    values.clear();
    drawn.clear();
    exact.clear();
  }
};

/// The values at the ends of a span: random ones in their range, or those with the largest stepping
/// errors, such as the ends of the range.
enum class Ends { random, extreme };

enum class Drawn { level, depth, texel };

/// One rule for stepping one kind of value.
struct SteppingVariant {
  std::string value;  ///< "intensity 8.8"
  std::string rule;   ///< the rule for slope and start
  Drawn drawn{};
  std::string range;  ///< of the values at the ends
  /// Appends the pixels of a span to a cleared SteppedSpan.
  std::function<void(const SpanPlace&, Ends, cases::Draw, SteppedSpan&)> step;
};

/// Straight lines: intensity in 8.8 and 16.16, depth in 16.8, coordinates of a bitmap in 8.8.
std::vector<SteppingVariant> line_variants();
/// Textures in perspective, with exact texture coordinates at intervals.
std::vector<SteppingVariant> texture_variants();
/// Phong light in its three forms.
std::vector<SteppingVariant> phong_variants();

}  // namespace fixproof::measure

/// @file
/// How far from its place a divide puts a projected point.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace fixproof::measure {

/// The projection of a scene: x over z, times a constant, to the middle of the page.
struct PageProjection {
  std::int32_t constant = -320;   ///< in pixels
  std::int32_t half_width = 160;  ///< points beyond are not on the page
};

/// Points at distances from `nearest` to twice as much.
struct DistanceOctave {
  std::int32_t nearest = 0;
  double max = 0;   ///< the largest error, in pixels
  double mean = 0;  ///< of the magnitudes
  double half = 0;  ///< the share of points half a pixel off or more
};

struct PixelErrors {
  std::string name;  ///< of the preset that divides and multiplies
  std::vector<DistanceOctave> octaves;
  /// At this distance and beyond, every point of the page is less than half a pixel off; nothing
  /// where that is so from the near plane on.
  std::int32_t safe_from = 0;
};

/// For the builds of the listings, from the near plane (z = -1) outward.
/// @param cases random points of an octave
std::vector<PixelErrors> measure_pixel_errors(const PageProjection& page, std::uint64_t seed,
                                              std::uint64_t cases, const std::atomic<bool>& stop);

}  // namespace fixproof::measure

/// @file
/// The screen error of a projected point due to its divide.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace fixproof::measure {

/// The projection of a scene: x / z times a constant, relative to the middle of the page.
struct PageProjection {
  std::int32_t constant = -320;   ///< in pixels
  std::int32_t half_width = 160;  ///< in pixels; points farther out are off the page
};

/// The errors at distances from `nearest` to twice `nearest`.
struct DistanceOctave {
  std::int32_t nearest = 0;
  double max = 0;   ///< the largest error, in pixels
  double mean = 0;  ///< of the magnitudes, in pixels
  double half = 0;  ///< the share of points with an error of half a pixel or more
};

struct PixelErrors {
  std::string name;  ///< the preset that divides and multiplies
  std::vector<DistanceOctave> octaves;
  /// From this distance on, every point of the page has an error below half a pixel.
  std::int32_t safe_from = 0;
};

/// Measures the builds of the listings from the near plane (z = -1) outward.
/// @param cases random points per octave
std::vector<PixelErrors> measure_pixel_errors(const PageProjection& page, std::uint64_t seed,
                                              std::uint64_t cases, const std::atomic<bool>& stop);

}  // namespace fixproof::measure

/// @file
/// Fills polygons into a page, by the rule of chains.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "xsharp/picture.hpp"
#include "xsharp/raster/chains.hpp"
#include "xsharp/raster/edge.hpp"
#include "xsharp/raster/page.hpp"

namespace xsharp {

/// Fills polygons; reuses the row buffer, so that filling does not allocate.
class Filler {
 public:
  /// Sets the polygon's pixels on the page and returns their number. The time is proportional to
  /// the page rows that the polygon's edges cross and the pixels set, not to the parts off the
  /// page.
  template <PixelType Pixel>
  std::int64_t fill(Page<Pixel>& page, std::span<const ScreenPoint> points, Pixel pixel) {
    const Chains chains(points);
    const std::int32_t top = chains.first();
    const std::int32_t bottom = chains.end(page.height());
    if (top >= bottom) return 0;
    ends_.resize(static_cast<std::size_t>(bottom - top));
    const auto store = [&](std::int64_t Ends::*end) {
      return [&, end](const ChainEdge& edge) {
        EdgeWalk walk(points[edge.upper], points[edge.lower], edge.y);
        const auto rows = std::span(ends_).subspan(static_cast<std::size_t>(edge.first - top),
                                                   static_cast<std::size_t>(edge.end - edge.first));
        for (Ends& row : rows) {
          row.*end = walk.x();
          walk.step_down();
        }
      };
    };
    chains.walk(page.height(), store(&Ends::left), store(&Ends::right));
    return paint(page, top, pixel);
  }

 private:
  struct Ends {
    std::int64_t left = 0;
    std::int64_t right = 0;  ///< the pixel after the last
  };

  template <PixelType Pixel>
  std::int64_t paint(Page<Pixel>& page, std::int32_t top, Pixel pixel) const {
    std::int64_t painted = 0;
    const std::int64_t width = page.width();
    const auto stride = static_cast<std::size_t>(width);
    const auto pixels =
        page.pixels().subspan(static_cast<std::size_t>(top) * stride, ends_.size() * stride);
    for (std::size_t row = 0; row < ends_.size(); ++row) {
      const std::int64_t left = std::max(ends_[row].left, std::int64_t{0});
      const std::int64_t right = std::min(ends_[row].right, width);
      if (left >= right) continue;
      const auto start = pixels.begin() + (static_cast<std::ptrdiff_t>(row) * width + left);
      std::fill(start, start + (right - left), pixel);
      painted += right - left;
    }
    return painted;
  }

  std::vector<Ends> ends_;
};

}  // namespace xsharp

/// @file
/// Computed bitmaps for texture mapping.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "xsharp/raster/span_loops.hpp"
#include "xsharp/raster/step.hpp"
#include "xsharp/surface.hpp"

namespace xsharp {

/// bitmap_texels texels in row-major order: column u of row v is at v * 256 + u.
inline std::vector<std::uint8_t> bitmap_of(const Surface& surface) {
  std::vector<std::uint8_t> texels(bitmap_texels);
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const std::size_t u = i % 256;
    const std::size_t v = i / 256;
    bool second = (u / 32 + v / 32) % 2 == 1;
    if (surface.pattern == Pattern::bricks) {
      const std::size_t along = u + v / 32 % 2 * 32;
      second = v % 32 < 4 || along % 64 < 4;
    }
    texels[i] = surface.texels[second ? 1 : 0];
  }
  return texels;
}

/// The words for one coordinate, with 256 units per texel, adjusted so that every pixel is in the
/// bitmap. Coordinates at corners are half a texel inside it, and stepping errs by half a unit per
/// pixel or more: beyond 255 pixels a row or an edge can leave the bitmap and wrap to its other
/// side. If so, the slope is reduced so that the last pixel is inside, by less than a unit below
/// the exact slope.
constexpr StepWords inside_bitmap(StepWords words, std::size_t pixels) {
  const auto inside = [](std::int64_t place) { return std::clamp<std::int64_t>(place, 0, 0xFFFF); };
  const std::int64_t start = inside(static_cast<std::int32_t>(words.start));
  std::int64_t step = static_cast<std::int32_t>(words.step);
  if (pixels > 1) {
    const auto steps = static_cast<std::int64_t>(pixels - 1);
    const std::int64_t last = start + steps * step;
    if (last != inside(last)) step = (inside(last) - start) / steps;
  }
  return {static_cast<std::uint32_t>(start), static_cast<std::uint32_t>(step)};
}

}  // namespace xsharp

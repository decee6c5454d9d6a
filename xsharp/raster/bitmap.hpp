/// @file
/// Bitmaps for texture mapping, computed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "xsharp/raster/span_loops.hpp"
#include "xsharp/surface.hpp"

namespace xsharp {

/// bitmap_texels texels, row by row: what is at column u of row v is at v * 256 + u.
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

}  // namespace xsharp

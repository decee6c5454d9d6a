/// @file
/// A row under a depth buffer with a different value per pixel; no published listing does this.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "xsharp/raster/step.hpp"

namespace xsharp {

/// SpanLoops::depth with one pixel value per position, and with the test for either axis: writes if
/// the depth is greater or, reversed, less.
/// @pre buffer and pixels have the size of out
inline void depth_row(std::span<std::uint8_t> out, std::span<std::int16_t> buffer,
                      std::span<const std::uint8_t> pixels, StepWords words, bool reversed) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto depth = static_cast<std::int16_t>(words.start >> 8U);
    if (reversed ? depth < buffer[i] : depth > buffer[i]) {
      out[i] = pixels[i];
      buffer[i] = depth;
    }
    words.start += words.step;
  }
}

}  // namespace xsharp

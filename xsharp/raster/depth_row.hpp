/// @file
/// A row under a depth buffer, on the words of span_loops.hpp, as no published listing has it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "xsharp/raster/step.hpp"

namespace xsharp {

/// The loop of SpanLoops::depth with a pixel of its own at each place, and with the test for either
/// axis: written where the depth is greater, or, reversed, less.
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

/// @file
/// Independent readers of PNG and APNG: libpng's sequential reader, and a chunk reader that checks
/// every chunk.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "xsharp/raster/page.hpp"

namespace read_png {

/// Reads every pixel as a colour with libpng. For an animation, this is the first frame.
/// @throws std::runtime_error with libpng's message
xsharp::Page<std::uint32_t> by_libpng(std::string_view png);

struct Animation {
  std::uint32_t announced = 0;  ///< number of frames in acTL
  std::uint32_t plays = 0;      ///< 0 repeats forever
  std::vector<xsharp::Page<std::uint32_t>> frames;
  std::vector<std::string> times;  ///< delay of each frame, such as "1/60"
};

/// Reads 8-bit indexed or RGB pixels; all frames must have the full size.
/// @throws std::runtime_error if a length, a checksum, an order or a sequence number is wrong
Animation by_chunks(std::string_view apng);

}  // namespace read_png

/// @file
/// PNG and APNG read by other means than they are written with: libpng's sequential reader, and a
/// reader of the chunks that checks each of them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "xsharp/raster/page.hpp"

namespace read_png {

/// What libpng makes of it: every pixel as a colour. An animation is its first frame.
/// @throws std::runtime_error with what libpng says
xsharp::Page<std::uint32_t> by_libpng(std::string_view png);

struct Animation {
  std::uint32_t announced = 0;  ///< frames, in acTL
  std::uint32_t plays = 0;      ///< 0: for ever
  std::vector<xsharp::Page<std::uint32_t>> frames;
  std::vector<std::string> times;  ///< of each frame: "1/60"
};

/// Reads 8-bit pixels, indexed or RGB, all frames of the whole size.
/// @throws std::runtime_error if a length, a checksum, an order or a sequence number is wrong
Animation by_chunks(std::string_view apng);

}  // namespace read_png

/// @file
/// Encodes pages as PNG images in memory.
#pragma once

#include <cstdint>
#include <string>

#include "xsharp/raster/page.hpp"
#include "xsharp/raster/palette.hpp"

namespace xsharp {

/// Encodes an indexed PNG with all 256 colours of the palette, so that every page with this palette
/// has the same header.
/// @throws std::runtime_error with libpng's message
std::string encode_png(const Page<std::uint8_t>& page, const Palette& palette);

/// Encodes a PNG with 8 bits each of red, green and blue.
/// @throws std::runtime_error with libpng's message
std::string encode_png(const Page<std::uint32_t>& page);

}  // namespace xsharp

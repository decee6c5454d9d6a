/// @file
/// A row of pixels on a page.
#pragma once

#include <cstdint>

namespace xsharp {

/// The pixels left to right - 1 of row y, with left < right.
struct PixelRow {
  std::int32_t y = 0;
  std::int32_t left = 0;
  std::int32_t right = 0;
};

}  // namespace xsharp

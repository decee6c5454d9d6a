/// @file
/// The palettes, and their indices for colours.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "xsharp/picture.hpp"
#include "xsharp/raster/page.hpp"
#include "xsharp/scene.hpp"

namespace xsharp {

using Palette = std::array<Color, 256>;

namespace detail {

/// Expands 6 bits of the VGA's DAC to 8: 0 stays 0 and 63 becomes 255.
constexpr std::uint8_t from_dac(unsigned level) {
  return static_cast<std::uint8_t>(level << 2U | level >> 4U);
}

constexpr Color from_dac(unsigned red, unsigned green, unsigned blue) {
  return {from_dac(red), from_dac(green), from_dac(blue)};
}

/// Hue 0 to 23 of a ring from blue through magenta, red, yellow, green and cyan back to blue, four
/// hues per sixth. `levels` rises from the smallest component to the largest.
constexpr Color on_ring(std::size_t hue, const std::array<unsigned, 5>& levels) {
  const std::size_t step = hue % 4;
  const unsigned least = levels.front();
  const unsigned most = levels.back();
  const unsigned rising = levels.at(step);
  const unsigned falling = levels.at(4 - step);
  switch (hue / 4) {
    case 0:
      return from_dac(rising, least, most);
    case 1:
      return from_dac(most, least, falling);
    case 2:
      return from_dac(most, rising, least);
    case 3:
      return from_dac(falling, most, least);
    case 4:
      return from_dac(least, most, rising);
    default:
      return from_dac(least, falling, most);
  }
}

}  // namespace detail

/// The default palette of VGA mode 13h: the 16 EGA colours, 16 greys, a ring of 24 hues in three
/// saturations of each of three values, and 8 times black.
constexpr Palette vga_palette() {
  Palette palette{};
  for (std::size_t i = 0; i < 16; ++i) {
    // Bit 3 adds a third of full intensity to every component; bits 2 to 0 add two thirds to one
    // each.
    const auto level = [i](unsigned bit) {
      return 42U * (static_cast<unsigned>(i) >> bit & 1U) + 21U * (static_cast<unsigned>(i) >> 3U);
    };
    palette.at(i) = detail::from_dac(level(2), level(1), level(0));
  }
  palette[6] = detail::from_dac(42, 21, 0);  // brown: dark yellow with half its green

  constexpr std::array<unsigned, 16> greys{0,  5,  8,  11, 14, 17, 20, 24,
                                           28, 32, 36, 40, 45, 50, 56, 63};
  for (std::size_t i = 0; i < greys.size(); ++i) {
    palette.at(16 + i) = detail::from_dac(greys.at(i), greys.at(i), greys.at(i));
  }

  constexpr std::array<std::array<unsigned, 5>, 9> rings{{{0, 16, 31, 47, 63},
                                                          {31, 39, 47, 55, 63},
                                                          {45, 49, 54, 58, 63},
                                                          {0, 7, 14, 21, 28},
                                                          {14, 17, 21, 24, 28},
                                                          {20, 22, 24, 26, 28},
                                                          {0, 4, 8, 12, 16},
                                                          {8, 10, 12, 14, 16},
                                                          {11, 12, 13, 15, 16}}};
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    for (std::size_t hue = 0; hue < 24; ++hue) {
      palette.at(32 + ring * 24 + hue) = detail::on_ring(hue, rings.at(ring));
    }
  }
  return palette;
}

/// 0 to 63: mixtures, two bits each of red, green and blue, red highest. 64 to 127, 128 to 191, 192
/// to 255: 64 levels of pure red, green, blue. Levels are evenly spaced from 0 to 255.
constexpr Palette shading_palette() {
  Palette palette{};
  for (unsigned i = 0; i < 64; ++i) {
    const auto two_bits = [i](unsigned shift) {
      return static_cast<std::uint8_t>((i >> shift & 3U) * 85U);
    };
    palette.at(i) = {two_bits(4), two_bits(2), two_bits(0)};
    palette.at(64 + i) = detail::from_dac(i, 0, 0);
    palette.at(128 + i) = detail::from_dac(0, i, 0);
    palette.at(192 + i) = detail::from_dac(0, 0, i);
  }
  return palette;
}

/// The shading palette with the author's four levels for mixtures, 63 * (level / 3)^(1 / 2.3) of
/// the DAC: a screen shows less than half its light at half of the level.
constexpr Palette shading_gamma_palette() {
  constexpr std::array<unsigned, 4> levels{0, 39, 53, 63};
  Palette palette = shading_palette();
  for (std::size_t i = 0; i < 64; ++i) {
    palette.at(i) =
        detail::from_dac(levels.at(i >> 4U), levels.at(i >> 2U & 3U), levels.at(i & 3U));
  }
  return palette;
}

/// 0 to 127 is a grey ramp, 128 to 255 a copper ramp, by the cosine of the angle to the light:
/// index 64 + 62 c of a ramp shows c, -1 to 1. The ambient light is 0.1, the diffuse light 0.65 c
/// for c above 0, and there is a white highlight of 0.25 c^16: the palette contains Phong's
/// lighting model. Index 0 is black.
constexpr Palette ramps_palette() {
  Palette palette{};
  for (unsigned i = 1; i < 256; ++i) {
    const int above = static_cast<int>(i % 128) - 64;
    const double c = above > 0 ? std::min(above / 62.0, 1.0) : 0.0;
    double highlight = c;
    for (int doubled = 0; doubled < 4; ++doubled) highlight *= highlight;
    const auto level = [&](double reflected) {
      // NOLINTNEXTLINE(bugprone-incorrect-roundings): not negative, and lround is not constexpr
      return static_cast<std::uint8_t>(255 * ((0.1 + 0.65 * c) * reflected + 0.25 * highlight) +
                                       0.5);
    };
    const bool copper = i >= 128;
    palette.at(i) = {level(1), level(copper ? 0.6 : 1), level(copper ? 0.35 : 1)};
  }
  return palette;
}

inline const Palette& palette_of(PaletteKind kind) {
  static constexpr Palette vga = vga_palette();
  static constexpr Palette shading = shading_palette();
  static constexpr Palette shading_gamma = shading_gamma_palette();
  static constexpr Palette ramps = ramps_palette();
  switch (kind) {
    case PaletteKind::shading:
      return shading;
    case PaletteKind::shading_gamma:
      return shading_gamma;
    case PaletteKind::ramps:
      return ramps;
    default:
      return vga;
  }
}

/// The index of a colour in both shading palettes: a colour with a single nonzero component has
/// that primary's level, any other the highest two bits of each component. Black is 0.
constexpr std::uint8_t index_of(const Color& color) {
  const auto pure = [](unsigned start, std::uint8_t component) {
    return static_cast<std::uint8_t>(start + (component >> 2U));
  };
  const int components =
      (color.red != 0 ? 1 : 0) + (color.green != 0 ? 1 : 0) + (color.blue != 0 ? 1 : 0);
  if (components == 1) {
    if (color.red != 0) return pure(64, color.red);
    if (color.green != 0) return pure(128, color.green);
    return pure(192, color.blue);
  }
  const auto highest_two = [](std::uint8_t component) { return component >> 6U; };
  return static_cast<std::uint8_t>(highest_two(color.red) << 4U | highest_two(color.green) << 2U |
                                   highest_two(color.blue));
}

/// The index with the smallest sum of squared component differences; the lowest index on a tie.
constexpr std::uint8_t nearest(const Palette& palette, const Color& color) {
  const auto distance = [&color](const Color& other) {
    const int red = other.red - color.red;
    const int green = other.green - color.green;
    const int blue = other.blue - color.blue;
    return red * red + green * green + blue * blue;
  };
  const auto* const found =
      std::min_element(palette.begin(), palette.end(),
                       [&](const Color& a, const Color& b) { return distance(a) < distance(b); });
  return static_cast<std::uint8_t>(found - palette.begin());
}

/// The palette index of a paint: its own, or that of its colour.
inline std::uint8_t index_of(const Paint& paint, PaletteKind kind) {
  if (paint.is_index) return paint.index;
  const bool shades = kind == PaletteKind::shading || kind == PaletteKind::shading_gamma;
  return shades ? index_of(paint.color) : nearest(palette_of(kind), paint.color);
}

/// As a pixel, 0x00RRGGBB.
constexpr std::uint32_t rgb(const Color& color) {
  return std::uint32_t{color.red} << 16U | std::uint32_t{color.green} << 8U | color.blue;
}

/// The pixel of this type for a paint. In true colour, an index becomes its palette colour.
template <PixelType Pixel>
Pixel pixel_of(const Paint& paint, PaletteKind kind) {
  if constexpr (std::same_as<Pixel, std::uint8_t>) {
    return index_of(paint, kind);
  } else {
    return rgb(paint.is_index ? palette_of(kind).at(paint.index) : paint.color);
  }
}

}  // namespace xsharp

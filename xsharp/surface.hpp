/// @file
/// What fills the faces of an object, beside one paint each: values stepped from pixel to pixel.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace xsharp {

enum class SurfaceKind {
  flat,         ///< every face has its paint
  gouraud8,     ///< light at the vertices, stepped in 8.8
  gouraud16,    ///< the same in 16.16
  depth,        ///< depth shown as light: Z-Gouraud; in 8.8
  distance,     ///< distance from the viewer shown as light; in 8.8
  texture,      ///< a bitmap on every face
  environment,  ///< a bitmap round about, seen in the body: its places are those of normals
  phong,        ///< normals at the vertices, light at the pixels
};
inline constexpr std::array<std::string_view, 8> surface_words{
    "flat", "gouraud8", "gouraud16", "depth", "distance", "texture", "environment", "phong"};

/// At which pixels of a span Phong's light is worked out: the normal between those of the ends,
/// brought to unit length, times the light.
enum class PhongForm {
  exact,      ///< at every one
  fourth,     ///< at every fourth and the last, with linear steps between
  quadratic,  ///< at the first, the middle and the last; a parabola through them, by two additions
};
inline constexpr std::array<std::string_view, 3> phong_words{"exact", "fourth", "quadratic"};

/// Values of Surface::exact_every: pixels from one exact place in the bitmap to the next, with
/// linear steps between; 0: none but the vertices (linear distortion).
inline constexpr std::array<std::int32_t, 4> exact_choices{1, 8, 16, 0};
inline constexpr std::array<std::string_view, 4> exact_words{"1", "8", "16", "never"};

/// How pixels hide one another.
enum class DepthBuffering {
  off,       ///< not at all: what is drawn later covers what was there
  on,        ///< by a buffer of 16 bits: greater is nearer, cleared before every picture
  reversed,  ///< the axis the other way: less is nearer
  no_clear,  ///< cleared before every seventh picture; two bits less of depth
};
inline constexpr std::array<std::string_view, 4> depth_buffer_words{"off", "on", "reversed",
                                                                    "no-clear"};

/// What a depth buffer compares.
enum class DepthMeasure {
  inverse,  ///< nearest_depth * near / -z, which is linear on the screen (ours)
  z,        ///< z itself, above the farthest z of 16.16: what the depth loop's text steps
};
inline constexpr std::array<std::string_view, 2> depth_measure_words{"inverse", "z"};

/// A bitmap is computed: 256 by 256 texels of two indices of the palette.
enum class Pattern {
  checker,  ///< squares of 32
  bricks,   ///< bricks of 64 by 32 with joints of 4, each row half a brick further
};
inline constexpr std::array<std::string_view, 2> pattern_words{"checker", "bricks"};

struct Surface {
  SurfaceKind kind = SurfaceKind::flat;
  /// Which ramp of the palette shows light, 0 or 1.
  std::int32_t ramp = 0;
  PhongForm phong = PhongForm::quadratic;
  std::int32_t exact_every = 16;
  Pattern pattern = Pattern::checker;
  /// Of the pattern: squares, or bricks and joints.
  std::array<std::uint8_t, 2> texels{127, 255};
};

constexpr bool is_lit(const Surface& surface) {
  return surface.kind == SurfaceKind::gouraud8 || surface.kind == SurfaceKind::gouraud16 ||
         surface.kind == SurfaceKind::phong;
}

/// Whether what is drawn is a place on a ramp of the palette.
constexpr bool is_on_ramp(const Surface& surface) {
  return is_lit(surface) || surface.kind == SurfaceKind::depth ||
         surface.kind == SurfaceKind::distance;
}

/// Whether its vertices need normals.
constexpr bool needs_normals(const Surface& surface) {
  return is_lit(surface) || surface.kind == SurfaceKind::environment;
}

constexpr bool has_bitmap(const Surface& surface) {
  return surface.kind == SurfaceKind::texture || surface.kind == SurfaceKind::environment;
}

/// Whether places in the bitmap are worked out from place times depth.
constexpr bool in_perspective(const Surface& surface) {
  return surface.kind == SurfaceKind::texture && surface.exact_every != 0;
}

/// Light from -1 to 1 as an index of the palette: `dark` + `levels` * light on the first ramp. Two
/// levels at each end of a ramp are never meant: what stepping errs by stays in the ramp.
inline constexpr std::int32_t ramp_length = 128;
inline constexpr std::int32_t ramp_dark = 64;
inline constexpr std::int32_t ramp_levels = 62;

/// The greatest depth, of what is as near as Scene::near or nearer.
inline constexpr std::int32_t nearest_depth = 32767;

}  // namespace xsharp

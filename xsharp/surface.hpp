/// @file
/// The surface of an object: what its faces show besides their paint, interpolated from pixel to
/// pixel.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace xsharp {

enum class SurfaceKind {
  flat,         ///< every face has its paint
  gouraud8,     ///< light at the vertices, stepped in 8.8
  gouraud16,    ///< light at the vertices, stepped in 16.16
  depth,        ///< depth shown as light (Z-Gouraud), in 8.8
  distance,     ///< distance from the viewer shown as light, in 8.8
  texture,      ///< a bitmap on every face
  environment,  ///< a reflected bitmap: normals determine the texels
  phong,        ///< normals at the vertices, light per pixel
};
inline constexpr std::array<std::string_view, 8> surface_words{
    "flat", "gouraud8", "gouraud16", "depth", "distance", "texture", "environment", "phong"};

/// The pixels of a span whose Phong light is computed: it interpolates the normals of the ends,
/// normalises, and multiplies by the light.
enum class PhongForm {
  exact,      ///< all
  fourth,     ///< every fourth and the last, with linear steps between
  quadratic,  ///< the first, the middle and the last; a parabola through them, by two additions
};
inline constexpr std::array<std::string_view, 3> phong_words{"exact", "fourth", "quadratic"};

/// Values of Surface::exact_every: the distance in pixels between exact bitmap coordinates, with
/// linear steps between; 0: exact only at the vertices (linear distortion).
inline constexpr std::array<std::int32_t, 4> exact_choices{1, 8, 16, 0};
inline constexpr std::array<std::string_view, 4> exact_words{"1", "8", "16", "never"};

/// How nearer pixels hide farther ones.
enum class DepthBuffering {
  off,       ///< no depth buffer: later drawing covers earlier
  on,        ///< a 16-bit buffer: greater is nearer; cleared before every picture
  reversed,  ///< the reversed axis: less is nearer
  no_clear,  ///< cleared before every seventh picture; two bits less of depth
};
inline constexpr std::array<std::string_view, 4> depth_buffer_words{"off", "on", "reversed",
                                                                    "no-clear"};

/// The value that a depth buffer compares.
enum class DepthMeasure {
  inverse,  ///< nearest_depth * near / -z, which is linear on the screen (ours)
  z,        ///< z itself, above the farthest z of 16.16, as the depth loop's text steps it
};
inline constexpr std::array<std::string_view, 2> depth_measure_words{"inverse", "z"};

/// Computed bitmaps: 256 by 256 texels of two palette indices.
enum class Pattern {
  checker,  ///< squares of 32
  bricks,   ///< bricks of 64 by 32 with joints of 4, each row offset by half a brick
};
inline constexpr std::array<std::string_view, 2> pattern_words{"checker", "bricks"};

struct Surface {
  SurfaceKind kind = SurfaceKind::flat;
  /// The palette ramp that shows light, 0 or 1.
  std::int32_t ramp = 0;
  PhongForm phong = PhongForm::quadratic;
  std::int32_t exact_every = 16;
  Pattern pattern = Pattern::checker;
  /// The two texels of the pattern: squares, or bricks and joints.
  std::array<std::uint8_t, 2> texels{127, 255};
};

constexpr bool is_lit(const Surface& surface) {
  return surface.kind == SurfaceKind::gouraud8 || surface.kind == SurfaceKind::gouraud16 ||
         surface.kind == SurfaceKind::phong;
}

/// Whether pixels are positions on a palette ramp.
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

/// Whether bitmap coordinates are interpolated as coordinate times depth.
constexpr bool in_perspective(const Surface& surface) {
  return surface.kind == SurfaceKind::texture && surface.exact_every != 0;
}

/// Maps light from -1 to 1 to a palette index: `dark` + `levels` * light on the first ramp. Two
/// levels at each end of a ramp are spare, so that stepping errors stay in the ramp.
inline constexpr std::int32_t ramp_length = 128;
inline constexpr std::int32_t ramp_dark = 64;
inline constexpr std::int32_t ramp_levels = 62;

/// The greatest depth, at a distance of Scene::near or less.
inline constexpr std::int32_t nearest_depth = 32767;

}  // namespace xsharp

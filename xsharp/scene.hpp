/// @file
/// What is to be seen: plain data, independent of the arithmetic that draws it.
///
/// Units of space are those of the scene. Angles are tenths of a degree. The viewer stands at the
/// origin of view space and looks down -z, y is up.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "xsharp/mesh.hpp"
#include "xsharp/picture.hpp"
#include "xsharp/surface.hpp"

namespace xsharp {

/// How a constant that is computed in double becomes 16.16.
enum class Conversion {
  published,  ///< (long)(x * 65536.0 + 0.5): one unit too high for nearly every negative value
  nearest,    ///< the nearest 16.16 number, halves up
};

/// Which ConcatXforms of the 8088 takes objects into view space. Other arithmetics have only one.
enum class Concatenation {
  published,  ///< the listing, which loses the carry of the translation: see sum_in_parts()
  repaired,   ///< the listing with that carry
};

/// Where the sine and cosine of a rotation come from.
enum class Trigonometry {
  floating,  ///< sin() and cos() in double, through the scene's Conversion (chapter 52)
  table,     ///< CosSin (chapter 53)
};

/// What objects are sorted by, farthest first, before they are drawn.
enum class DepthKey {
  none,      ///< drawn in the order of the scene (chapter 52)
  center,    ///< view z of the centre (chapter 53)
  nearest,   ///< view z of the nearest vertex
  farthest,  ///< view z of the farthest vertex
};

enum class PaletteKind {
  vga,            ///< the 256 colours a VGA starts with
  shading,        ///< 64 levels of each pure primary, four of each component in mixtures
  ramps,          ///< two ramps by light from -1 to 1: grey and copper
  shading_gamma,  ///< as shading, with the author's levels of mixtures: by a gamma of 2.3
};

/// How orthogonality is restored; see rotation.hpp.
enum class RestoredRows {
  all,  ///< two cross products, and every row brought to unit length
  one,  ///< one row becomes the cross product of the others, nothing else (chapter 52)
};
inline constexpr std::array<std::string_view, 2> restored_rows_words{"all", "one"};

/// Counts frames down: due when the count reaches 0, then again after every `base` frames.
struct Delay {
  std::int32_t first = 1;
  std::int32_t base = 1;
};

/// Turns about axes through the object's origin that are parallel to those of the world: a rotation
/// is multiplied from the left. Those that are not 0 are appended about x, then y, then z.
struct Spin {
  std::array<std::int32_t, 3> tenths{};
  Delay delay{};
};

/// The range of z in which an object moves.
struct Bounds {
  double least = 0;
  double most = 0;
};

/// Adds `step` to the place. Once z is beyond `stop_z`, the object moves in z no more (chapter 52).
/// After a move to a z outside of `bounce_z`, the step in z changes its sign (chapter 53).
struct Drift {
  Triple step{};
  std::optional<double> stop_z{};
  std::optional<Bounds> bounce_z{};
  Delay delay{};
};

/// Goes round `about` on a circle that is tilted about the x axis; such an object does not drift.
struct Orbit {
  Triple about{};
  double radius = 0;
  std::int32_t start_tenths = 0;
  std::int32_t step_tenths = 0;
  std::int32_t tilt_tenths = 0;
};

/// Which light a face answers to; with neither it has its paint as it is.
struct Shading {
  bool ambient = false;
  bool diffuse = false;
};

struct ObjectDescription {
  std::string name;  ///< for messages
  Mesh mesh;
  std::vector<Paint> paints;        ///< one for each face; a Color is its reflectance, 255 for 1
  std::vector<Shading> shadings{};  ///< one for each face, or empty: no face answers to light
  Surface surface{};
  /// The world in pages of 16384 units: the place is page * 16384 + position.
  std::array<std::int32_t, 3> page{};
  Triple position{};
  Spin spin{};
  std::optional<Drift> drift{};
  std::optional<Orbit> orbit{};
};

/// Light of each colour; 1 shows a face of reflectance 1 as bright as can be.
using Intensity = Triple;

struct Spot {
  bool on = true;
  Triple direction{0, 0, -1};  ///< where the light goes, in world space; only its direction counts
  Intensity intensity{};
};

struct Lights {
  bool ambient_on = true;
  Intensity ambient{};
  std::vector<Spot> spots{};
};

struct Camera {
  std::array<std::int32_t, 3> page{};
  Triple position{};
  std::array<std::int32_t, 3> turn_tenths{};  ///< about x, then y, then z
};

/// The arithmetic a scene is drawn with when the command does not say.
struct ArithmeticChoice {
  std::string by = "type";  ///< type, model or double
  /// i386 or i8088; for the type also standard, saturating or trapping; double has none.
  std::string target = "i386";
  bool mul_round = true;
  bool div_round = true;
  bool repaired = false;  ///< i8088 alone: see Concatenation
};

inline Concatenation concatenation_of(const ArithmeticChoice& choice) {
  return choice.repaired ? Concatenation::repaired : Concatenation::published;
}

/// Whether the rules are those of a build of the listings, with two roundings to choose.
inline bool is_listing(const ArithmeticChoice& choice) {
  return choice.target == "i386" || choice.target == "i8088";
}

/// Whether the arithmetic has a repaired ConcatXforms: only that of the 8088 loses a carry.
inline bool can_be_repaired(const ArithmeticChoice& choice) {
  return choice.by != "double" && choice.target == "i8088";
}

struct Scene {
  std::string name;
  std::int32_t width = 320;
  std::int32_t height = 240;
  double frames_per_second = 60;
  /// Distance of the projection plane over half its width, negative: visible z is.
  double projection_ratio = -2.0;
  Conversion conversion = Conversion::published;
  Trigonometry trigonometry = Trigonometry::table;
  DepthKey depth_key = DepthKey::center;
  PaletteKind palette = PaletteKind::vga;
  std::uint8_t background = 0;
  ArithmeticChoice arithmetic{};
  DepthBuffering depth_buffer = DepthBuffering::off;
  DepthMeasure depth_measure = DepthMeasure::inverse;
  /// What is nearer has no more depth; see nearest_depth.
  double near = 64;
  /// Orientations are worked out anew in double for every rotation, instead of appending to the
  /// last.
  bool from_scratch = false;
  /// Orthogonality is restored every so many rotations of an object; 0: never.
  std::int32_t restore_every = 0;
  RestoredRows restore_rows = RestoredRows::all;
  Camera camera{};
  Lights lights{};
  std::vector<ObjectDescription> objects;
  std::vector<std::filesystem::path> files{};  ///< it was read from
};

/// What x over z is multiplied with, and y over z: pixels of a page whose half width is, as
/// published, a whole number.
inline double projection_constant(const Scene& scene) {
  const std::int32_t half_width = scene.width / 2;
  return scene.projection_ratio * half_width;
}

/// How much of a ramp a spot lights: the mean of its components.
inline double level_of(const Spot& spot) {
  return (spot.intensity[0] + spot.intensity[1] + spot.intensity[2]) / 3;
}

/// Whether polygons have values at their points.
inline bool interpolates(const Scene& scene) {
  if (scene.depth_buffer != DepthBuffering::off) return true;
  for (const ObjectDescription& object : scene.objects) {
    if (object.surface.kind != SurfaceKind::flat) return true;
  }
  return false;
}

}  // namespace xsharp

/// @file
/// A scene as plain data, independent of the arithmetic that draws it.
///
/// Lengths are in units of the scene, angles in tenths of a degree. The viewer is at the origin of
/// view space and looks down -z; y is up.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "xsharp/mesh.hpp"
#include "xsharp/picture.hpp"
#include "xsharp/surface.hpp"

namespace xsharp {

/// How a constant computed in double becomes 16.16.
enum class Conversion {
  published,  ///< (long)(x * 65536.0 + 0.5): one unit too high for nearly every negative value
  nearest,    ///< to nearest, half up
};

/// The ConcatXforms of the 8088 that transforms objects into view space. Other arithmetics have
/// only one.
enum class Concatenation {
  published,  ///< as listed, without the carry of the translation: see sum_in_parts()
  repaired,   ///< with that carry
};

/// The source of a rotation's sine and cosine.
enum class Trigonometry {
  floating,  ///< sin() and cos() in double, through the scene's Conversion (chapter 52)
  table,     ///< CosSin (chapter 53)
};

/// The sort key of objects, which are drawn farthest first.
enum class DepthKey {
  none,      ///< drawn in the order of the scene (chapter 52)
  center,    ///< view z of the centre (chapter 53)
  nearest,   ///< view z of the nearest vertex
  farthest,  ///< view z of the farthest vertex
};

enum class PaletteKind {
  vga,            ///< the 256 default colours of a VGA
  shading,        ///< 64 levels of each primary, and mixtures with four levels per component
  ramps,          ///< two ramps for light from -1 to 1: grey and copper
  shading_gamma,  ///< as shading, with the author's levels for mixtures: a gamma of 2.3
};

/// How orthogonality is restored; see rotation.hpp.
enum class RestoredRows {
  all,  ///< two cross products, and every row normalised
  one,  ///< only one row, as the cross product of the others (chapter 52)
};
inline constexpr std::array<std::string_view, 2> restored_rows_words{"all", "one"};

/// A countdown in frames: due when the count reaches 0, then again after every `base` frames.
struct Delay {
  std::int32_t first = 1;
  std::int32_t base = 1;
};

/// The size of a page of the world; see ObjectDescription::page.
inline constexpr std::int32_t page_size = 16384;

/// Rotation about axes through the object's origin, parallel to the world's axes: rotations are
/// multiplied from the left. Nonzero angles are appended about x, then y, then z.
struct Spin {
  std::array<std::int32_t, 3> tenths{};
  Delay delay{};
};

/// The range of z in which an object moves.
struct Bounds {
  double least = 0;
  double most = 0;
};

/// Adds `step` to the position. Once z is beyond `stop_z`, z no longer changes (chapter 52). After
/// a move to a z outside `bounce_z`, the z step changes its sign (chapter 53).
struct Drift {
  Triple step{};
  std::optional<double> stop_z{};
  std::optional<Bounds> bounce_z{};
  Delay delay{};
};

/// Moves around `about` on a circle tilted about the x axis; excludes a drift.
struct Orbit {
  Triple about{};
  double radius = 0;
  std::int32_t start_tenths = 0;
  std::int32_t step_tenths = 0;
  std::int32_t tilt_tenths = 0;
};

/// The mirror image of a light on a face: the light's intensity * strength * cosine^exponent. The
/// cosine is that of the angle between the normal and the vector halfway between light and viewer.
struct Highlight {
  double exponent = 1;  ///< a greater one makes a smaller highlight
  double strength = 0;
};

/// The lights that affect a face; with none, the paint is used as it is.
struct Shading {
  bool ambient = false;
  bool diffuse = false;
  std::optional<Highlight> highlight{};
};

constexpr bool is_lit(const Shading& shading) {
  return shading.ambient || shading.diffuse || shading.highlight;
}

/// Whether faces with this shading need normals.
constexpr bool needs_normals(const Shading& shading) {
  return shading.diffuse || shading.highlight;
}

struct ObjectDescription {
  std::string name;  ///< for messages
  Mesh mesh;
  std::vector<Paint> paints;        ///< one per face; a Color is the reflectance, 255 for 1
  std::vector<Shading> shadings{};  ///< one per face, or empty if no face is lit
  Surface surface{};
  /// The world consists of pages: the place is page * page_size + position.
  std::array<std::int32_t, 3> page{};
  Triple position{};
  Spin spin{};
  std::optional<Drift> drift{};
  std::optional<Orbit> orbit{};
  /// The point, relative to the page where the object begins, at which its -z axis points. Excludes
  /// a spin.
  std::optional<Triple> look_at{};
};

/// Light per colour; 1 gives a face of reflectance 1 full brightness.
using Intensity = Triple;

struct Spot {
  bool on = true;
  Triple direction{0, 0, -1};  ///< direction of travel of the light, in world space; of any length
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
  /// The point on the same page that is in the middle of the picture. Excludes a turn.
  std::optional<Triple> look_at{};
};

/// The arithmetic for drawing a scene, if the command does not choose one.
struct ArithmeticChoice {
  std::string by = "type";  ///< type, model or double
  /// i386 or i8088; for the type also standard, saturating or trapping; unused for double.
  std::string target = "i386";
  bool mul_round = true;
  bool div_round = true;
  bool repaired = false;  ///< only for i8088; see Concatenation
};

inline Concatenation concatenation_of(const ArithmeticChoice& choice) {
  return choice.repaired ? Concatenation::repaired : Concatenation::published;
}

/// Whether the target is a build of the listings, which has two rounding switches.
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
  /// The distance of the projection plane over half its width; negative, because visible z is.
  double projection_ratio = -2.0;
  Conversion conversion = Conversion::published;
  Trigonometry trigonometry = Trigonometry::table;
  DepthKey depth_key = DepthKey::center;
  PaletteKind palette = PaletteKind::vga;
  std::uint8_t background = 0;
  ArithmeticChoice arithmetic{};
  DepthBuffering depth_buffer = DepthBuffering::off;
  DepthMeasure depth_measure = DepthMeasure::inverse;
  /// Anything nearer has the same depth; see nearest_depth.
  double near = 64;
  /// Whether every rotation recomputes the orientation in double instead of appending to the last.
  bool from_scratch = false;
  /// Rotations of an object between restorations of orthogonality; 0 for never.
  std::int32_t restore_every = 0;
  RestoredRows restore_rows = RestoredRows::all;
  Camera camera{};
  Lights lights{};
  std::vector<ObjectDescription> objects;
  std::vector<std::string> files{};  ///< the files it was read from
};

/// The factor of x / z and y / z, in pixels. As published, half the width of the page is a whole
/// number.
inline double projection_constant(const Scene& scene) {
  const std::int32_t half_width = scene.width / 2;
  return scene.projection_ratio * half_width;
}

/// The light of a spot on a ramp: the mean of its components.
inline double level_of(const Spot& spot) {
  return (spot.intensity[0] + spot.intensity[1] + spot.intensity[2]) / 3;
}

/// Whether polygons have values at their points.
inline bool interpolates(const Scene& scene) {
  if (scene.depth_buffer != DepthBuffering::off) return true;
  return std::any_of(
      scene.objects.begin(), scene.objects.end(),
      [](const ObjectDescription& object) { return object.surface.kind != SurfaceKind::flat; });
}

}  // namespace xsharp

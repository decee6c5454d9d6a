/// @file
/// Checks a scene against the limits of 16.16 numbers and of the pipeline.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>

#include "xsharp/scene.hpp"
#include "xsharp/scene_error.hpp"
#include "xsharp/text_of.hpp"
#include "xsharp/validate_mesh.hpp"

namespace xsharp {

inline constexpr std::size_t max_objects = 65536;
inline constexpr std::size_t max_faces_in_scene = 524288;
/// More than those of max_objects cubes whose faces all have normals.
inline constexpr std::size_t max_vertices_in_scene = 2097152;
inline constexpr std::size_t max_spots = 16;
inline constexpr std::int32_t longest_side = 4096;
/// The projection uses half the width, a whole number.
inline constexpr std::int32_t narrowest = 2;
/// The limit of each component of a position in its page: with half a page of body, it stays in
/// 16.16.
inline constexpr double max_position = 16384;
inline constexpr std::int32_t max_page = 1000000;
inline constexpr double max_exponent = 1000;

namespace detail {

/// Throws unless the value is in range. Written so that NaN is always out of range.
template <class Number>
void require_range(const std::string& what, Number value, Number least, Number most) {
  if (value >= least && value <= most) return;
  // A number just out of range must not print as the end of the range.
  std::string is = text_of(value);
  if constexpr (std::is_same_v<Number, double>) is = digits_of(value);
  throw SceneError(text_of(what, " is ", is, ", must be from ", least, " to ", most));
}

inline void require_range(const std::string& what, const Triple& values, double least,
                          double most) {
  for (const double value : values) require_range(what, value, least, most);
}

/// Angles are arguments of CosSin, which takes 16 bits.
inline void require_angle(const std::string& what, std::int32_t tenths) {
  require_range<std::int32_t>(what, tenths, INT16_MIN, INT16_MAX);
}

inline void require_place(const std::array<std::int32_t, 3>& page, const Triple& position) {
  for (const std::int32_t component : page) {
    require_range("page", component, -max_page, max_page);
  }
  require_range("position", position, -max_position, max_position);
}

inline void require_delay(const std::string& what, const Delay& delay) {
  require_range(what + ".delay, first", delay.first, 1, INT32_MAX);
  require_range(what + ".delay, base", delay.base, 1, INT32_MAX);
}

inline void require_word(const std::string& what, const std::string& value,
                         std::initializer_list<std::string_view> words) {
  if (std::ranges::find(words, value) != words.end()) return;
  std::string known;
  for (const auto word : words) known.append(known.empty() ? "" : ", ").append(word);
  throw SceneError(text_of(what, " is \"", value, "\", must be one of ", known));
}

inline void validate_orbit(const Orbit& orbit) {
  require_range("orbit.radius", orbit.radius, 0.0, max_position);
  // The whole circle must be in the range of positions.
  const double most = max_position - orbit.radius;
  require_range("orbit.about, with this radius,", orbit.about, -most, most);
  require_angle("orbit.start_tenths", orbit.start_tenths);
  require_angle("orbit.step_tenths", orbit.step_tenths);
  require_angle("orbit.tilt_tenths", orbit.tilt_tenths);
}

inline void validate_highlight(std::size_t face, const Highlight& highlight, const Face& of) {
  if (!of.normal_end) throw SceneError(text_of("face ", face, " has a highlight, but no normal"));
  const std::string name = text_of("face ", face, ": highlight.");
  require_range(name + "exponent", highlight.exponent, 1.0, max_exponent);
  require_range(name + "strength", highlight.strength, 0.0, 1.0);
}

inline void validate_paints(const ObjectDescription& object) {
  const auto& faces = object.mesh.faces;
  if (object.paints.size() != faces.size()) {
    throw SceneError(text_of(object.paints.size(), " paints for ", faces.size(), " faces"));
  }
  if (object.shadings.empty()) return;
  if (object.shadings.size() != faces.size()) {
    throw SceneError(text_of(object.shadings.size(), " shadings for ", faces.size(), " faces"));
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Shading& shading = object.shadings[i];
    if (is_lit(shading) && object.paints[i].is_index) {
      throw SceneError(text_of("face ", i, " answers to light, so its paint must be a colour"));
    }
    if (shading.diffuse && !faces[i].normal_end) {
      throw SceneError(text_of("face ", i, " answers to diffuse light, but has no normal"));
    }
    if (shading.highlight) validate_highlight(i, *shading.highlight, faces[i]);
  }
}

inline void validate_surface(const ObjectDescription& object) {
  const Surface& surface = object.surface;
  require_range("surface.ramp", surface.ramp, 0, 1);
  if (std::ranges::find(exact_choices, surface.exact_every) == exact_choices.end()) {
    throw SceneError(text_of("surface.exact_every is ", surface.exact_every,
                             ", must be 1, 8, 16 or 0 for never"));
  }
  if (!needs_normals(surface)) return;
  const auto& ends = object.mesh.vertex_normal_ends;
  const std::size_t vertices = object.mesh.vertices.size();
  if (ends.empty()) throw SceneError("surface.kind needs normals at the vertices");
  for (const std::size_t end : ends) {
    if (end >= vertices)
      throw SceneError(text_of("a normal ends at vertex ", end, " of ", vertices));
  }
}

/// Bitmap coordinates times depth are linear on the screen only if depth is the inverse of z.
inline void validate_depth_measure(const Scene& scene) {
  if (scene.depth_measure != DepthMeasure::z) return;
  for (const ObjectDescription& object : scene.objects) {
    if (object.surface.kind == SurfaceKind::texture) {
      throw SceneError(text_of("object '", object.name,
                               R"(': a texture needs depth_measure "inverse", not "z")"));
    }
  }
}

/// A ramp shows light from -1 to 1; only one palette has ramps.
inline void validate_ramp_light(const Scene& scene) {
  double level = 0;
  for (const Spot& spot : scene.lights.spots) level += level_of(spot);
  for (const ObjectDescription& object : scene.objects) {
    if (is_on_ramp(object.surface) && scene.palette != PaletteKind::ramps) {
      throw SceneError(text_of("object '", object.name, "': surface.kind is \"",
                               surface_words.at(static_cast<std::size_t>(object.surface.kind)),
                               R"(", so palette must be "ramps")"));
    }
    if (is_lit(object.surface) && level > 1.0001) {
      throw SceneError(text_of("the spots' intensities, each the mean of three, add up to ", level,
                               "; a surface that shows light by a ramp has 1 at most"));
    }
  }
}

inline void validate_lights(const Lights& lights) {
  require_range("lights.ambient", lights.ambient, 0, 100);
  if (lights.spots.size() > max_spots) {
    throw SceneError(text_of(lights.spots.size(), " spots, more than ", max_spots));
  }
  for (std::size_t i = 0; i < lights.spots.size(); ++i) {
    const std::string name = text_of("spot ", i);
    require_range(name + ": direction", lights.spots[i].direction, -32768, 32768);
    // Four units of 16.16: one component is at least 2, which no conversion rounds to 0.
    require_range(name + ": length of direction", length(lights.spots[i].direction),
                  std::ldexp(1, -14), 65536.0);
    require_range(name + ": intensity", lights.spots[i].intensity, 0, 100);
  }
}

inline void validate_look_at(const Camera& camera) {
  if (camera.turn_tenths != std::array<std::int32_t, 3>{}) {
    throw SceneError("must not have both turn_tenths and look_at");
  }
  require_range("look_at", *camera.look_at, -max_position, max_position);
  // Nearer, the direction would be a few units of 2^-16.
  if (length(difference(*camera.look_at, camera.position)) < std::ldexp(1, -14)) {
    throw SceneError("look_at must be at least 2^-14 away from position");
  }
}

/// Checks the scene without its objects.
inline void validate_setting(const Scene& scene) {
  require_range("width", scene.width, narrowest, longest_side);
  require_range("height", scene.height, 1, longest_side);
  require_range("frames_per_second", scene.frames_per_second, 0.001, 1000.0);
  require_range("projection_ratio", scene.projection_ratio, -1000.0, -0.01);
  // Beyond this the screen coordinates at the sides of a wide page approach the ends of 16.16.
  require_range("projection_ratio * (width / 2)", projection_constant(scene), -16000.0, -0.01);
  require_range("restore_every", scene.restore_every, 0, INT32_MAX);
  require_word("arithmetic.by", scene.arithmetic.by, {"type", "model", "double"});
  if (scene.from_scratch && scene.restore_every > 0) {
    throw SceneError("from_scratch leaves restore_every nothing to restore");
  }
  require_word("arithmetic.target", scene.arithmetic.target,
               {"i386", "i8088", "standard", "saturating", "trapping"});
  if (scene.arithmetic.by == "model" && !is_listing(scene.arithmetic)) {
    throw SceneError(R"(arithmetic.by is "model", which has no target ")" +
                     scene.arithmetic.target + "\"");
  }
  try {
    require_place(scene.camera.page, scene.camera.position);
    for (const std::int32_t tenths : scene.camera.turn_tenths) require_angle("turn_tenths", tenths);
    if (scene.camera.look_at) validate_look_at(scene.camera);
  } catch (const SceneError& error) {
    throw SceneError(text_of("camera: ", error.what()));
  }
  validate_lights(scene.lights);
  require_range("near", scene.near, 1.0, max_position);
}

}  // namespace detail

/// @throws SceneError with the reason, without the object's name
inline void validate_object(const ObjectDescription& object) {
  validate_mesh(object.mesh);
  detail::validate_paints(object);
  detail::validate_surface(object);
  detail::require_place(object.page, object.position);
  for (const std::int32_t tenths : object.spin.tenths) detail::require_angle("spin.tenths", tenths);
  detail::require_delay("spin", object.spin.delay);
  if (object.drift) {
    detail::require_range("drift.step", object.drift->step, -max_position, max_position);
    // Compared with the whole position, pages included.
    const double most = max_page * max_position;
    if (object.drift->stop_z) {
      detail::require_range("drift.stop_z", *object.drift->stop_z, -most, most);
    }
    if (const auto& bounce = object.drift->bounce_z) {
      if (object.drift->stop_z) {
        throw SceneError("drift must not have both stop_z and bounce_z");
      }
      detail::require_range("drift.bounce_z, least", bounce->least, -most, most);
      detail::require_range("drift.bounce_z, most", bounce->most, bounce->least, most);
    }
    detail::require_delay("drift", object.drift->delay);
  }
  if (object.orbit) detail::validate_orbit(*object.orbit);
  if (object.look_at) {
    if (object.spin.tenths != std::array<std::int32_t, 3>{}) {
      throw SceneError("must not have both spin and look_at");
    }
    detail::require_range("look_at", *object.look_at, -max_position, max_position);
  }
}

/// Checks that every arithmetic can draw the scene without overflowing 16.16 unnoticed, as far as
/// this can be known before it moves.
/// @throws SceneError with the scene, the object and the reason
inline void validate(const Scene& scene) {
  std::string place = "scene '" + scene.name + "': ";
  try {
    detail::validate_setting(scene);
    if (scene.objects.size() > max_objects) {
      throw SceneError(detail::text_of(scene.objects.size(), " objects, more than ", max_objects));
    }
    std::size_t faces = 0;
    std::size_t vertices = 0;
    for (const ObjectDescription& object : scene.objects) {
      faces += object.mesh.faces.size();
      vertices += object.mesh.vertices.size();
    }
    if (faces > max_faces_in_scene) {
      throw SceneError(detail::text_of(faces, " faces, more than ", max_faces_in_scene));
    }
    if (vertices > max_vertices_in_scene) {
      throw SceneError(detail::text_of(vertices, " vertices, more than ", max_vertices_in_scene));
    }
    for (const ObjectDescription& object : scene.objects) {
      place = "scene '" + scene.name + "': object '" + object.name + "': ";
      validate_object(object);
    }
    place = "scene '" + scene.name + "': ";
    detail::validate_ramp_light(scene);
    detail::validate_depth_measure(scene);
  } catch (const SceneError& error) {
    throw SceneError(place + error.what());
  }
}

}  // namespace xsharp

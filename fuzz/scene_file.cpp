// Target `scene_file`: the input as the JSON of a scene. It must raise a SceneError or give a scene
// that keeps every limit and whose frames can be drawn.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>

#include "fixed/fixed.hpp"
#include "fuzz/finding.hpp"
#include "xsharp/animation.hpp"
#include "xsharp/files/scene_json.hpp"
#include "xsharp/validate.hpp"

namespace {

/// Draws only frames up to these limits, to stay fast.
constexpr std::size_t max_faces_drawn = 200;
constexpr std::int32_t max_side_drawn = 400;

std::size_t faces_of(const xsharp::Scene& scene) {
  std::size_t faces = 0;
  for (const auto& object : scene.objects) faces += object.mesh.faces.size();
  return faces;
}

std::optional<xsharp::Scene> scene_of(const std::string& text) {
  try {
    return xsharp::parse_scene(text, "fuzz", FIXPROOF_SCENES);
  } catch (const xsharp::SceneError&) {
    // A SceneError is allowed.
  } catch (const std::exception& error) {
    fixproof::fuzz::report_finding(fmt::format("not a SceneError: {}", error.what()));
  }
  return std::nullopt;
}

void draw(const xsharp::Scene& scene) {
  xsharp::Animation<fixproof::q16_16> animation(scene);
  for (int frame = 0; frame < 2; ++frame) {
    xsharp::Picture picture;
    animation.draw(picture);
    animation.move();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto scene = scene_of(std::string(data, data + size));
  if (!scene) return 0;
  try {
    xsharp::validate(*scene);
    if (faces_of(*scene) <= max_faces_drawn && scene->width <= max_side_drawn &&
        scene->height <= max_side_drawn) {
      draw(*scene);
    }
  } catch (const std::exception& error) {
    fixproof::fuzz::report_finding(fmt::format("accepted, then refused: {}", error.what()));
  }
  return 0;
}

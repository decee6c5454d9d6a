#include "app/cli/surface_options.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/cli/arguments.hpp"
#include "support/usage_error.hpp"
#include "xsharp/normals.hpp"
#include "xsharp/validate.hpp"

namespace fixproof::cli {

namespace {

using xsharp::SurfaceKind;

template <class Set>
void add_word(CLI::App& command, const char* name, std::span<const std::string_view> words,
              const char* what, const Set& set) {
  const std::vector<std::string> known(words.begin(), words.end());
  command
      .add_option_function<std::string>(
          name,
          [known, set](const std::string& text) {
            set(static_cast<std::size_t>(std::ranges::find(known, text) - known.begin()));
          },
          what)
      ->check(one_of(known));
}

bool has_surface(const xsharp::Scene& scene, SurfaceKind kind) {
  return std::ranges::any_of(scene.objects,
                             [kind](const auto& object) { return object.surface.kind == kind; });
}

}  // namespace

void SurfaceOptions::add_to(CLI::App& command) {
  add_word(command, "--surface", xsharp::surface_words, "surface of every object",
           [this](std::size_t i) { kind = static_cast<SurfaceKind>(i); });
  add_word(command, "--phong", xsharp::phong_words, "pixels at which Phong's light is exact",
           [this](std::size_t i) { phong = static_cast<xsharp::PhongForm>(i); });
  add_word(command, "--texture-every", xsharp::exact_words,
           "pixels between two exact places in a texture",
           [this](std::size_t i) { exact_every = xsharp::exact_choices.at(i); });
  add_word(command, "--depth-buffer", xsharp::depth_buffer_words, "whether to use a depth buffer",
           [this](std::size_t i) { depth_buffer = static_cast<xsharp::DepthBuffering>(i); });
  add_word(command, "--depth-measure", xsharp::depth_measure_words,
           "depth that the buffer compares: near / -z, or z, as published",
           [this](std::size_t i) { depth_measure = static_cast<xsharp::DepthMeasure>(i); });
}

void SurfaceOptions::apply(xsharp::Scene& scene) const {
  if (!kind && !phong && !exact_every && !depth_buffer && !depth_measure) return;
  for (xsharp::ObjectDescription& object : scene.objects) {
    xsharp::Surface& surface = object.surface;
    if (kind) surface.kind = *kind;
    if (phong) surface.phong = *phong;
    if (exact_every) surface.exact_every = *exact_every;
    if (xsharp::needs_normals(surface) && object.mesh.vertex_normal_ends.empty()) {
      object.mesh = xsharp::with_vertex_normals(std::move(object.mesh));
    }
  }
  if (kind && *kind != SurfaceKind::flat) scene.palette = xsharp::PaletteKind::ramps;
  if (depth_buffer) scene.depth_buffer = *depth_buffer;
  if (depth_measure) scene.depth_measure = *depth_measure;
  if (phong && !has_surface(scene, SurfaceKind::phong)) {
    throw support::UsageError(
        "--phong: no object of the scene is Phong-shaded; add --surface phong");
  }
  if (exact_every && !has_surface(scene, SurfaceKind::texture)) {
    throw support::UsageError(
        "--texture-every: no object of the scene has a texture; add --surface texture");
  }
  if (depth_measure && scene.depth_buffer == xsharp::DepthBuffering::off) {
    throw support::UsageError(
        "--depth-measure: the scene has no depth buffer; add --depth-buffer on");
  }
  try {
    xsharp::validate(scene);
  } catch (const xsharp::SceneError& error) {
    throw support::UsageError(error.what());
  }
}

}  // namespace fixproof::cli

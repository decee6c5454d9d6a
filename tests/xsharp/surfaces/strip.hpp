/// @file
/// A rectangle whose values change from left to right, drawn by stepping and exactly.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "xsharp/animation.hpp"
#include "xsharp/raster/exact_filler.hpp"
#include "xsharp/raster/page.hpp"
#include "xsharp/raster/step_filler.hpp"

namespace surfaces {

using Indices = xsharp::Page<std::uint8_t>;
using Number = fixproof::q16_16_i386;

/// One ulp of 16.16.
inline constexpr double ulp = 1.0 / 65536;

inline xsharp::Scene scene_of(const xsharp::Surface& surface,
                              xsharp::DepthBuffering depth = xsharp::DepthBuffering::off) {
  xsharp::Scene scene;
  scene.palette = xsharp::PaletteKind::ramps;
  scene.objects.resize(1);
  scene.objects[0].surface = surface;
  scene.depth_buffer = depth;
  return scene;
}

/// A strip from x = 0 to `width`, two rows high.
inline xsharp::Picture strip(std::int32_t width, const xsharp::PointValues& left,
                             const xsharp::PointValues& right) {
  xsharp::Picture picture;
  picture.points = {{0, 0}, {width, 0}, {width, 2}, {0, 2}};
  picture.values = {left, right, right, left};
  picture.polygons.push_back({.object = 0, .first = 0, .points = 4, .paint = {}});
  return picture;
}

inline Indices drawn(xsharp::SurfaceFiller& filler, const xsharp::Picture& picture,
                     std::int32_t width, std::int32_t height) {
  Indices page(width, height);
  filler.begin(picture, width, height);
  for (const xsharp::Polygon& polygon : picture.polygons) {
    filler.fill<std::uint8_t>(page, picture, polygon, polygon.paint.index);
  }
  return page;
}

/// Records the arguments of the loops and draws nothing.
class RecordingLoops final : public xsharp::SpanLoops {
 public:
  struct Call {
    std::size_t pixels = 0;
    xsharp::StepWords one{};
    xsharp::StepWords other{};
  };
  explicit RecordingLoops(std::vector<Call>& calls) : calls_(&calls) {}

  void gouraud(std::span<std::uint8_t> out, std::uint16_t start,
               std::uint16_t step) const override {
    calls_->push_back({out.size(), {start, step}});
  }
  void gouraud_wide(std::span<std::uint8_t> out, std::uint32_t start,
                    std::uint32_t step) const override {
    calls_->push_back({out.size(), {start, step}});
  }
  void depth(std::span<std::uint8_t> out, std::span<std::int16_t> /*buffer*/,
             std::uint8_t /*pixel*/, std::uint32_t start, std::uint32_t step) const override {
    calls_->push_back({out.size(), {start, step}});
  }
  void texture(std::span<std::uint8_t> out, std::span<const std::uint8_t> /*bitmap*/,
               std::uint32_t u, std::uint32_t du, std::uint32_t v,
               std::uint32_t dv) const override {
    calls_->push_back({out.size(), {u, du}, {v, dv}});
  }

 private:
  std::vector<Call>* calls_;
};

/// The recorded calls for the first `height` rows of a picture.
template <class N>
std::vector<RecordingLoops::Call> calls_of(const xsharp::Scene& scene,
                                           const xsharp::Picture& picture, std::int32_t width,
                                           std::int32_t height = 1) {
  std::vector<RecordingLoops::Call> calls;
  xsharp::StepFiller<N> filler(scene, std::make_unique<RecordingLoops>(calls));
  drawn(filler, picture, width, height);
  return calls;
}

}  // namespace surfaces

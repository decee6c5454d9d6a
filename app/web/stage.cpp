#include "app/web/stage.hpp"

#include <algorithm>

#include "app/web/json.hpp"
#include "app/web/scenes.hpp"
#include "xsharp/animation.hpp"
#include "xsharp/raster/exact_filler.hpp"
#include "xsharp/raster/step_filler.hpp"

namespace fixproof::web {

namespace {

constexpr std::size_t exact = arithmetic_names.size();

void switch_numbers(std::size_t arithmetic) {
  if (arithmetic < exact) switch_to(static_cast<Arithmetic>(arithmetic));
}

/// Writes the colours of a picture of palette indices.
void paint(const xsharp::Palette& palette, std::span<const std::uint8_t> indices,
           std::vector<std::uint8_t>& pixels) {
  pixels.resize(4 * indices.size());
  auto out = pixels.begin();
  for (const std::uint8_t index : indices) {
    const xsharp::Color& color = palette.at(index);
    *out++ = color.red;
    *out++ = color.green;
    *out++ = color.blue;
    *out++ = 255;
  }
}

}  // namespace

std::string stages() {
  Json json;
  json.object([&] {
    json.array("scenes", [&] {
      for (std::size_t i = 0; i < scene_count; ++i) {
        json.object([&] {
          const xsharp::Scene scene = scene_at(i);
          json.field("file", scene_names.at(i));
          json.field("name", scene.name);
          json.field("width", scene.width);
          json.field("height", scene.height);
          json.field("frames_per_second", static_cast<int>(scene.frames_per_second));
        });
      }
    });
    json.array("arithmetics", [&] {
      const auto element = [&](const ArithmeticName& arithmetic) {
        json.object([&] {
          json.field("key", arithmetic.key);
          json.field("name", arithmetic.name);
        });
      };
      for (const ArithmeticName& arithmetic : arithmetic_names) element(arithmetic);
      element({"double", "exact (double)"});
    });
  });
  return json.text();
}

Stage::Stage(std::size_t scene, std::array<std::size_t, 2> arithmetics) : scene_(scene_at(scene)) {
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    sides_.at(i).arithmetic = std::min(arithmetics.at(i), exact);
    start(sides_.at(i));
  }
}

void Stage::start(Playing& side) {
  switch_numbers(side.arithmetic);
  side.frame = 0;
  const bool interpolates = xsharp::interpolates(scene_);
  if (side.arithmetic == exact) {
    side.player = std::make_unique<xsharp::Animation<double>>(scene_);
    if (interpolates) side.surfaces = std::make_unique<xsharp::ExactFiller>(scene_);
  } else {
    side.player = std::make_unique<xsharp::Animation<SwitchedNumber>>(scene_);
    if (interpolates) {
      side.surfaces = std::make_unique<xsharp::StepFiller<SwitchedNumber>>(
          scene_, std::make_unique<xsharp::PlainLoops>());
    }
  }
  side.screen = std::make_unique<xsharp::Screen<std::uint8_t>>(
      scene_.width, scene_.height, scene_.palette, scene_.background, side.surfaces.get());
}

void Stage::switch_arithmetic(std::size_t arithmetic) {
  Playing& playing = sides_.at(played);
  arithmetic = std::min(arithmetic, exact);
  const bool other_numbers = (arithmetic == exact) != (playing.arithmetic == exact);
  playing.arithmetic = arithmetic;
  if (other_numbers) start(playing);
}

std::uint32_t Stage::seek(std::uint32_t frame, std::uint32_t moves) {
  for (Playing& side : sides_) {
    if (frame < side.frame) start(side);
    switch_numbers(side.arithmetic);
    const std::uint32_t end = side.frame + std::min(moves, frame - side.frame);
    for (; side.frame < end; ++side.frame) side.player->move();
  }
  return std::min(sides_[0].frame, sides_[1].frame);
}

std::uint32_t Stage::draw() {
  const xsharp::Palette& palette = xsharp::palette_of(scene_.palette);
  xsharp::Picture picture;
  for (Playing& side : sides_) {
    switch_numbers(side.arithmetic);
    side.player->draw(picture);
    side.screen->show(picture);
    paint(palette, side.screen->page().pixels(), side.pixels);
  }
  const auto is = indices(played);
  const auto other = indices(compared);
  std::uint32_t wrong = 0;
  differences_.assign(4 * is.size(), 255);
  for (std::size_t i = 0; i < is.size(); ++i) {
    const bool same = is[i] == other[i];
    wrong += same ? 0U : 1U;
    if (same)
      std::fill_n(differences_.begin() + static_cast<std::ptrdiff_t>(4 * i), 3, std::uint8_t{0});
  }
  return wrong;
}

}  // namespace fixproof::web

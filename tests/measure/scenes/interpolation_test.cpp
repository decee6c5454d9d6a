// Compares every pixel of surfaces drawn by the listings, inner loops included, with surfaces drawn
// by the type.
#include <filesystem>

#include "measure/player/players.hpp"
#include "measure/player/surfaces.hpp"
#include "tests/measure/scenes/all_arithmetics.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"
#include "xsharp/files/scene_json.hpp"
#include "xsharp/normals.hpp"
#include "xsharp/raster/exact_filler.hpp"
#include "xsharp/raster/screen.hpp"

namespace fixproof {
namespace {

using xsharp::ArithmeticChoice;
using xsharp::DepthBuffering;
using xsharp::Scene;
using xsharp::SurfaceKind;

struct Surfaces {
  Surfaces(const Scene& scene, const ArithmeticChoice& choice)
      : player(player::make_player(scene, choice)),
        filler(player::make_surfaces(scene, choice)),
        screen(scene.width, scene.height, scene.palette, scene.background, filler.get()) {}

  void draw(int frame) {
    if (frame > 0) player->move();
    player->draw(picture);
    screen.show(picture);
  }

  std::unique_ptr<xsharp::Player> player;
  std::unique_ptr<xsharp::SurfaceFiller> filler;
  xsharp::Screen<std::uint8_t> screen;
  xsharp::Picture picture{};
};

/// @return the number of pixels that polygons set
std::int64_t expect_same_pixels(const Scene& scene, ArithmeticChoice choice, int frames) {
  choice.by = "type";
  Surfaces type(scene, choice);
  choice.by = "model";
  Surfaces model(scene, choice);
  for (int frame = 0; frame < frames; ++frame) {
    type.draw(frame);
    model.draw(frame);
    const bool same = type.picture.values == model.picture.values &&
                      type.screen.page() == model.screen.page() &&
                      type.screen.count().pixels == model.screen.count().pixels;
    EXPECT_TRUE(same) << scene.name << ", " << player::name_of(choice) << ", frame " << frame;
    if (!same) break;
  }
  return model.screen.count().pixels;
}

/// The number of pixels that differ from the exact picture in 60 frames of the intersecting solids
/// at half size. The exact picture uses inverse z under either measure.
std::int64_t wrong_pixels(xsharp::DepthMeasure measure) {
  Scene scene = xsharp::read_scene(paths::scene("intersecting.json"));
  scene.width = 160;
  scene.height = 120;
  scene.depth_measure = measure;
  Surfaces stepped(scene, {"type", "i386", true, true});
  xsharp::ExactFiller filler(scene);
  xsharp::Screen<std::uint8_t> exact(scene.width, scene.height, scene.palette, scene.background,
                                     &filler);
  std::int64_t wrong = 0;
  for (int frame = 0; frame < 60; ++frame) {
    stepped.draw(frame);
    exact.show(stepped.picture);
    const auto a = stepped.screen.page().pixels();
    const auto b = exact.page().pixels();
    for (std::size_t i = 0; i < a.size(); ++i) wrong += a[i] == b[i] ? 0 : 1;
  }
  return wrong;
}

// At full size, 2 pixels per frame differ with inverse z and about 700 with z.
TEST(DepthMeasure, SteppedZIsWrongWherePolygonsCross) {
  EXPECT_LT(wrong_pixels(xsharp::DepthMeasure::inverse), 60 * 2);
  EXPECT_GT(wrong_pixels(xsharp::DepthMeasure::z), 60 * 70);
}

class Interpolation : public testing::TestWithParam<std::string> {};

// Uses half size to save time; docs/interpolation.md has the commands for full size.
TEST_P(Interpolation, ModelAndTypeSetTheSamePixelsIn300Frames) {
  Scene scene = xsharp::read_scene(GetParam());
  scene.width = 160;
  scene.height = 120;
  EXPECT_GT(expect_same_pixels(scene, {"", "i386", true, true}, 300), 300 * 2'000);
}

TEST_P(Interpolation, UnderEveryBuild) {
  Scene scene = xsharp::read_scene(GetParam());
  scene.width = 160;
  scene.height = 120;
  int builds = 0;
  for (const ArithmeticChoice& choice : all_arithmetics()) {
    if (choice.by != "model") continue;
    ++builds;
    EXPECT_GT(expect_same_pixels(scene, choice, 6), 6 * 2'000);
  }
  EXPECT_EQ(builds, 12);  // eight builds, and the four 8088 builds with ConcatXforms repaired
}

INSTANTIATE_TEST_SUITE_P(Scenes, Interpolation,
                         testing::Values(paths::scene("intersecting.json"),
                                         paths::scene("textured.json"), paths::scene("phong.json")),
                         [](const auto& scene) {
                           return std::filesystem::path(scene.param).stem().string();
                         });

TEST(Interpolation, EveryVariantIsTheSame) {
  for (std::size_t kind = 0; kind < xsharp::surface_words.size(); ++kind) {
    for (std::size_t depth = 0; depth < xsharp::depth_buffer_words.size(); ++depth) {
      Scene scene = xsharp::read_scene(paths::scene("phong.json"));
      scene.width = 128;
      scene.height = 96;
      scene.depth_buffer = static_cast<DepthBuffering>(depth);
      for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        xsharp::Surface& surface = scene.objects[i].surface;
        surface.kind = static_cast<SurfaceKind>(kind);
        surface.phong = static_cast<xsharp::PhongForm>((depth + i) % 3);
        surface.exact_every = xsharp::exact_choices.at((depth + i) % 4);
      }
      if (!xsharp::interpolates(scene)) continue;
      EXPECT_GT(expect_same_pixels(scene, {"", "i386", true, true}, 2), 2 * 1'000)
          << xsharp::surface_words.at(kind) << ", " << xsharp::depth_buffer_words.at(depth);
    }
  }
}

}  // namespace
}  // namespace fixproof

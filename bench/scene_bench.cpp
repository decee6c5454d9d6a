// Whole frames of the scenes that come with the project, on the type, in double and on the model.
// What is timed is checked by its count of pixels, which fixed point and double agree upon within a
// hundredth.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "player/players.hpp"
#include "xsharp/files/scene_json.hpp"
#include "xsharp/raster/screen.hpp"

namespace {

std::int64_t pixels_of_frames(const xsharp::Scene& scene, const xsharp::ArithmeticChoice& choice) {
  const auto player = fixproof::player::make_player(scene, choice);
  xsharp::Screen<std::uint8_t> screen(scene.width, scene.height, scene.palette, scene.background);
  xsharp::Picture picture;
  for (int i = 0; i < 100; ++i) {
    player->draw(picture);
    screen.show(picture);
    player->move();
  }
  return screen.count().pixels;
}

void frames(benchmark::State& state, const std::string& name,
            const xsharp::ArithmeticChoice& choice) {
  const xsharp::Scene scene = xsharp::read_scene(std::string(SCENES) + "/" + name + ".json");
  const auto exact = static_cast<double>(pixels_of_frames(scene, {"double", "", true, true}));
  const auto drawn = static_cast<double>(pixels_of_frames(scene, choice));
  if (std::fabs(drawn / exact - 1) > 0.01) state.SkipWithError("the pictures are wrong");
  const auto player = fixproof::player::make_player(scene, choice);
  xsharp::Screen<std::uint8_t> screen(scene.width, scene.height, scene.palette, scene.background);
  xsharp::Picture picture;
  for (auto _ : state) {
    player->move();
    player->draw(picture);
    screen.show(picture);
    benchmark::DoNotOptimize(screen.page().pixels().data());
  }
  state.SetItemsProcessed(state.iterations());
}

#define FRAMES(scene)                                                                   \
  BENCHMARK_CAPTURE(frames, scene##_type_i386, #scene, {"type", "i386", true, true});   \
  BENCHMARK_CAPTURE(frames, scene##_type_i8088, #scene, {"type", "i8088", true, true}); \
  BENCHMARK_CAPTURE(frames, scene##_double, #scene, {"double", "", true, true});        \
  BENCHMARK_CAPTURE(frames, scene##_model_i386, #scene, {"model", "i386", true, true}); \
  BENCHMARK_CAPTURE(frames, scene##_model_i8088, #scene, {"model", "i8088", true, true})
FRAMES(twelve_cubes);
FRAMES(ball_and_cubes);
FRAMES(shaded_ball);

}  // namespace

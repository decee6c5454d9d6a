// Tests the screen error of corners against hand calculations, the pipeline's own pixels, and
// drift.
#include "measure/trade/advice/screen_error.hpp"

#include "fixed/fixed.hpp"
#include "measure/player/players.hpp"
#include "measure/trade/advice/screen_corners.hpp"
#include "measure/trade/drift/run.hpp"
#include "tests/measure/one_cube.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"
#include "xsharp/files/scene_json.hpp"

namespace fixproof {
namespace {

xsharp::Scene still_cube(double half_edge, double z) {
  xsharp::Scene scene = one_cube(half_edge, z);
  scene.conversion = xsharp::Conversion::nearest;
  return scene;
}

trade::ScreenError error_of(const xsharp::Scene& scene, const trade::Choice& choice,
                            std::uint64_t frames, double budget = 0.5) {
  const std::atomic<bool> stop = false;
  return trade::screen_errors(scene, std::vector{choice}, budget, frames, stop,
                              [](std::uint64_t) {})
      .at(0);
}

// Corners at z = -8.5 and -9.5, which the 8088 divides by -8 and -9.
TEST(ScreenError, OfTheDivisorsFraction) {
  const double expected = 160.0 * (1 / 8.0 - 1 / 8.5) * std::sqrt(2);
  // A quotient off by a unit is 320 units off on the screen.
  const double units = 2 * 320.0 / 65536;
  const auto off = [](cases::Target target) {
    return error_of(still_cube(0.5, -9), {.build = {.target = target}}, 1).pixels;
  };
  EXPECT_NEAR(off(cases::Target::i8088), expected, units);
  EXPECT_LT(off(cases::Target::i386), units);
}

// Corners at x, y = 1 and z = -9, -11: 65536 / 9 and 65536 / 11 are 7281.78 and 5957.82 units.
TEST(ScreenError, OfTheQuotientsRounding) {
  const double unit = std::sqrt(2) * 320 / 65536;
  // The last product adds a rounding of half a unit in x and y, or of a whole unit.
  const double product = 2.0 / 65536;
  const auto off = [](bool div_round) {
    return error_of(still_cube(1, -10), {.build = {.div_round = div_round}}, 1).pixels;
  };
  EXPECT_NEAR(off(true), (1 - 7.0 / 9) * unit, product);
  EXPECT_NEAR(off(false), 9.0 / 11 * unit, product);
}

TEST(ScreenError, IsThatOfTheWorstFrameAndObject) {
  xsharp::Scene scene = still_cube(0.5, -9);
  scene.objects.push_back(scene.objects[0]);
  scene.objects[1].position = {0, 0, -11.5};
  scene.objects[1].drift = xsharp::Drift{.step = {0, 0, 1.25}};
  const trade::Choice choice{.build = {.target = cases::Target::i8088}};
  // After five frames the object is at -5.25. The 8088 divides its corners at -4.75 by -4.
  const double expected = 160.0 * (1 / 4.0 - 1 / 4.75) * std::sqrt(2);
  const trade::ScreenError error = error_of(scene, choice, 6, 5);
  EXPECT_NEAR(error.pixels, expected, 0.05);
  EXPECT_EQ(error.frame, 5U);
  EXPECT_EQ(error.object, 1U);
  EXPECT_EQ(error.over, 5U);
  EXPECT_EQ(error_of(scene, choice, 6, 1).over, 0U);
  EXPECT_FALSE(error_of(scene, choice, 6, 10).over);
}

TEST(ScreenError, SharedMotionsChangeNothing) {
  const xsharp::Scene scene = xsharp::read_scene(paths::scene("twelve_cubes.json"));
  const auto choices = trade::choices_on({});
  std::uint64_t frames = 30;
  const std::atomic<bool> stop = false;
  const auto together =
      trade::screen_errors(scene, choices, 0.5, frames, stop, [](std::uint64_t) {});
  for (std::size_t i = 0; i < choices.size(); ++i) {
    EXPECT_EQ(together[i].pixels, error_of(scene, choices[i], 30).pixels)
        << trade::name_of(choices[i]);
  }
}

TEST(ScreenError, StopsWhenAsked) {
  const std::atomic<bool> stop = true;
  std::uint64_t frames = 1000;
  trade::screen_errors(still_cube(1, -9), trade::choices_on({}), 0.5, frames, stop,
                       [](std::uint64_t) {});
  EXPECT_EQ(frames, 0U);
}

// Tests that the measured places are the drawn pixels, for every corner.
template <class N>
// NOLINTNEXTLINE(readability-function-cognitive-complexity)
int compare_with_drawn(const std::string& file, const xsharp::ArithmeticChoice& choice) {
  xsharp::Scene scene = xsharp::read_scene(file);
  scene.restore_every = 10;
  const auto player = player::make_player(scene, choice);
  const auto view = xsharp::view_of<N>(scene);
  const xsharp::RotationStyle style{scene.trigonometry, scene.conversion, false, 10};
  std::vector<trade::ScreenCorners<N>> objects;
  for (const auto& object : scene.objects) objects.emplace_back(object, style);
  int compared = 0;
  xsharp::Picture picture;
  for (int frame = 0; frame < 240; ++frame) {
    if (frame > 0) player->move();
    player->draw(picture);
    for (std::size_t i = 0; i < objects.size(); ++i) {
      if (frame > 0) objects[i].advance();
      const xsharp::ObjectState state = player->state(i);
      // The pipeline does not draw the ends of normals.
      std::map<std::size_t, bool> corners;
      for (const auto& face : scene.objects[i].mesh.faces) {
        for (const std::size_t v : face.vertices) corners[v] = true;
      }
      const auto& seen = objects[i].view(view);
      if (seen.size() != (state.view.empty() ? 0 : corners.size())) return -1;
      auto corner = corners.begin();
      for (const auto& place : seen) {
        const auto& drawn = state.screen.at((corner++)->first);
        if (drawn.has_value() != xsharp::inside(place, view.projection.slope)) return -1;
        if (!drawn) continue;
        const auto at = trade::screen_place(place, view.projection);
        if (!at) return -1;
        const xsharp::ScreenPoint pixel{
            static_cast<std::int32_t>(std::floor((*at)[0] + 0.5)) + view.projection.center_x,
            -static_cast<std::int32_t>(std::floor((*at)[1] + 0.5)) + view.projection.center_y};
        if (pixel != *drawn) return -1;
        ++compared;
      }
    }
  }
  return compared;
}

TEST(ScreenCorners, AreWhatIsDrawn) {
  using namespace fixproof;
  for (const std::string& file :
       {paths::scene("ball_and_cubes.json"), paths::scene("shaded_ball.json"),
        paths::source("tests/measure/scenes/passing_by.json")}) {
    EXPECT_GT(compare_with_drawn<q16_16_i386>(file, {"type", "i386", true, true}), 1000) << file;
    EXPECT_GT(compare_with_drawn<q16_16_i386_unrounded>(file, {"type", "i386", false, false}), 1000)
        << file;
    EXPECT_GT(compare_with_drawn<q16_16_i8088_mul_rounded>(file, {"type", "i8088", true, false}),
              1000)
        << file;
  }
}

// Drift measures only the motion. The 386's transform and divide add little: 3 products, a quotient
// and its product are off by at most a unit each. A unit of the quotient is 320 on the screen.
TEST(ScreenError, IsBorneOutByDrift) {
  const xsharp::Scene scene = xsharp::read_scene(paths::scene("twelve_cubes.json"));
  for (const bool mul_round : {true, false}) {
    for (const trade::Turning& turning :
         {trade::Turning{}, trade::Turning{false, 60}, trade::Turning{true, 0}}) {
      std::uint64_t frames = 2000;
      const std::atomic<bool> stop = false;
      const trade::DriftCase drift{.build = {.mul_round = mul_round},
                                   .restore_every = turning.restore_every,
                                   .from_scratch = turning.from_scratch};
      const double motion =
          trade::run_drift(scene, {drift}, frames, stop, [](std::uint64_t) {}).at(0).worst.pixels;
      const trade::Choice choice{.build = {.mul_round = mul_round}, .turning = turning};
      EXPECT_NEAR(error_of(scene, choice, 2000).pixels, motion, 0.02) << trade::name_of(choice);
    }
  }
}

}  // namespace
}  // namespace fixproof

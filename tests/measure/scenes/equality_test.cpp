// Compares register-level X-Sharp with X-Sharp on the type: transforms, vertices, faces and pixels.
#include <fmt/format.h>

#include <filesystem>

#include "measure/player/dump.hpp"
#include "measure/player/players.hpp"
#include "tests/measure/scenes/all_arithmetics.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"
#include "xsharp/files/scene_json.hpp"
#include "xsharp/raster/screen.hpp"

namespace fixproof {
namespace {

constexpr int frames_compared = 600;

struct Drawn {
  explicit Drawn(const xsharp::Scene& scene, const xsharp::ArithmeticChoice& choice)
      : player(player::make_player(scene, choice)),
        screen(scene.width, scene.height, scene.palette, scene.background) {}

  void draw(int frame) {
    if (frame > 0) player->move();
    faults += player->draw(picture).faults;
    screen.show(picture);
  }

  std::unique_ptr<xsharp::Player> player;
  xsharp::Screen<std::uint8_t> screen;
  xsharp::Picture picture{};
  std::uint64_t faults = 0;
};

/// @return the number of frames compared
int expect_equal(const std::string& name, xsharp::ArithmeticChoice choice) {
  const xsharp::Scene scene = xsharp::read_scene(name);
  choice.by = "type";
  Drawn type(scene, choice);
  choice.by = "model";
  Drawn model(scene, choice);
  int compared = 0;
  for (int frame = 0; frame < frames_compared; ++frame) {
    type.draw(frame);
    model.draw(frame);
    const auto number = static_cast<std::uint64_t>(frame);
    const bool same =
        player::dump_frame(*type.player, number) == player::dump_frame(*model.player, number) &&
        type.screen.page() == model.screen.page();
    EXPECT_TRUE(same) << name << ", " << player::name_of(choice) << ", frame " << frame;
    if (!same) break;
    ++compared;
  }
  EXPECT_EQ(type.faults + model.faults, 0U);
  return compared;
}

class Equality : public testing::TestWithParam<std::string> {};

TEST_P(Equality, ModelAndTypeDrawTheSame) {
  int variants = 0;
  for (const xsharp::ArithmeticChoice& choice : all_arithmetics()) {
    if (choice.by != "model") continue;
    ++variants;
    EXPECT_EQ(expect_equal(GetParam(), choice), frames_compared);
  }
  EXPECT_EQ(variants, 12);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Equality,
    testing::Values(paths::scene("twelve_cubes.json"), paths::scene("ball_and_cubes.json"),
                    paths::scene("shaded_ball.json"), paths::scene("solid.json"),
                    paths::scene("lost_carry.json"), paths::scene("look_at.json"),
                    paths::source("tests/measure/scenes/passing_by.json")),
    [](const auto& scene) { return std::filesystem::path(scene.param).stem().string(); });

// The tests above would not notice a variant that uses another variant's rules.
TEST(Variants, EachDrawsDifferently) {
  std::map<std::string, std::string> dumps;
  // In the first scene the viewer's position has no fraction, so the repaired 8088 draws like the
  // printed one. The second scene has too few cubes to show whether divides round.
  for (const std::string& file :
       {paths::scene("twelve_cubes.json"), paths::scene("lost_carry.json")}) {
    const xsharp::Scene scene = xsharp::read_scene(file);
    for (const xsharp::ArithmeticChoice& choice : all_arithmetics()) {
      const auto player = player::make_player(scene, choice);
      xsharp::Picture picture;
      for (std::uint64_t frame = 0; frame < 300; ++frame) {
        if (frame > 0) player->move();
        player->draw(picture);
        if (frame % 20 == 0) dumps[player::name_of(choice)] += player::dump_frame(*player, frame);
      }
    }
  }
  for (const auto& [one, dump] : dumps) {
    for (const auto& [other, other_dump] : dumps) {
      if (!one.starts_with("type i") || !other.starts_with("type i") || one >= other) continue;
      EXPECT_NE(dump, other_dump) << one << " and " << other;
    }
  }
  // The overflow policy does not affect results that are in range.
  EXPECT_EQ(dumps.at("type standard"), dumps.at("type saturating"));
  EXPECT_EQ(dumps.at("type standard"), dumps.at("type trapping"));
}

}  // namespace
}  // namespace fixproof

// The pipeline against frames that golden/work_out.py has worked out in exact integers.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "verify/scenes/players.hpp"
#include "xsharp/files/scene_json.hpp"

namespace fixproof {
namespace {

constexpr std::array<std::uint64_t, 4> kept_frames{0, 1, 199, 599};
constexpr std::size_t kept_vertices = 8;

/// What the golden files keep of a frame: one object of it, all of its first vertices.
std::string text_of(const xsharp::Player& player, std::uint64_t frame) {
  const std::size_t object = frame % player.order().size();
  const xsharp::ObjectState state = player.state(object);
  std::string view;
  std::string screen;
  for (std::size_t i = 0; i < kept_vertices; ++i) {
    const char* between = i == 0 ? "" : ", ";
    view += fmt::format("{}{}", between, fmt::join(state.view.at(i), " "));
    screen += fmt::format("{}{} {}", between, state.screen.at(i)->x, state.screen.at(i)->y);
  }
  return fmt::format(
      "frame {} order {}\n  object {} xform {}\n  view {}\n  screen {}\n  visible {}\n", frame,
      fmt::join(player.order(), " "), object, fmt::join(state.xform, " "), view, screen,
      fmt::join(state.visible, " "));
}

std::string read(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

void expect_golden(const std::string& name, const std::string& by) {
  const xsharp::Scene scene = xsharp::read_scene(fmt::format("{}/{}.json", SCENES, name));
  std::string all;
  for (const xsharp::ArithmeticChoice& choice : all_arithmetics()) {
    if (choice.by != by || !xsharp::is_listing(choice)) continue;
    all += fmt::format("# {} multiply {} divide {}\n", choice.target,
                       choice.mul_round ? "on" : "off", choice.div_round ? "on" : "off");
    const auto player = make_player(scene, choice);
    xsharp::Picture picture;
    for (std::uint64_t frame = 0; frame <= kept_frames.back(); ++frame) {
      if (frame > 0) player->move();
      player->draw(picture);
      if (std::ranges::find(kept_frames, frame) != kept_frames.end())
        all += text_of(*player, frame);
    }
  }
  EXPECT_EQ(all, read(fmt::format("{}/{}.txt", GOLDEN, name)));
}

TEST(Golden, TwelveCubes) { expect_golden("twelve_cubes", "type"); }
TEST(Golden, BallAndCubes) { expect_golden("ball_and_cubes", "type"); }
TEST(Golden, ShadedBall) { expect_golden("shaded_ball", "type"); }
TEST(Golden, TwelveCubesOnTheModel) { expect_golden("twelve_cubes", "model"); }

// Worked by hand from the listings of chapter 52: cube 11 after 199 steps.
TEST(Golden, TheCubeWorkedByHand) {
  const xsharp::Scene scene = xsharp::read_scene(fmt::format("{}/twelve_cubes.json", SCENES));
  const auto player = make_player(scene, {"type", "i386", true, true});
  xsharp::Picture picture;
  for (int i = 0; i < 199; ++i) player->move();
  player->draw(picture);
  const xsharp::ObjectState cube = player->state(11);
  EXPECT_EQ(cube.view.at(0), (std::array<std::int32_t, 3>{-6851485, -2962285, -20564885}));
  EXPECT_EQ(cube.screen.at(0), (xsharp::ScreenPoint{53, 166}));
}

}  // namespace
}  // namespace fixproof

// Compares the pipeline with the frames of golden/work_out.py, which uses exact integers, the
// pictures of golden/work_out_pixels.py and the colours of golden/work_out_paints.py.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>

#include "measure/player/players.hpp"
#include "measure/player/surfaces.hpp"
#include "tests/measure/scenes/all_arithmetics.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"
#include "xsharp/files/scene_json.hpp"
#include "xsharp/raster/screen.hpp"

namespace fixproof {
namespace {

constexpr std::array<std::uint64_t, 4> kept_frames{0, 1, 199, 599};
constexpr std::size_t kept_vertices = 8;

/// The part of a frame that the golden files keep: the state of one object and its first vertices.
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

std::string golden(const std::string& file) {
  return paths::source("tests/measure/scenes/golden/" + file);
}

void expect_golden(const std::string& name, const std::string& by) {
  const xsharp::Scene scene = xsharp::read_scene(paths::scene(name + ".json"));
  std::string all;
  for (const xsharp::ArithmeticChoice& choice : all_arithmetics()) {
    if (choice.by != by || !xsharp::is_listing(choice)) continue;
    // A viewer at the origin loses no carry, so these golden files omit the repaired builds.
    if (choice.repaired && scene.camera.position == xsharp::Triple{}) continue;
    all += fmt::format("# {}{} multiply {} divide {}\n", choice.target,
                       choice.repaired ? " repaired" : "", choice.mul_round ? "on" : "off",
                       choice.div_round ? "on" : "off");
    const auto player = player::make_player(scene, choice);
    xsharp::Picture picture;
    for (std::uint64_t frame = 0; frame <= kept_frames.back(); ++frame) {
      if (frame > 0) player->move();
      player->draw(picture);
      if (std::ranges::find(kept_frames, frame) != kept_frames.end())
        all += text_of(*player, frame);
    }
  }
  EXPECT_EQ(all, read(golden(name + ".txt")));
}

/// The 64-bit FNV-1a hash.
std::uint64_t hash_of(std::span<const std::uint8_t> bytes) {
  std::uint64_t hash = 0xCBF29CE484222325;
  for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001B3;
  return hash;
}

/// Compares each picture with the record that golden/work_out_pixels.py keeps of it.
void expect_golden_pixels(const std::string& name,
                          const std::string& folder = paths::source("xsharp/scenes")) {
  const xsharp::Scene scene = xsharp::read_scene(fmt::format("{}/{}.json", folder, name));
  std::string all;
  for (const xsharp::ArithmeticChoice& choice : all_arithmetics()) {
    if (choice.by != "type" || !xsharp::is_listing(choice) || choice.repaired) continue;
    all += fmt::format("# {} multiply {} divide {}\n", choice.target,
                       choice.mul_round ? "on" : "off", choice.div_round ? "on" : "off");
    const auto player = player::make_player(scene, choice);
    const auto surfaces = player::make_surfaces(scene, choice);
    xsharp::Screen<std::uint8_t> screen(scene.width, scene.height, scene.palette, scene.background,
                                        surfaces.get());
    xsharp::Picture picture;
    for (std::uint64_t frame = 0; frame <= kept_frames.back(); ++frame) {
      if (frame > 0) player->move();
      player->draw(picture);
      if (std::ranges::find(kept_frames, frame) == kept_frames.end()) continue;
      screen.show(picture);
      const auto pixels = screen.page().pixels();
      const auto drawn =
          std::ranges::count_if(pixels, [](std::uint8_t pixel) { return pixel != 0; });
      all += fmt::format("frame {} drawn {} hash {:016x}\n", frame, drawn, hash_of(pixels));
    }
  }
  EXPECT_EQ(all, read(golden(name + "_pixels.txt")));
}

/// Compares the colours of the faces with the record that golden/work_out_paints.py keeps of them.
void expect_golden_paints(const std::string& name, const std::string& by) {
  constexpr std::size_t shown = 8;
  const xsharp::Scene scene = xsharp::read_scene(paths::scene(name + ".json"));
  std::string all;
  for (const xsharp::ArithmeticChoice& choice : all_arithmetics()) {
    if (choice.by != by || !xsharp::is_listing(choice) || choice.repaired) continue;
    all += fmt::format("# {} multiply {} divide {}\n", choice.target,
                       choice.mul_round ? "on" : "off", choice.div_round ? "on" : "off");
    const auto player = player::make_player(scene, choice);
    xsharp::Picture picture;
    for (std::uint64_t frame = 0; frame <= kept_frames.back(); ++frame) {
      if (frame > 0) player->move();
      if (std::ranges::find(kept_frames, frame) == kept_frames.end()) continue;
      player->draw(picture);
      std::vector<std::uint8_t> components;
      std::string colors;
      for (const auto& [object, first, points, paint] : picture.polygons) {
        const auto [red, green, blue] = paint.color;
        if (components.size() < 3 * shown)
          colors += fmt::format(" {:02x}{:02x}{:02x}", red, green, blue);
        components.insert(components.end(), {red, green, blue});
      }
      all += fmt::format("frame {} faces {} hash {:016x}\n {}\n", frame, picture.polygons.size(),
                         hash_of(components), colors);
    }
  }
  EXPECT_EQ(all, read(golden(name + "_paints.txt")));
}

TEST(Golden, TwelveCubes) { expect_golden("twelve_cubes", "type"); }
TEST(Golden, BallAndCubes) { expect_golden("ball_and_cubes", "type"); }
TEST(Golden, ShadedBall) { expect_golden("shaded_ball", "type"); }
TEST(Golden, Intersecting) { expect_golden("intersecting", "type"); }
TEST(Golden, Textured) { expect_golden("textured", "type"); }
TEST(Golden, Phong) { expect_golden("phong", "type"); }
TEST(Golden, LostCarry) { expect_golden("lost_carry", "type"); }
TEST(Golden, Highlight) { expect_golden("highlight", "type"); }
TEST(Golden, LookAt) { expect_golden("look_at", "type"); }
TEST(Golden, LookAtOnTheModel) { expect_golden("look_at", "model"); }
TEST(Golden, PaintsOfHighlight) { expect_golden_paints("highlight", "type"); }
TEST(Golden, PaintsOfHighlightOnTheModel) { expect_golden_paints("highlight", "model"); }
TEST(Golden, PaintsOfLookAt) { expect_golden_paints("look_at", "type"); }
TEST(Golden, LostCarryOnTheModel) { expect_golden("lost_carry", "model"); }
TEST(Golden, PixelsOfIntersecting) { expect_golden_pixels("intersecting"); }
TEST(Golden, PixelsOfIntersectingByZItself) {
  expect_golden_pixels("intersecting_z", paths::source("tests/measure/scenes"));
}
TEST(Golden, PixelsOfTextured) { expect_golden_pixels("textured"); }
TEST(Golden, PixelsOfPhong) { expect_golden_pixels("phong"); }
TEST(Golden, TwelveCubesOnTheModel) { expect_golden("twelve_cubes", "model"); }

// Cube 11 after 199 steps, computed by hand from the listings of chapter 52.
TEST(Golden, TheCubeWorkedByHand) {
  const xsharp::Scene scene = xsharp::read_scene(paths::scene("twelve_cubes.json"));
  const auto player = player::make_player(scene, {"type", "i386", true, true});
  xsharp::Picture picture;
  for (int i = 0; i < 199; ++i) player->move();
  player->draw(picture);
  const xsharp::ObjectState cube = player->state(11);
  EXPECT_EQ(cube.view.at(0), (std::array<std::int32_t, 3>{-6851485, -2962285, -20564885}));
  EXPECT_EQ(cube.screen.at(0), (xsharp::ScreenPoint{53, 166}));
}

}  // namespace
}  // namespace fixproof

// Tests chapter 54's statement about its demonstration: green light shades smoothly, and green
// light with blue light does not.
#include "measure/player/players.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"
#include "xsharp/files/scene_json.hpp"
#include "xsharp/raster/palette.hpp"

namespace fixproof {
namespace {

struct Shades {
  int greatest_change = 0;  ///< largest change of a face's green level between frames, 0 to 255
  std::set<int> greens;     ///< green levels on the screen
};

/// Shows a full turn of the ball and collects its green levels from the palette.
Shades shades(bool spot_two) {
  xsharp::Scene scene = xsharp::read_scene(paths::scene("shaded_ball.json"));
  scene.lights.spots.at(2).on = spot_two;
  const auto player = player::make_player(scene, scene.arithmetic);
  const xsharp::Palette& palette = xsharp::palette_of(scene.palette);
  xsharp::Picture picture;
  Shades shades;
  std::map<std::size_t, int> last;
  for (int frame = 0; frame < 360; ++frame) {
    if (frame > 0) player->move();
    player->draw(picture);
    const auto visible = player->state(0).visible;
    std::map<std::size_t, int> greens;
    for (std::size_t i = 0; i < visible.size(); ++i) {
      const auto index = xsharp::index_of(picture.polygons.at(i).paint, scene.palette);
      const int green = palette.at(index).green;
      greens[visible[i]] = green;
      shades.greens.insert(green);
      const auto before = last.find(visible[i]);
      if (before == last.end()) continue;
      shades.greatest_change = std::max(shades.greatest_change, std::abs(green - before->second));
    }
    last = greens;
  }
  return shades;
}

TEST(ShadedBall, GreenIsSmoothUntilSpotTwoIsOn) {
  const Shades green = shades(false);
  const Shades with_blue = shades(true);
  // A pure primary has 64 levels, which are 4 or 5 of 255 apart. The ball turns about 2 degrees per
  // frame, which changes the light of two spots by less than 0.035 * 0.9.
  EXPECT_LE(green.greatest_change, 0.035 * 0.9 * 255 + 5);
  EXPECT_GT(green.greens.size(), 40U);
  // A mixture has only four levels of each component, which are far apart.
  EXPECT_GE(with_blue.greatest_change, 80);
}

}  // namespace
}  // namespace fixproof

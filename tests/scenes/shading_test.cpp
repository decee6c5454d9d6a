// What chapter 54 says of its demonstration: green light shades smoothly, and blue light added to
// it does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "player/players.hpp"
#include "xsharp/files/scene_json.hpp"
#include "xsharp/raster/palette.hpp"

namespace fixproof {
namespace {

struct Shades {
  int greatest_change = 0;  ///< of a face's green from one frame to the next, of 255
  std::set<int> greens;     ///< that are shown
};

/// A turn of the ball, as its palette shows it.
Shades shades(bool spot_two) {
  xsharp::Scene scene = xsharp::read_scene(SCENES "/shaded_ball.json");
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
  // 64 levels of a pure primary: neighbours are 4 or 5 of 255 apart. A frame turns the ball by
  // about 2 degrees, which changes the light of two spots by less than 0.035 * 0.9.
  EXPECT_LE(green.greatest_change, 0.035 * 0.9 * 255 + 5);
  EXPECT_GT(green.greens.size(), 40U);
  // Four levels of each component of a mixture, far apart.
  EXPECT_GE(with_blue.greatest_change, 80);
}

}  // namespace
}  // namespace fixproof

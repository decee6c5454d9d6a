// Compares the pictures of the type and of the register-level model with those of the original
// programs. The digests in originals/ come from running those programs under a DOS emulator.
#include <fstream>

#include "measure/player/picture_digest.hpp"
#include "measure/player/players.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"
#include "xsharp/files/scene_json.hpp"
#include "xsharp/raster/screen.hpp"

namespace fixproof {
namespace {

struct Recorded {
  const char* file;
  const char* scene;
  std::size_t begins_at;  ///< index of our frame that matches the recording's first picture
  std::size_t pictures;
};

std::vector<std::string> lines_of(const std::string& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// Digests of a scene's pictures from frame `first` on. Consecutive equal pictures count once.
std::vector<std::string> drawn(const xsharp::Scene& scene, const xsharp::ArithmeticChoice& choice,
                               std::size_t first, std::size_t pictures) {
  const auto player = player::make_player(scene, choice);
  xsharp::Screen<std::uint8_t> screen(scene.width, scene.height, scene.palette, scene.background);
  xsharp::Picture picture;
  player::DigestLines digests;
  std::string lines;
  std::size_t distinct = 0;
  // The limit stops a scene that no longer changes; no recording repeats pictures for longer.
  const std::size_t most_frames = first + 2 * pictures;
  for (std::size_t frame = 0; frame < most_frames && distinct < pictures; ++frame) {
    if (frame > 0) player->move();
    player->draw(picture);
    if (frame < first) continue;
    screen.show(picture);
    const std::string line = digests.line_of(screen.page().pixels());
    lines += line;
    if (!line.empty()) ++distinct;
  }
  std::istringstream in(lines);
  std::vector<std::string> result;
  for (std::string line; std::getline(in, line);) result.push_back(line);
  return result;
}

class Originals : public testing::TestWithParam<Recorded> {};

void expect_recorded(const Recorded& recorded, std::string_view by) {
  const xsharp::Scene scene = xsharp::read_scene(paths::scene(recorded.scene));
  xsharp::ArithmeticChoice choice = scene.arithmetic;
  ASSERT_EQ(choice.target, "i386");
  choice.by = by;
  const auto expected =
      lines_of(paths::source("tests/measure/scenes/originals/" + std::string(recorded.file)));
  ASSERT_EQ(expected.size(), recorded.pictures);
  const auto pictures = drawn(scene, choice, recorded.begins_at, expected.size());
  ASSERT_EQ(pictures.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(pictures[i], expected[i]) << recorded.file << ", picture " << i;
  }
}

TEST_P(Originals, TheTypeDrawsThem) { expect_recorded(GetParam(), "type"); }
TEST_P(Originals, TheModelDrawsThem) { expect_recorded(GetParam(), "model"); }

INSTANTIATE_TEST_SUITE_P(
    Recordings, Originals,
    testing::Values(Recorded{"chapter52_start.txt", "twelve_cubes.json", 0, 40},
                    Recorded{"chapter52.txt", "twelve_cubes.json", 2, 2000},
                    Recorded{"chapter53.txt", "chapter53.json", 2, 60},
                    Recorded{"chapter53_pass.txt", "chapter53_pass.json", 3, 200},
                    Recorded{"chapter53_equal.txt", "chapter53_equal.json", 3, 150},
                    Recorded{"chapter54_ball.txt", "chapter54_ball.json", 2, 400}),
    [](const auto& recorded) {
      std::string name = recorded.param.file;
      name.resize(name.find('.'));
      return name;
    });

// FIPS 180-4 publishes the digest of "abc", which begins with ba7816bf 8f01cfea.
TEST(PictureDigest, IsTheBeginningOfSha256) {
  const std::vector<std::uint8_t> abc{'a', 'b', 'c'};
  EXPECT_EQ(player::picture_digest(abc), "ba7816bf8f01cfea");
  EXPECT_EQ(player::picture_digest({}), "e3b0c44298fc1c14");
  // With 56 bytes the length needs a second block (the second example of FIPS 180-4).
  constexpr std::string_view two_blocks =
      "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq";
  EXPECT_EQ(player::picture_digest(std::vector<std::uint8_t>(two_blocks.begin(), two_blocks.end())),
            "248d6a61d20638b8");
}

TEST(PictureDigest, EqualPicturesInARowAreOneLine) {
  player::DigestLines lines;
  const std::vector<std::uint8_t> one{1};
  const std::vector<std::uint8_t> other{2};
  EXPECT_EQ(lines.line_of(one), player::picture_digest(one) + '\n');
  EXPECT_EQ(lines.line_of(one), "");
  EXPECT_EQ(lines.line_of(other), player::picture_digest(other) + '\n');
  EXPECT_EQ(lines.line_of(one), player::picture_digest(one) + '\n');
}

}  // namespace
}  // namespace fixproof

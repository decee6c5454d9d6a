// Tests the loops that draw pictures on the model against the same loops in C++ on words.
#include "measure/player/model_loops.hpp"

#include "tests/support/test.hpp"

namespace {

using fixproof::player::ModelLoops;
using x86model::Counting;
using x86model::Target;

/// Rows of every length up to the longest.
constexpr std::size_t lengths = xsharp::longest_span + 1;

class Loops : public testing::TestWithParam<std::pair<Counting, Target>> {
 protected:
  ModelLoops model_{GetParam().first, GetParam().second};
  xsharp::PlainLoops plain_;
  std::mt19937 random_{300};

  std::uint32_t word() { return static_cast<std::uint32_t>(random_()); }
};

TEST_P(Loops, ShadeTheSame) {
  for (std::size_t length = 0; length < lengths; ++length) {
    std::vector<std::uint8_t> ours(length, 1);
    std::vector<std::uint8_t> theirs(length, 2);
    const auto start = static_cast<std::uint16_t>(word());
    const auto step = static_cast<std::uint16_t>(word());
    model_.gouraud(ours, start, step);
    plain_.gouraud(theirs, start, step);
    ASSERT_EQ(ours, theirs) << length;
    const std::uint32_t wide = word();
    model_.gouraud_wide(ours, wide, 0x1234);
    plain_.gouraud_wide(theirs, wide, 0x1234);
    ASSERT_EQ(ours, theirs) << length;
  }
}

TEST_P(Loops, TestDepthsTheSame) {
  std::size_t drawn = 0;
  for (std::size_t length = 0; length < lengths; ++length) {
    std::vector<std::uint8_t> ours(length);
    std::vector<std::int16_t> our_depths(length);
    for (auto& depth : our_depths) depth = static_cast<std::int16_t>(word());
    auto theirs = ours;
    auto their_depths = our_depths;
    const std::uint32_t start = word();
    const std::uint32_t step = word() % 0x8000;
    model_.depth(ours, our_depths, 9, start, step);
    plain_.depth(theirs, their_depths, 9, start, step);
    ASSERT_EQ(ours, theirs) << length;
    ASSERT_EQ(our_depths, their_depths) << length;
    for (const std::uint8_t pixel : ours) drawn += pixel == 9 ? 1 : 0;
  }
  EXPECT_GT(drawn, 10'000U);
  EXPECT_LT(drawn, 40'000U);
}

TEST_P(Loops, DrawTheSameTexture) {
  std::vector<std::uint8_t> bitmap(xsharp::bitmap_texels);
  for (auto& texel : bitmap) texel = static_cast<std::uint8_t>(word());
  for (std::size_t length = 0; length < lengths; length += 5) {
    std::vector<std::uint8_t> ours(length, 1);
    std::vector<std::uint8_t> theirs(length, 2);
    const std::array<std::uint32_t, 4> words{word(), word(), word(), word()};
    model_.texture(ours, bitmap, words[0], words[1], words[2], words[3]);
    plain_.texture(theirs, bitmap, words[0], words[1], words[2], words[3]);
    ASSERT_EQ(ours, theirs) << length;
  }
}

INSTANTIATE_TEST_SUITE_P(Counting, Loops,
                         testing::Values(std::pair(Counting::loop, Target::i386),
                                         std::pair(Counting::dec_jnz, Target::i386),
                                         std::pair(Counting::unrolled, Target::i386),
                                         std::pair(Counting::loop, Target::i8088)));

TEST(ModelLoops, RefuseWhatNoLoopDraws) {
  const ModelLoops loops;
  std::vector<std::uint8_t> row(xsharp::longest_span + 1);
  EXPECT_THROW(loops.gouraud(row, 0, 0), std::length_error);
  const std::vector<std::uint8_t> bitmap(xsharp::bitmap_texels - 256);
  EXPECT_THROW(loops.texture(std::span(row).first(1), bitmap, 0, 0, 0, 0), std::length_error);
}

}  // namespace

#include "xsharp/files/animation_png.hpp"

#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"
#include "tests/xsharp/raster/read_png.hpp"
#include "xsharp/files/png.hpp"
#include "xsharp/files/png_chunks.hpp"

namespace xsharp {
namespace {

std::vector<Page<std::uint32_t>> pages(std::int32_t width, std::int32_t height, std::size_t count) {
  std::vector<Page<std::uint32_t>> all(count, Page<std::uint32_t>(width, height));
  std::uint32_t state = 7;
  for (auto& page : all) {
    for (std::uint32_t& pixel : page.pixels()) {
      state = state * 1664525U + 1013904223U;
      pixel = state >> 8U;
    }
  }
  return all;
}

std::string png_of(std::int32_t width, std::int32_t height) {
  return encode_png(Page<std::uint32_t>(width, height));
}

void expect_read_back(std::size_t count, std::int32_t width, std::int32_t height) {
  const ScratchFolder folder;
  const auto shown = pages(width, height, count);
  {
    AnimationPng animation(folder.path("a.png"), {3, 100});
    for (const auto& page : shown) animation.add(encode_png(page));
    animation.finish();
    EXPECT_EQ(animation.frames(), count);
  }

  const std::string bytes = folder.read("a.png");
  EXPECT_EQ(read_png::by_libpng(bytes), shown.front());
  const auto read = read_png::by_chunks(bytes);
  EXPECT_EQ(read.announced, count);
  EXPECT_EQ(read.plays, 0U);
  EXPECT_EQ(read.frames, shown);
  EXPECT_EQ(read.times, std::vector<std::string>(count, "3/100"));
  EXPECT_EQ(folder.files(), 1) << "neither a lock nor an unfinished file is left";
}

TEST(AnimationPng, EveryFrameIsReadBack) { expect_read_back(5, 9, 7); }
TEST(AnimationPng, OneFrameIsAnAnimation) { expect_read_back(1, 4, 4); }
TEST(AnimationPng, FramesOfSeveralPiecesKeepTheirSequence) { expect_read_back(3, 300, 200); }

TEST(AnimationPng, IndexedFramesShareTheirPalette) {
  const ScratchFolder folder;
  const Palette& palette = palette_of(PaletteKind::vga);
  AnimationPng animation(folder.path("a.png"), frame_time(60));
  Page<std::uint8_t> page(5, 3);
  for (const auto index : std::vector<std::uint8_t>{4, 15, 40}) {
    page.clear(index);
    animation.add(encode_png(page, palette));
  }
  animation.finish();
  const auto read = read_png::by_chunks(folder.read("a.png"));
  ASSERT_EQ(read.frames.size(), 3U);
  EXPECT_EQ(read.frames[0].row(0)[0], 0xaa0000U);
  EXPECT_EQ(read.frames[1].row(2)[4], 0xffffffU);
  EXPECT_EQ(read.frames[2].row(1)[1], 0xff0000U);
  EXPECT_EQ(read.times[2], "1/60");
}

TEST(AnimationPng, AbandonedItLeavesNothing) {
  const ScratchFolder folder;
  {
    AnimationPng animation(folder.path("a.png"), {});
    animation.add(png_of(2, 2));
  }
  EXPECT_EQ(folder.files(), 0);
}

TEST(AnimationPng, WithoutFramesThereIsNoFile) {
  const ScratchFolder folder;
  {
    AnimationPng animation(folder.path("a.png"), {});
    EXPECT_THROW(animation.finish(), std::logic_error);
  }
  EXPECT_EQ(folder.files(), 0);
}

TEST(AnimationPng, FramesUnlikeTheFirstAreRefusedAndLeftOut) {
  const ScratchFolder folder;
  const Page<std::uint8_t> indexed(2, 2);
  AnimationPng animation(folder.path("a.png"), {});
  animation.add(encode_png(indexed, palette_of(PaletteKind::vga)));
  for (const std::string& other :
       {png_of(2, 2), encode_png(Page<std::uint8_t>(2, 3), palette_of(PaletteKind::vga)),
        encode_png(indexed, palette_of(PaletteKind::shading)), std::string(), std::string("GIF89a"),
        std::string(png_signature) + png_chunk("IEND", {}),
        std::string(png_signature) + png_chunk("IHDR", "short") + png_chunk("IEND", {}),
        png_of(2, 2).substr(0, 50)}) {
    EXPECT_THROW(animation.add(other), std::invalid_argument) << other.size();
  }
  animation.add(encode_png(indexed, palette_of(PaletteKind::vga)));
  animation.finish();
  EXPECT_EQ(read_png::by_chunks(folder.read("a.png")).frames.size(), 2U);
}

TEST(AnimationPng, AnAnimationIsNoFrame) {
  const ScratchFolder folder;
  AnimationPng animation(folder.path("a.png"), {});
  animation.add(png_of(2, 2));
  animation.finish();
  AnimationPng another(folder.path("b.png"), {});
  EXPECT_THROW(another.add(folder.read("a.png")), std::invalid_argument);
}

TEST(AnimationPng, WhereNothingCanBeWrittenItDoesNotBegin) {
  EXPECT_THROW(AnimationPng("/nowhere/a.png", {}), std::runtime_error);
}

TEST(FrameTimes, AreTheNearestFractionsInLowestTerms) {
  EXPECT_EQ(frame_time(60), (FrameTime{1, 60}));
  EXPECT_EQ(frame_time(1), (FrameTime{1, 1}));
  EXPECT_EQ(frame_time(0.4), (FrameTime{5, 2}));
  EXPECT_EQ(frame_time(29.97), (FrameTime{100, 2997}));
  EXPECT_EQ(frame_time(12.5), (FrameTime{2, 25}));
  EXPECT_EQ(frame_time(65535), (FrameTime{1, 65535}));
  EXPECT_EQ(frame_time(1.0 / 65535), (FrameTime{65535, 1}));
}

TEST(FrameTimes, RatesWithoutAFractionAreRefused) {
  for (const double rate :
       {0.0, -60.0, 65536.0, 1e-5, 1e300, std::numeric_limits<double>::infinity(),
        std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW((void)frame_time(rate), std::invalid_argument) << rate;
  }
}

TEST(ReadPng, TheReaderOfChunksRefusesAFlippedBit) {
  const ScratchFolder folder;
  AnimationPng animation(folder.path("a.png"), {});
  for (const auto& page : pages(3, 3, 2)) animation.add(encode_png(page));
  animation.finish();
  const std::string whole = folder.read("a.png");
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string spoilt = whole;
    spoilt[i] = static_cast<char>(spoilt[i] ^ 1);
    EXPECT_ANY_THROW((void)read_png::by_chunks(spoilt)) << i;
  }
}

}  // namespace
}  // namespace xsharp

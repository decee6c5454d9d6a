#include "xsharp/raster/palette.hpp"

#include <rapidcheck.h>

#include "tests/support/test.hpp"

namespace xsharp {
namespace {

const Palette& vga() { return palette_of(PaletteKind::vga); }
const Palette& shading() { return palette_of(PaletteKind::shading); }

std::string text(const Color& color) {
  return std::to_string(color.red) + "," + std::to_string(color.green) + "," +
         std::to_string(color.blue);
}

/// The DAC levels, 0 to 63, of an index.
std::string dac(std::size_t index) {
  const Color color = vga().at(index);
  return text({static_cast<std::uint8_t>(color.red >> 2U),
               static_cast<std::uint8_t>(color.green >> 2U),
               static_cast<std::uint8_t>(color.blue >> 2U)});
}

TEST(VgaPalette, BeginsWithTheColorsOfTheEga) {
  const std::vector<std::string> ega{"0,0,0",    "0,0,42",   "0,42,0",   "0,42,42",
                                     "42,0,0",   "42,0,42",  "42,21,0",  "42,42,42",
                                     "21,21,21", "21,21,63", "21,63,21", "21,63,63",
                                     "63,21,21", "63,21,63", "63,63,21", "63,63,63"};
  for (std::size_t i = 0; i < ega.size(); ++i) EXPECT_EQ(dac(i), ega[i]) << i;
}

TEST(VgaPalette, HasGreysThenRingsThatLoseSaturationThenValue) {
  for (const auto& [index, levels] : std::initializer_list<std::pair<std::size_t, const char*>>{
           {16, "0,0,0"},
           {17, "5,5,5"},
           {24, "28,28,28"},
           {30, "56,56,56"},
           {31, "63,63,63"},
           // The first ring goes from blue by red and green.
           {32, "0,0,63"},
           {33, "16,0,63"},
           {36, "63,0,63"},
           {37, "63,0,47"},
           {40, "63,0,0"},
           {42, "63,31,0"},
           {44, "63,63,0"},
           {47, "16,63,0"},
           {48, "0,63,0"},
           {52, "0,63,63"},
           {55, "0,16,63"},
           // The others follow.
           {56, "31,31,63"},
           {57, "39,31,63"},
           {80, "45,45,63"},
           {83, "58,45,63"},
           {104, "0,0,28"},
           {107, "21,0,28"},
           {128, "14,14,28"},
           {152, "20,20,28"},
           {176, "0,0,16"},
           {200, "8,8,16"},
           {224, "11,11,16"},
           {227, "15,11,16"},
           {247, "11,12,16"}}) {
    EXPECT_EQ(dac(index), levels) << index;
  }
}

TEST(VgaPalette, EndsInBlack) {
  for (std::size_t i = 248; i < 256; ++i) EXPECT_EQ(vga().at(i), Color{}) << i;
}

TEST(VgaPalette, FullIntensityIs255) {
  EXPECT_EQ(text(vga().at(15)), "255,255,255");
  EXPECT_EQ(text(vga().at(40)), "255,0,0");
  EXPECT_EQ(text(vga().at(6)), "170,85,0");
}

TEST(VgaPalette, TheNearestColorOfAnIndexIsItsOwn) {
  for (std::size_t i = 0; i < 256; ++i) {
    const Color& color = vga().at(i);
    EXPECT_EQ(vga().at(nearest(vga(), color)), color) << i;
    EXPECT_LE(nearest(vga(), color), i);
  }
}

TEST(VgaPalette, TheLowestOfEquallyNearIndicesWins) {
  EXPECT_EQ(nearest(vga(), {0, 0, 0}), 0);
  EXPECT_EQ(nearest(vga(), {255, 255, 255}), 15);
  EXPECT_EQ(nearest(vga(), {255, 0, 0}), 40);
  Palette palette{};
  palette.fill({200, 200, 200});
  palette[7] = {10, 0, 0};
  palette[9] = {0, 0, 10};
  EXPECT_EQ(nearest(palette, {5, 0, 5}), 7);
  EXPECT_EQ(nearest(palette, {4, 0, 6}), 9);
}

TEST(VgaPalette, NoIndexIsNearerThanTheNearest) {
  EXPECT_TRUE(rc::check([](std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    const auto square = [](int a, int b) { return (a - b) * (a - b); };
    const auto off = [&](const Color& c) {
      return square(c.red, red) + square(c.green, green) + square(c.blue, blue);
    };
    const std::uint8_t found = nearest(vga(), {red, green, blue});
    for (std::size_t i = 0; i < 256; ++i) {
      const int further = off(vga().at(i)) - off(vga().at(found));
      RC_ASSERT(further > 0 || (further == 0 && i >= found));
    }
  }));
}

// The author's VGA DAC levels 0, 39, 53 and 63, scaled to 8 bits.
TEST(ShadingPalette, HasTheAuthorsGammaInMixturesAlone) {
  const Palette& gamma = palette_of(PaletteKind::shading_gamma);
  EXPECT_EQ(text(gamma.at(0)), "0,0,0");
  EXPECT_EQ(text(gamma.at(0x15)), "158,158,158");
  EXPECT_EQ(text(gamma.at(0x2a)), "215,215,215");
  EXPECT_EQ(text(gamma.at(0x3f)), "255,255,255");
  EXPECT_EQ(text(gamma.at(0x1b)), "158,215,255");
  for (std::size_t i = 64; i < 256; ++i) EXPECT_EQ(text(gamma.at(i)), text(shading().at(i)));
  constexpr std::array<long, 4> levels{0, 39, 53, 63};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    EXPECT_EQ(std::lround(63 * std::pow(static_cast<double>(i) / 3, 1 / 2.3)), levels.at(i));
  }
  // A colour has the same index in both palettes.
  const Paint dim{.is_index = false, .color = {100, 200, 10}};
  EXPECT_EQ(index_of(dim, PaletteKind::shading_gamma), 0x1c);
  EXPECT_EQ(index_of(dim, PaletteKind::shading), 0x1c);
}

TEST(ShadingPalette, PrimariesHave64Levels) {
  EXPECT_EQ(text(shading().at(64)), "0,0,0");
  EXPECT_EQ(text(shading().at(127)), "255,0,0");
  EXPECT_EQ(text(shading().at(191)), "0,255,0");
  EXPECT_EQ(text(shading().at(255)), "0,0,255");
  for (const std::size_t start : {64U, 128U, 192U}) {
    std::set<int> levels;
    for (std::size_t i = start; i < start + 64; ++i) {
      const Color& color = shading().at(i);
      levels.insert(color.red + color.green + color.blue);
    }
    EXPECT_EQ(levels.size(), 64U) << start;
  }
}

TEST(ShadingPalette, MixturesHaveFourLevelsOfEachComponent) {
  EXPECT_EQ(text(shading().at(0)), "0,0,0");
  EXPECT_EQ(text(shading().at(0b110000)), "255,0,0");
  EXPECT_EQ(text(shading().at(0b001100)), "0,255,0");
  EXPECT_EQ(text(shading().at(0b000011)), "0,0,255");
  EXPECT_EQ(text(shading().at(0b011000)), "85,170,0");
  EXPECT_EQ(text(shading().at(63)), "255,255,255");
  std::set<std::string> all;
  std::set<int> reds;
  for (std::size_t i = 0; i < 64; ++i) {
    all.insert(text(shading().at(i)));
    reds.insert(shading().at(i).red);
  }
  EXPECT_EQ(all.size(), 64U);
  EXPECT_EQ(reds.size(), 4U);
}

TEST(ShadingPalette, APureColorTakesItsPrimarysLevel) {
  EXPECT_EQ(index_of(Color{255, 0, 0}), 127);
  EXPECT_EQ(index_of(Color{0, 255, 0}), 191);
  EXPECT_EQ(index_of(Color{0, 0, 255}), 255);
  EXPECT_EQ(index_of(Color{0, 130, 0}), 128 + 32);
  EXPECT_EQ(index_of(Color{4, 0, 0}), 65);
  EXPECT_EQ(index_of(Color{0, 0, 3}), 192);
}

TEST(ShadingPalette, MixturesTakeTheirHighestTwoBitsAndBlackIsZero) {
  EXPECT_EQ(index_of(Color{}), 0);
  EXPECT_EQ(index_of(Color{255, 255, 255}), 63);
  EXPECT_EQ(index_of(Color{64, 128, 192}), 0b011011);
  EXPECT_EQ(index_of(Color{63, 127, 191}), 0b000110);
  EXPECT_EQ(index_of(Color{255, 1, 0}), 0b110000);
  EXPECT_EQ(index_of(Color{1, 1, 1}), 0);
}

TEST(Paints, AnIndexStaysAndAColorIsLookedUp) {
  const Paint index{.is_index = true, .index = 200, .color = {255, 0, 0}};
  const Paint color{.is_index = false, .index = 200, .color = {255, 0, 0}};
  EXPECT_EQ(pixel_of<std::uint8_t>(index, PaletteKind::vga), 200);
  EXPECT_EQ(pixel_of<std::uint8_t>(index, PaletteKind::shading), 200);
  EXPECT_EQ(pixel_of<std::uint8_t>(color, PaletteKind::vga), 40);
  EXPECT_EQ(pixel_of<std::uint8_t>(color, PaletteKind::shading), 127);
}

TEST(Paints, TrueColorShowsTheColorOfAnIndexAndColorsAsTheyAre) {
  EXPECT_EQ(pixel_of<std::uint32_t>({.is_index = true, .index = 6}, PaletteKind::vga), 0xaa5500U);
  EXPECT_EQ(pixel_of<std::uint32_t>({.is_index = true, .index = 191}, PaletteKind::shading),
            0x00ff00U);
  EXPECT_EQ(pixel_of<std::uint32_t>({.is_index = false, .color = {1, 2, 3}}, PaletteKind::shading),
            0x010203U);
}

}  // namespace
}  // namespace xsharp

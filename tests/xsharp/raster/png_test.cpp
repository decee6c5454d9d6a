#include "xsharp/files/png.hpp"

#include <rapidcheck.h>

#include "tests/support/test.hpp"
#include "tests/xsharp/raster/generators.hpp"
#include "tests/xsharp/raster/read_png.hpp"
#include "xsharp/files/png_chunks.hpp"

namespace xsharp {
namespace {

template <PixelType Pixel>
Page<Pixel> noise(std::uint32_t mask) {
  Page<Pixel> page(*generators::among(1, 40), *generators::among(1, 40));
  auto state = *rc::gen::arbitrary<std::uint32_t>();
  for (Pixel& pixel : page.pixels()) {
    state = state * 1664525U + 1013904223U;
    pixel = static_cast<Pixel>(state >> 8U & mask);
  }
  return page;
}

Palette any_palette() {
  Palette palette{};
  std::generate(palette.begin(), palette.end(), [] { return generators::paint().color; });
  return palette;
}

TEST(Png, IndexedPixelsAreReadBackInTheColorsOfThePalette) {
  EXPECT_TRUE(rc::check([] {
    const auto page = noise<std::uint8_t>(255);
    const Palette palette = any_palette();
    const auto read = read_png::by_libpng(encode_png(page, palette));
    RC_ASSERT(read.width() == page.width());
    RC_ASSERT(std::equal(page.pixels().begin(), page.pixels().end(), read.pixels().begin(),
                         read.pixels().end(), [&](std::uint8_t index, std::uint32_t color) {
                           const Color& c = palette.at(index);
                           return color == c.red * 65536U + c.green * 256U + c.blue;
                         }));
  }));
}

TEST(Png, TrueColorIsReadBackAsItIs) {
  EXPECT_TRUE(rc::check([] {
    const auto page = noise<std::uint32_t>(0xffffff);
    RC_ASSERT(read_png::by_libpng(encode_png(page)) == page);
  }));
}

TEST(Png, TheHighestByteOfTrueColorIsNotSeen) {
  Page<std::uint32_t> page(1, 1);
  page.row(0)[0] = 0xff102030;
  EXPECT_EQ(read_png::by_libpng(encode_png(page)).row(0)[0], 0x102030U);
}

TEST(Png, IndexedMeansAPaletteOf256Colors) {
  const Page<std::uint8_t> page(3, 2);
  const std::string png = encode_png(page, palette_of(PaletteKind::vga));
  const auto chunks = png_chunks(png);
  EXPECT_EQ(chunks.front().data, std::string("\0\0\0\3\0\0\0\2\10\3\0\0\0", 13));
  const auto palette = std::find_if(chunks.begin(), chunks.end(),
                                    [](const PngChunk& chunk) { return chunk.type == "PLTE"; });
  ASSERT_NE(palette, chunks.end());
  EXPECT_EQ(palette->data.size(), 768U);
}

TEST(Png, LargeNoiseKeepsEveryByte) {
  Page<std::uint32_t> page(700, 500);
  std::uint32_t state = 1;
  for (std::uint32_t& pixel : page.pixels()) {
    state = state * 1664525U + 1013904223U;
    pixel = state >> 8U;
  }
  EXPECT_EQ(read_png::by_libpng(encode_png(page)), page);
}

TEST(PngChunks, WhatIsCutOffAnywhereIsRefused) {
  const std::string png = encode_png(Page<std::uint32_t>(2, 2));
  EXPECT_EQ(png_chunks(png).back().type, "IEND");
  for (std::size_t length = 0; length < png.size(); ++length) {
    EXPECT_THROW((void)png_chunks(std::string_view(png).substr(0, length)), std::invalid_argument)
        << length;
  }
}

TEST(PngChunks, AnEndHasTheChecksumOfTheStandard) {
  EXPECT_EQ(png_chunk("IEND", {}), std::string("\0\0\0\0IEND\xae\x42\x60\x82", 12));
}

}  // namespace
}  // namespace xsharp

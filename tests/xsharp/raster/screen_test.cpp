#include "xsharp/raster/screen.hpp"

#include <rapidcheck.h>

#include "tests/support/test.hpp"
#include "tests/xsharp/raster/definition.hpp"
#include "tests/xsharp/raster/generators.hpp"
#include "xsharp/picture.hpp"
#include "xsharp/raster/fill.hpp"

namespace xsharp {
namespace {

constexpr std::int32_t width = 32;
constexpr std::int32_t height = 24;
constexpr std::uint8_t background = 5;

template <PixelType Pixel>
Pixel background_pixel(PaletteKind palette) {
  return pixel_of<Pixel>({.is_index = true, .index = background}, palette);
}

template <PixelType Pixel>
void draw(Page<Pixel>& page, const Picture& picture, PaletteKind palette) {
  Filler filler;
  for (const Polygon& polygon : picture.polygons) {
    filler.fill(page, picture.points_of(polygon), pixel_of<Pixel>(polygon.paint, palette));
  }
}

template <PixelType Pixel>
Page<Pixel> alone(const Picture& picture, PaletteKind palette) {
  Page<Pixel> page(width, height);
  page.clear(background_pixel<Pixel>(palette));
  draw(page, picture, palette);
  return page;
}

std::vector<Picture> film() {
  std::vector<Picture> pictures(*generators::among<std::size_t>(1, 8));
  for (Picture& picture : pictures) picture = generators::picture();
  return pictures;
}

/// Whether some picture would come out wrong without erasing.
template <PixelType Pixel>
bool needs_erasing(const std::vector<Picture>& pictures, PaletteKind palette) {
  std::array pages{alone<Pixel>({}, palette), alone<Pixel>({}, palette)};
  std::size_t shown = 0;
  bool wrong = false;
  for (const Picture& picture : pictures) {
    shown = 1 - shown;
    draw(pages.at(shown), picture, palette);
    wrong = wrong || pages.at(shown) != alone<Pixel>(picture, palette);
  }
  return wrong;
}

template <PixelType Pixel>
void every_picture_is_as_if_alone() {
  int telling = 0;
  EXPECT_TRUE(rc::check([&] {
    const auto palette = *rc::gen::element(PaletteKind::vga, PaletteKind::shading);
    const std::vector<Picture> pictures = film();
    Screen<Pixel> screen(width, height, palette, background);
    for (const Picture& picture : pictures) {
      screen.show(picture);
      RC_ASSERT(screen.page() == alone<Pixel>(picture, palette));
    }
    telling += needs_erasing<Pixel>(pictures, palette) ? 1 : 0;
  }));
  EXPECT_GT(telling, 20);
}

TEST(Screen, EveryPictureIsAsIfOnAnEmptyPage) { every_picture_is_as_if_alone<std::uint8_t>(); }

TEST(Screen, EveryPictureIsAsIfOnAnEmptyPageInTrueColor) {
  every_picture_is_as_if_alone<std::uint32_t>();
}

/// A row of 4 x 4 squares, one per object.
Picture squares(const std::vector<std::uint32_t>& objects, std::int32_t x, std::int32_t y) {
  Picture picture;
  for (const std::uint32_t object : objects) {
    picture.polygons.push_back({.object = object,
                                .first = static_cast<std::uint32_t>(picture.points.size()),
                                .points = 4,
                                .paint = {.is_index = true, .index = 15}});
    for (const auto& [right, down] : {std::array{0, 0}, {4, 0}, {4, 4}, {0, 4}}) {
      picture.points.push_back({x + right, y + down});
    }
    x += 8;
  }
  return picture;
}

TEST(Screen, ObjectsComeAndGo) {
  Screen<std::uint8_t> screen(width, height, PaletteKind::vga, background);
  for (const auto& objects : std::vector<std::vector<std::uint32_t>>{
           {0}, {0, 1, 2}, {}, {2}, {0, 1, 2, 3}, {7, 0}, {}, {}, {4000000000U}, {}, {1}}) {
    const Picture picture = squares(objects, 1, 2);
    screen.show(picture);
    EXPECT_EQ(screen.page(), alone<std::uint8_t>(picture, PaletteKind::vga));
  }
}

TEST(Screen, CountsWhatWasDrawnAndErased) {
  Screen<std::uint8_t> screen(width, height, PaletteKind::vga, background);
  screen.show(squares({0, 1}, 1, 2));
  EXPECT_EQ(screen.count().polygons, 2);
  EXPECT_EQ(screen.count().pixels, 32);
  screen.show(squares({0, 1}, 1, 2));
  EXPECT_EQ(screen.count().erased_pixels, 0);  // the other page was empty
  screen.show(squares({0}, -2, -1));
  EXPECT_EQ(screen.count().polygons, 5);
  EXPECT_EQ(screen.count().pixels, 32 + 32 + 2 * 3);
  EXPECT_EQ(screen.count().erased_pixels, 32);
  screen.show({});
  screen.show({});
  EXPECT_EQ(screen.count().erased_pixels, 32 + 32 + 2 * 3);
}

TEST(Screen, AnObjectIsErasedAsOneRectangle) {
  Screen<std::uint8_t> screen(width, height, PaletteKind::vga, background);
  screen.show(squares({3, 3}, 1, 2));
  screen.show({});
  screen.show({});
  EXPECT_EQ(screen.count().erased_pixels, 12 * 4);
}

TEST(Screen, BothPagesBeginEmpty) {
  Screen<std::uint32_t> screen(width, height, PaletteKind::vga, 40);
  Page<std::uint32_t> red(width, height);
  red.clear(0xff0000);
  EXPECT_EQ(screen.page(), red);
  screen.show({});
  EXPECT_EQ(screen.page(), red);
}

TEST(Screen, PolygonsWithoutTheirPointsAreRefusedAndNothingIsDrawn) {
  for (const auto& [first, points] :
       {std::array{0U, 5U}, {5U, 0U}, {3U, 2U}, {4294967295U, 2U}, {2U, 4294967295U}}) {
    Picture picture = squares({0}, 1, 2);
    picture.polygons.push_back({.object = 1, .first = first, .points = points});
    Screen<std::uint8_t> screen(width, height, PaletteKind::vga, background);
    EXPECT_THROW(screen.show(picture), std::out_of_range) << first << ' ' << points;
    EXPECT_EQ(screen.count().polygons, 0);
    EXPECT_EQ(screen.page(), alone<std::uint8_t>({}, PaletteKind::vga));
    screen.show({});
    EXPECT_EQ(screen.page(), alone<std::uint8_t>({}, PaletteKind::vga));
  }
}

}  // namespace
}  // namespace xsharp

#include "xsharp/raster/page.hpp"

#include "tests/support/test.hpp"

namespace xsharp {
namespace {

TEST(PixelPage, BeginsWithAllPixelsZero) {
  const Page<std::uint32_t> page(3, 2);
  EXPECT_EQ(page.pixels().size(), 6U);
  EXPECT_TRUE(std::all_of(page.pixels().begin(), page.pixels().end(),
                          [](std::uint32_t pixel) { return pixel == 0; }));
}

TEST(PixelPage, RowsFollowOneAnotherFromTheTop) {
  Page<std::uint8_t> page(3, 2);
  page.row(0)[2] = 7;
  page.row(1)[0] = 8;
  EXPECT_EQ(page.pixels()[2], 7);
  EXPECT_EQ(page.pixels()[3], 8);
  EXPECT_EQ(std::as_const(page).row(1).size(), 3U);
  EXPECT_EQ(std::as_const(page).row(1)[0], 8);
}

TEST(PixelPage, ClearingSetsEveryPixel) {
  Page<std::uint8_t> page(5, 4);
  page.row(2)[2] = 9;
  page.clear(3);
  EXPECT_EQ(std::count(page.pixels().begin(), page.pixels().end(), 3), 20);
}

TEST(PixelPage, TheSmallestAndTheLongestSidesCanBe) {
  EXPECT_EQ(Page<std::uint8_t>(1, 1).pixels().size(), 1U);
  EXPECT_EQ(Page<std::uint8_t>(16384, 1).width(), 16384);
  EXPECT_EQ(Page<std::uint32_t>(1, 16384).height(), 16384);
}

TEST(PixelPage, OtherSidesAreRefusedByName) {
  for (const auto& [width, height] :
       {std::pair{0, 240}, {320, 0}, {-1, 5}, {16385, 1}, {1, 16385}, {INT32_MIN, INT32_MAX}}) {
    try {
      const Page<std::uint8_t> page(width, height);
      ADD_FAILURE() << width << " x " << height << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(
          std::string(error.what()).find(std::to_string(width) + " x " + std::to_string(height)),
          std::string::npos)
          << error.what();
    }
  }
}

TEST(PixelPage, RowsOutsideAreRefused) {
  Page<std::uint8_t> page(4, 3);
  EXPECT_THROW((void)page.row(-1), std::out_of_range);
  EXPECT_THROW((void)page.row(3), std::out_of_range);
  EXPECT_THROW((void)std::as_const(page).row(3), std::out_of_range);
}

}  // namespace
}  // namespace xsharp

#include "xsharp/raster/fill.hpp"

#include <rapidcheck.h>

#include "tests/support/test.hpp"
#include "tests/xsharp/raster/definition.hpp"
#include "tests/xsharp/raster/generators.hpp"
#include "xsharp/raster/page.hpp"

namespace xsharp {
namespace {

using definition::Points;
using Mask = Page<std::uint8_t>;

constexpr std::int32_t lowest = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t highest = std::numeric_limits<std::int32_t>::max();

Mask filled(const Points& points, std::int32_t width, std::int32_t height) {
  Mask page(width, height);
  Filler filler;
  const std::int64_t pixels = filler.fill<std::uint8_t>(page, points, 1);
  EXPECT_EQ(pixels, std::count(page.pixels().begin(), page.pixels().end(), 1));
  return page;
}

Mask defined(const std::function<bool(std::int32_t, std::int32_t)>& belongs, std::int32_t width,
             std::int32_t height) {
  Mask page(width, height);
  for (std::int32_t y = 0; y < height; ++y) {
    for (std::int32_t x = 0; x < width; ++x) {
      page.row(y)[static_cast<std::size_t>(x)] = belongs(x, y) ? 1 : 0;
    }
  }
  return page;
}

/// One line per row, with '#' for each set pixel.
std::string drawing(const Mask& page) {
  std::string text;
  for (std::int32_t y = 0; y < page.height(); ++y) {
    for (const std::uint8_t pixel : page.row(y)) text += pixel == 0 ? '.' : '#';
    text += '\n';
  }
  return text;
}

TEST(Fill, LeftAndTopBelongToAPolygonRightAndBottomDoNot) {
  EXPECT_EQ(drawing(filled({{1, 1}, {4, 1}, {4, 3}, {1, 3}}, 6, 4)),
            "......\n"
            ".###..\n"
            ".###..\n"
            "......\n");
}

TEST(Fill, APixelOnASlantedLeftEdgeBelongsAndOnARightEdgeDoesNot) {
  // At row y the left edge is at 3 - y and the right edge at 3 + y.
  EXPECT_EQ(drawing(filled({{3, 0}, {6, 3}, {0, 3}}, 7, 4)),
            ".......\n"
            "..##...\n"
            ".####..\n"
            ".......\n");
}

TEST(Fill, CrossingsBetweenPixelsAreRoundedUp) {
  // The left edge is at 0, 1/3, 2/3; the right edge at 3, 3 1/3, 3 2/3.
  EXPECT_EQ(drawing(filled({{0, 0}, {3, 0}, {4, 3}, {1, 3}}, 6, 3)),
            "###...\n"
            ".###..\n"
            ".###..\n");
}

TEST(Fill, ConvexPolygonsHaveThePixelsInsideTheirEdges) {
  EXPECT_TRUE(rc::check([] {
    const auto polygon = generators::convex(generators::small());
    const auto belongs = [&](auto x, auto y) { return definition::belongs(polygon.corners, x, y); };
    RC_ASSERT(drawing(filled(polygon.points, 32, 24)) == drawing(defined(belongs, 32, 24)));
  }));
}

TEST(Fill, HoldsForCoordinatesOfAnySize) {
  EXPECT_TRUE(rc::check([] {
    const auto polygon = generators::convex(generators::extreme());
    const auto belongs = [&](auto x, auto y) { return definition::belongs(polygon.corners, x, y); };
    RC_ASSERT(drawing(filled(polygon.points, 16, 12)) == drawing(defined(belongs, 16, 12)));
  }));
}

TEST(Fill, PointsInAnyOrderAreFilledBetweenTheTwoLists) {
  EXPECT_TRUE(rc::check([] {
    const bool near = *rc::gen::arbitrary<bool>();
    const Points points =
        generators::some(near ? generators::small() : generators::extreme(), 0, 8);
    const auto belongs = [&](auto x, auto y) { return definition::in_lists(points, x, y); };
    RC_ASSERT(drawing(filled(points, 24, 18)) == drawing(defined(belongs, 24, 18)));
  }));
}

// By hand: the left chain starts with the edge (0, 0) to (0, 2), which yields 0, 0. After a rising
// edge, (2, 1) to (0, 4) yields 2, 2, 1 for rows 1, 2 and 3. The filler draws these in rows 2, 3
// and none.
TEST(Fill, WhatFollowsARisingEdgeMovesUp) {
  EXPECT_EQ(drawing(filled({{0, 0}, {6, 0}, {6, 4}, {0, 4}, {2, 1}, {0, 2}}, 7, 5)),
            "######.\n"
            "######.\n"
            "..####.\n"
            "..####.\n"
            ".......\n");
}

// By hand: the left chain goes by (2, 2) to (6, 6) with 3, 2, 3 in rows 1 to 3, and the right one
// by (4, 2) to (0, 6) with 3, 3, 2. From row 3 on nothing is drawn.
TEST(Fill, WhereTheChainsHaveCrossedThereIsNothing) {
  EXPECT_EQ(drawing(filled({{3, 0}, {4, 2}, {0, 6}, {6, 6}, {2, 2}}, 7, 7)),
            ".......\n"
            "...#...\n"
            "..##...\n"
            ".......\n"
            ".......\n"
            ".......\n"
            ".......\n");
}

TEST(Fill, TheWholeRangeOfCoordinatesCoversAPage) {
  const Mask page =
      filled({{lowest, lowest}, {highest, lowest}, {highest, highest}, {lowest, highest}}, 9, 5);
  EXPECT_EQ(std::count(page.pixels().begin(), page.pixels().end(), 1), 45);
}

TEST(Fill, TheLongestDiagonalIsExact) {
  // On the line from (lowest, lowest) to (highest, highest), x equals y.
  EXPECT_EQ(drawing(filled({{lowest, lowest}, {highest, highest}, {lowest, highest}}, 4, 4)),
            "....\n"
            "#...\n"
            "##..\n"
            "###.\n");
  // On the line from (lowest, highest) to (highest, lowest), x is -1 - y; the whole page is right
  // of it.
  EXPECT_EQ(drawing(filled({{highest, lowest}, {highest, highest}, {lowest, highest}}, 2, 2)),
            "##\n##\n");
}

TEST(Fill, WithoutAreaThereAreNoPixels) {
  for (const Points& points : {Points{},
                               {{2, 2}},
                               {{0, 0}, {5, 5}},
                               {{3, 1}, {3, 1}, {3, 1}},
                               {{0, 0}, {2, 1}, {4, 2}},
                               {{0, 2}, {3, 2}, {5, 2}},
                               {{2, 0}, {2, 3}, {2, 5}},
                               {{0, 0}, {4, 4}, {4, 4}, {0, 0}},
                               {{lowest, lowest}, {0, 0}, {2, 2}, {1, 1}}}) {
    EXPECT_EQ(filled(points, 6, 6), Mask(6, 6)) << points.size();
  }
}

TEST(Fill, PiecesHaveEveryPixelOfTheWholeExactlyOnce) {
  EXPECT_TRUE(rc::check([] {
    const bool near = *rc::gen::arbitrary<bool>();
    const auto polygon = generators::convex(near ? generators::small() : generators::extreme());
    const Points& points = polygon.points;
    const Mask whole = filled(points, 32, 24);
    Mask times(32, 24);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const Mask piece = filled({points[0], points[i], points[i + 1]}, 32, 24);
      std::transform(times.pixels().begin(), times.pixels().end(), piece.pixels().begin(),
                     times.pixels().begin(),
                     [](auto a, auto b) { return static_cast<std::uint8_t>(a + b); });
    }
    RC_ASSERT(times == whole);
  }));
}

TEST(Fill, ClippingIsCuttingOutOfALargerPage) {
  EXPECT_TRUE(rc::check([] {
    constexpr std::int32_t margin = 40;
    const auto polygon = generators::convex(generators::among(-margin, 30 + margin));
    Points moved = polygon.points;
    for (ScreenPoint& point : moved) point = {point.x + margin, point.y + margin};
    const Mask page = filled(polygon.points, 30, 20);
    const Mask larger = filled(moved, 30 + 2 * margin, 20 + 3 * margin);
    const auto cut = [&](auto x, auto y) {
      return larger.row(y + margin)[static_cast<std::size_t>(x + margin)] != 0;
    };
    RC_ASSERT(drawing(page) == drawing(defined(cut, 30, 20)));
  }));
}

TEST(Fill, AFillerRemembersNothingOfTheLastPolygon) {
  EXPECT_TRUE(rc::check([] {
    Filler filler;
    Mask once(32, 24);
    Mask page(32, 24);
    filler.fill<std::uint8_t>(once, generators::convex(generators::small()).points, 1);
    const Points points = generators::convex(generators::small()).points;
    filler.fill<std::uint8_t>(page, points, 1);
    RC_ASSERT(page == filled(points, 32, 24));
  }));
}

TEST(Fill, SetsThePixelThatWasAskedFor) {
  Page<std::uint32_t> page(2, 1);
  page.clear(0x010203);
  EXPECT_EQ(Filler().fill<std::uint32_t>(page, Points{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0xa0b0c0),
            1);
  EXPECT_EQ(page.row(0)[0], 0xa0b0c0U);
  EXPECT_EQ(page.row(0)[1], 0x010203U);
}

}  // namespace
}  // namespace xsharp

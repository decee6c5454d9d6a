// Tests the comment on the projection ratio against the code.
#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"
#include "xsharp/project.hpp"

namespace {

TEST(Defects, HalfTheWidth) {
  using N = fixproof::q16_16_i386;
  const xsharp::Scene scene;  // 320 pixels wide, a ratio of -2
  const auto projection = xsharp::projection_of<N>(scene);
  const auto from_middle = [&projection](std::int32_t x) {
    const auto pixel = xsharp::project(xsharp::Vec3<N>{N(x), N(0), N(-100)}, projection);
    return pixel ? pixel->x - projection.center_x : -1;
  };
  constexpr std::int32_t edge = 160;
  // Distance / half the width is 2: the edge is at x = distance / 2.
  EXPECT_EQ(from_middle(50), edge);
  // Distance / width would be 2 if the edge were at x = distance / 4.
  EXPECT_EQ(from_middle(25), edge / 2);
  // The published constant: half the width, one unit too high.
  EXPECT_EQ(projection.constant.raw(), -320 * 65536 + 1);
}

}  // namespace

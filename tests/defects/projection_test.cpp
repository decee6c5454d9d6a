// What the comment on the projection ratio says, and what the code does.
#include <gtest/gtest.h>

#include <cmath>

#include "fixed/fixed.hpp"
#include "xsharp/project.hpp"

namespace {

TEST(Defects, HalfTheWidth) {
  using N = fixed::q16_16_i386;
  const xsharp::Scene scene;  // 320 pixels wide, a ratio of -2
  const auto projection = xsharp::projection_of<N>(scene);
  const auto from_middle = [&projection](std::int32_t x) {
    const auto pixel = xsharp::project(xsharp::Vec3<N>{N(x), N(0), N(-100)}, projection);
    return pixel ? pixel->x - projection.center_x : -1;
  };
  constexpr std::int32_t edge = 160;
  // Distance over half the width is 2: the edge is where x is half of the distance.
  EXPECT_EQ(from_middle(50), edge);
  // Distance over width would be 2: the edge would be where x is a quarter of the distance.
  EXPECT_EQ(from_middle(25), edge / 2);
  // The constant as published: half the width, and a unit too high.
  EXPECT_EQ(projection.constant.raw(), -320 * 65536 + 1);
}

}  // namespace

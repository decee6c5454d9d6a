// Tests vertex normals and unit vectors that use only products.
#include "xsharp/normals.hpp"

#include "tests/support/test.hpp"
#include "tests/xsharp/pipeline/types.hpp"
#include "xsharp/shapes.hpp"

namespace pipeline {
namespace {

using namespace xsharp;

// By symmetry, normals follow the diagonal at a cube's corner and the axis at a ball's poles.
TEST(CornerNormals, OfACubeAndOfABall) {
  const Mesh cubic = with_vertex_normals(cube(10));
  ASSERT_EQ(cubic.vertices.size(), 16U);
  for (std::size_t v = 0; v < 8; ++v) {
    const Triple normal =
        difference(cubic.vertices[cubic.vertex_normal_ends[v]], cubic.vertices[v]);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(normal[i], cubic.vertices[v][i] / std::sqrt(300), 1e-12);
    }
  }
  const Mesh round = with_vertex_normals(ball(50, 6));
  const Triple pole = difference(round.vertices[round.vertex_normal_ends[0]], round.vertices[0]);
  EXPECT_NEAR(length(difference(pole, {0, 1, 0})), 0, 1e-12);
}

TEST(CornerNormals, ThatCancelOutAreNone) {
  Mesh two_sided{{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}, {{{0, 1, 2}}, {{2, 1, 0}}}};
  two_sided = with_vertex_normals(two_sided);
  EXPECT_EQ(two_sided.vertices[two_sided.vertex_normal_ends[1]], two_sided.vertices[1]);
}

template <class N>
class UnitVectors : public testing::Test {};
TYPED_TEST_SUITE(UnitVectors, all_types);

TYPED_TEST(UnitVectors, HaveLengthOne) {
  using N = TypeParam;
  for (const double size : {0.5, 0.7, 0.93, 1.0, 1.1, 1.5}) {
    for (const Triple& direction :
         {Triple{1, 0, 0}, Triple{-0.6, 0.8, 0}, Triple{0.48, -0.6, -0.64}}) {
      const Triple is = triple(unit(vector<N>(scaled(direction, size))));
      // The iteration stops at four ulp in the square, and the last products round.
      EXPECT_NEAR(length(is), 1, 8 * ulp) << size;
      EXPECT_NEAR(length(difference(is, direction)), 0, 24 * ulp) << size;
    }
  }
  const Vec3<N> none{number<N>(0), number<N>(0), number<N>(0)};
  EXPECT_EQ(unit(none), none);
}

}  // namespace
}  // namespace pipeline

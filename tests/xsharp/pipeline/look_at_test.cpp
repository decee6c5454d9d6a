/// Tests orientations that face a point: on their own, of moving objects and of the camera.
#include "xsharp/look_at.hpp"

#include "tests/support/test.hpp"
#include "tests/xsharp/pipeline/draws.hpp"
#include "tests/xsharp/pipeline/matrix.hpp"
#include "tests/xsharp/pipeline/types.hpp"
#include "xsharp/motion.hpp"
#include "xsharp/view.hpp"

namespace xsharp {
namespace {

using draws::Integers;
using pipeline::ulp;

constexpr RotationStyle to_nearest{.conversion = Conversion::nearest};

/// The rotation in long double, from its definition: the columns are x, y and z.
pipeline::Matrix expected(const Triple& toward) {
  using Long = std::array<long double, 3>;
  const auto unit = [](Long v) {
    const long double size = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (long double& part : v) part /= size;
    return v;
  };
  const auto back = [&toward](std::size_t i) { return -static_cast<long double>(toward[i]); };
  const Long z = unit({back(0), back(1), back(2)});
  const Long x = z[0] == 0 && z[2] == 0 ? Long{1, 0, 0} : unit({z[2], 0, -z[0]});
  const Long y{z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]};
  return {{{x[0], y[0], z[0]}, {x[1], y[1], z[1]}, {x[2], y[2], z[2]}}};
}

template <class N>
pipeline::Matrix rotation_of(const Triple& toward) {
  const auto rotation = look_at_rotation<N>(toward);
  Transform<N> t;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) t.rows[i][j] = rotation[i][j];
  }
  return pipeline::matrix_of(t);
}

/// The Frobenius norm of the error. Components of x and z are within 5 ulp at worst, with the
/// 8088's truncated products; those of y come from two products of them.
template <class N>
double allowed() {
  return std::same_as<N, double> ? 1e-14 : 24 * ulp;
}

template <class N>
struct LookAt : testing::Test {};
TYPED_TEST_SUITE(LookAt, pipeline::all_types, );

TYPED_TEST(LookAt, IsTheDefinition) {
  using N = TypeParam;
  EXPECT_TRUE(draws::hold_for_raws(4, [](const Integers& raws) {
    // From 2^-40 to 2^34 units long.
    const double scale = std::ldexp(1, static_cast<int>(raws[3] % 20) - 16);
    const Triple toward{static_cast<double>(raws[0]) * scale, static_cast<double>(raws[1]) * scale,
                        static_cast<double>(raws[2]) * scale};
    if (toward == Triple{}) return true;
    return pipeline::distance(rotation_of<N>(toward), expected(toward)) < allowed<N>();
  }));
}

// Forward is the identity. To the right is a quarter turn clockwise, seen from above.
TYPED_TEST(LookAt, TheSixDirections) {
  using N = TypeParam;
  const std::vector<std::pair<Triple, pipeline::Matrix>> table{
      {{0, 0, -5}, pipeline::unit_matrix},
      {{0, 0, 5}, {{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}},
      {{5, 0, 0}, {{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}}},
      {{-5, 0, 0}, {{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}}},
      {{0, 5, 0}, {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}}},
      {{0, -5, 0}, {{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}}}};
  for (const auto& [toward, matrix] : table) {
    EXPECT_LT(pipeline::distance(rotation_of<N>(toward), matrix), allowed<N>());
    EXPECT_LT(pipeline::distance(expected(toward), matrix), 1e-15);
  }
}

// Almost straight up, the level part of the rounded unit vector has few bits or none.
TYPED_TEST(LookAt, AlmostStraightUpTheXAxisIsStillExact) {
  using N = TypeParam;
  const Triple toward{ulp, 16000, -2 * ulp};
  EXPECT_LT(pipeline::distance(rotation_of<N>(toward), expected(toward)), allowed<N>());
}

/// Whether the -z axis of a motion points from its place at a point.
template <class N>
bool faces(const Motion<N>& motion, const Triple& point) {
  Triple place{};
  for (std::size_t i = 0; i < 3; ++i) {
    place[i] = motion.page()[i] * static_cast<double>(page_size) +
               static_cast<double>(motion.to_world().rows[i][3]);
  }
  return pipeline::distance(pipeline::matrix_of(motion.to_world()),
                            expected(difference(point, place))) < allowed<N>();
}

TYPED_TEST(LookAt, AnObjectFacesItsPointFromTheFirstFrameOn) {
  ObjectDescription object;
  object.orbit = Orbit{{0, 0, -400}, 100, 300, 70, 200};
  object.look_at = Triple{10.5, 20, -390};
  Motion<TypeParam> motion(object, to_nearest);
  for (int frame = 0; frame < 60; ++frame) {
    EXPECT_TRUE(faces(motion, *object.look_at)) << frame;
    EXPECT_TRUE(motion.advance());
  }
}

// The point stays on the page where the object begins.
TYPED_TEST(LookAt, AnObjectFacesItsPointFromOtherPages) {
  ObjectDescription object;
  object.page = {3, -2, 1000000};
  object.position = {16000, 0, -16000};
  object.drift = Drift{.step = {700.5, -300.25, 1200}};
  object.look_at = Triple{100, 16384, -16384};
  const Triple point{100 + 3 * 16384.0, 16384 - 2 * 16384.0, -16384 + 1000000 * 16384.0};
  Motion<TypeParam> motion(object, to_nearest);
  for (int frame = 0; frame < 200; ++frame) {
    EXPECT_TRUE(faces(motion, point)) << frame;
    motion.advance();
  }
  EXPECT_GT(motion.page()[0], 9);
}

TYPED_TEST(LookAt, AtItsPointAnObjectKeepsItsOrientation) {
  ObjectDescription object;
  object.position = {-2, 0, 0};
  object.drift = Drift{.step = {1, 0, 0}};
  object.look_at = Triple{0, 0, 0};
  Motion<TypeParam> motion(object, to_nearest);
  motion.advance();
  const auto before = motion.to_world().row(0);
  motion.advance();
  EXPECT_EQ(motion.to_world().row(0), before);
  motion.advance();
  EXPECT_NE(motion.to_world().row(0), before);
  EXPECT_TRUE(faces(motion, {0, 0, 0}));
}

TYPED_TEST(LookAt, AnObjectAtRestDoesNotChange) {
  ObjectDescription object;
  object.position = {5, 6, -700};
  object.look_at = Triple{};
  Motion<TypeParam> motion(object, to_nearest);
  EXPECT_TRUE(faces(motion, {}));
  EXPECT_FALSE(motion.advance());
}

// The point that the camera looks at is in the middle of the picture and at its own distance, and
// up is up.
TYPED_TEST(LookAt, TheCameraSeesItsPointInTheMiddle) {
  using N = TypeParam;
  Scene scene;
  scene.camera.position = {70.5, 90.25, 20.75};
  scene.camera.look_at = Triple{-10, 0, -240};
  const View<N> view = view_of<N>(scene);
  const Triple middle = pipeline::triple(
      Arithmetic<N>::apply(view.world_to_view, pipeline::vector<N>({-10, 0, -240})));
  // Nine products of up to 300 with components that are half an ulp off.
  const double near = std::same_as<N, double> ? 1e-10 : 600 * ulp;
  EXPECT_NEAR(middle[0], 0, near);
  EXPECT_NEAR(middle[1], 0, near);
  EXPECT_NEAR(middle[2], -length({80.5, 90.25, 260.75}), near);
  const Triple above = pipeline::triple(
      Arithmetic<N>::apply(view.world_to_view, pipeline::vector<N>({-10, 50, -240})));
  EXPECT_NEAR(above[0], 0, near);
  EXPECT_GT(above[1], 40);
}

}  // namespace
}  // namespace xsharp

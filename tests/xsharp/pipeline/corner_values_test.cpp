// Tests the values at polygon corners against values computed by hand. All fillers start from them.
#include "tests/support/test.hpp"
#include "tests/xsharp/pipeline/types.hpp"
#include "xsharp/animation.hpp"
#include "xsharp/normals.hpp"
#include "xsharp/shade.hpp"
#include "xsharp/shapes.hpp"
#include "xsharp/surface_values.hpp"

namespace pipeline {
namespace {

using namespace xsharp;

/// The centres of the first and last of a bitmap's 256 texels.
constexpr double first_texel = 0.5 / 256;
constexpr double last_texel = 255.5 / 256;

Surface surface_of(SurfaceKind kind, std::int32_t ramp = 0) {
  Surface surface;
  surface.kind = kind;
  surface.ramp = ramp;
  return surface;
}

template <class N>
class CornerValues : public testing::Test {};
TYPED_TEST_SUITE(CornerValues, scene_types);

TYPED_TEST(CornerValues, OfDepthAndDistance) {
  using N = TypeParam;
  const N near = number<N>(100);
  EXPECT_EQ(static_cast<double>(depth_value(vector<N>({5, 5, -100}), near)), nearest_depth);
  EXPECT_EQ(static_cast<double>(depth_value(vector<N>({5, 5, -1}), near)), nearest_depth);
  // The depth is a quarter of the range, plus the errors of divide and multiply.
  EXPECT_NEAR(static_cast<double>(depth_value(vector<N>({7, 9, -400}), near)), 32767 / 4.0, 1);
  EXPECT_GT(depth_value(vector<N>({0, 0, -30000}), near), number<N>(0));
  // The vector (3, 4, 12) has length 13.
  for (const double scale : {1.0, 20.0, 2000.0}) {
    const double is =
        static_cast<double>(distance_from_viewer(vector<N>({-3 * scale, 4 * scale, -12 * scale})));
    EXPECT_NEAR(is / (13 * scale), 1, 16 * ulp) << scale;
  }
}

TYPED_TEST(CornerValues, OfLightStayOnTheRamp) {
  using N = TypeParam;
  const Surface surface = surface_of(SurfaceKind::gouraud16, 1);
  const Corner<N> corner{vector<N>({0, 0, -200}), vector<N>({0, 0, 1})};
  const auto light = [&](double z) {
    return point_values(surface, corner, vector<N>({0, 0, z}), number<N>(100))[1];
  };
  EXPECT_EQ(light(1), 128 + 64 + 62);
  EXPECT_EQ(light(0), 128 + 64);
  EXPECT_EQ(light(-1), 128 + 64 - 62);
  EXPECT_EQ(light(1.5), 128 + 64 + 62);
  EXPECT_EQ(light(-0.5), 128 + 64 - 31);
}

// The sum is (0.5, -0.25, 0.75) / 2 + (-0.25, 0.5, 0.25) / 4; the third spot is off.
TYPED_TEST(CornerValues, OfLightAreFromTheSumOfTheSpotsThatAreOn) {
  using N = TypeParam;
  Lighting<N> lighting;
  lighting.rays = {{true, vector<N>({0.5, -0.25, 0.75}), {}, number<N>(0.5)},
                   {true, vector<N>({-0.25, 0.5, 0.25}), {}, number<N>(0.25)},
                   {false, vector<N>({1, 1, 1}), {}, number<N>(1)}};
  EXPECT_EQ(triple(light_vector(lighting)), (Triple{0.1875, 0, 0.4375}));
}

// Light that travels away from the viewer comes from +z and lights the faces toward the viewer.
// Light that travels to the right comes from the left. A camera turned right by 90 degrees maps
// world (x, y, z) to view (z, y, -x): it has the first light on its right and the second behind it.
TYPED_TEST(CornerValues, OfLightAreFromWhereItComes) {
  using N = TypeParam;
  const Lights lights{true,
                      {},
                      {{true, {0, 0, -2}, {1, 0.5, 0}},
                       {true, {3, 0, 0}, {0.25, 0.25, 0.25}},
                       {false, {0, 1, 0}, {1, 1, 1}}}};
  const auto seen = [&](const std::array<Triple, 3>& turn) {
    Transform<N> to_view;
    for (std::size_t i = 0; i < 3; ++i) to_view.set_row(i, vector<N>(turn[i]));
    return triple(light_vector(lighting_of<N>(lights, Conversion::nearest, to_view)));
  };
  EXPECT_EQ(seen({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}), (Triple{-0.25, 0, 0.5}));
  EXPECT_EQ(seen({{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}}), (Triple{0.5, 0, 0.25}));
}

TEST(CornerDepth, ZItselfIsAboveMinusInfinity) {
  using N = fixproof::q16_16_trapping;
  const auto depth = [](double z) { return static_cast<double>(z_depth(vector<N>({5, 5, z}))); };
  EXPECT_EQ(depth(-1), 32767);
  EXPECT_EQ(depth(-100.5), 32667.5);
  EXPECT_EQ(depth(-32768), 0);
}

// With z at four times `near`, the depth is a quarter of 32767. Every quotient and product needs
// fewer than 16 fraction bits, so no build rounds.
TYPED_TEST(CornerValues, OfEachKind) {
  using N = TypeParam;
  const Corner<N> corner{vector<N>({0, 0, -256}), vector<N>({0.5, 0.25, -0.5})};
  const auto values = [&](SurfaceKind kind, std::int32_t ramp = 0) {
    return point_values(surface_of(kind, ramp), corner, vector<N>({0.25, 0.5, 0.75}),
                        number<N>(64));
  };
  constexpr double depth = 32767 / 4.0;
  EXPECT_EQ(values(SurfaceKind::flat), (PointValues{depth, 0, 0, 0}));
  // The light is 0.125 + 0.125 - 0.375 = -1/8: 64 - 62/8, plus 128 on the second ramp.
  EXPECT_EQ(values(SurfaceKind::gouraud8), (PointValues{depth, 56.25, 0, 0}));
  EXPECT_EQ(values(SurfaceKind::gouraud16), (PointValues{depth, 56.25, 0, 0}));
  EXPECT_EQ(values(SurfaceKind::gouraud16, 1), (PointValues{depth, 184.25, 0, 0}));
  // The value is 64 + 62/4.
  EXPECT_EQ(values(SurfaceKind::depth), (PointValues{depth, 79.5, 0, 0}));
  // Phong and texture pass the normal or the bitmap place through unchanged.
  EXPECT_EQ(values(SurfaceKind::phong), (PointValues{depth, 0.5, 0.25, -0.5}));
  EXPECT_EQ(values(SurfaceKind::texture), (PointValues{depth, 0.5, 0.25, -0.5}));
}

// (-60, 80, -240) has the distance 260, four times 65. Its z alone would give 0.271.
TYPED_TEST(CornerValues, OfDistanceAsLight) {
  using N = TypeParam;
  const Corner<N> corner{vector<N>({-60, 80, -240}), {}};
  const PointValues values =
      point_values(surface_of(SurfaceKind::distance), corner, {}, number<N>(65));
  // unit() is off by up to 16 ulp, the value takes a quarter of that, and the quotient rounds.
  EXPECT_NEAR(values[1], 79.5, 62 * 6 * ulp);
}

// A normal to the right maps to the right of the bitmap, and an upward normal to its top.
TYPED_TEST(CornerValues, OfWhatIsRoundAbout) {
  using N = TypeParam;
  const auto place = [](const Triple& normal) {
    const Corner<N> corner{vector<N>({0, 0, -256}), vector<N>(normal)};
    const PointValues values =
        point_values(surface_of(SurfaceKind::environment), corner, {}, number<N>(64));
    return std::array{values[1], values[2]};
  };
  EXPECT_EQ(place({0, 0, 1}), (std::array{0.5, 0.5}));
  EXPECT_EQ(place({1, 0, 0}), (std::array{last_texel, 0.5}));
  EXPECT_EQ(place({-1, 0, 0}), (std::array{first_texel, 0.5}));
  EXPECT_EQ(place({0, 1, 0}), (std::array{0.5, first_texel}));
  EXPECT_EQ(place({0, -1, 0}), (std::array{0.5, last_texel}));
}

// Faces and their bitmap places both run clockwise (rows go down), so nothing is mirrored.
TEST(BitmapPlace, OfAQuadrilateralIsACornerOfTheBitmap) {
  EXPECT_EQ(bitmap_place(0, 4), (Triple{first_texel, first_texel, 0}));
  EXPECT_EQ(bitmap_place(1, 4), (Triple{last_texel, first_texel, 0}));
  EXPECT_EQ(bitmap_place(2, 4), (Triple{last_texel, last_texel, 0}));
  EXPECT_EQ(bitmap_place(3, 4), (Triple{first_texel, last_texel, 0}));
}

TEST(BitmapPlace, OfAnotherFaceIsOnACircleFromTheTopOn) {
  for (const std::size_t corners : {3U, 5U, 16U}) {
    const Triple top = bitmap_place(0, corners);
    EXPECT_NEAR(top[0], 0.5, 1e-12);
    EXPECT_NEAR(top[1], first_texel, 1e-12);
    EXPECT_GT(bitmap_place(1, corners)[0], 0.5) << "clockwise";
    for (std::size_t i = 0; i < corners; ++i) {
      const Triple place = bitmap_place(i, corners);
      const Triple next = bitmap_place((i + 1) % corners, corners);
      EXPECT_NEAR(std::hypot(place[0] - 0.5, place[1] - 0.5), 127.5 / 256, 1e-12);
      // The chord of 1/corners of the circle.
      EXPECT_NEAR(length(difference(next, place)),
                  2 * 127.5 / 256 * std::sin(std::numbers::pi / static_cast<double>(corners)),
                  1e-12);
    }
  }
}

/// The corner values of the one visible face of a cube of half edge 100. The face is 400 from the
/// viewer. The order is top right, bottom right, bottom left, top left.
template <class N>
std::array<PointValues, 4> face_of_a_cube(SurfaceKind kind) {
  Scene scene;
  scene.near = 100;
  scene.palette = PaletteKind::ramps;
  scene.lights.spots = {{true, {0, 0, -1}, {1, 1, 1}}};
  ObjectDescription object;
  object.mesh = with_vertex_normals(cube(100));
  object.paints.resize(object.mesh.faces.size());
  object.position = {0, 0, -500};
  object.surface.kind = kind;
  scene.objects.push_back(object);
  Animation<N> animation(scene);
  Picture picture;
  animation.draw(picture);
  std::array<PointValues, 4> values{};
  if (picture.polygons.size() != 1 || picture.points.size() != 4) {
    ADD_FAILURE() << picture.polygons.size() << " faces seen";
    return values;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const bool right = picture.points[i].x > scene.width / 2;
    const bool above = picture.points[i].y < scene.height / 2;
    values.at(right ? (above ? 0 : 1) : (above ? 3 : 2)) = picture.values[i];
  }
  return values;
}

// The face starts at its top right and its bitmap at the top left; both run clockwise.
TYPED_TEST(CornerValues, GoOntoTheCornersOfACube) {
  using N = TypeParam;
  const auto texture = face_of_a_cube<N>(SurfaceKind::texture);
  constexpr std::array<std::array<double, 2>, 4> places{{{first_texel, first_texel},
                                                         {last_texel, first_texel},
                                                         {last_texel, last_texel},
                                                         {first_texel, last_texel}}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(texture.at(i), (PointValues{32767 / 4.0, places.at(i)[0], places.at(i)[1], 0})) << i;
  }
  // Each component of an outward normal is 1 / sqrt 3; the light comes from the viewer.
  const double part = 1 / std::sqrt(3.0);
  const auto gouraud = face_of_a_cube<N>(SurfaceKind::gouraud16);
  const auto phong = face_of_a_cube<N>(SurfaceKind::phong);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(gouraud.at(i)[1], 64 + 62 * part, 62 * 4 * ulp) << i;
    EXPECT_NEAR(phong.at(i)[1], i < 2 ? part : -part, 4 * ulp) << i;
    EXPECT_NEAR(phong.at(i)[2], i == 0 || i == 3 ? part : -part, 4 * ulp) << i;
    EXPECT_NEAR(phong.at(i)[3], part, 4 * ulp) << i;
  }
}

}  // namespace
}  // namespace pipeline

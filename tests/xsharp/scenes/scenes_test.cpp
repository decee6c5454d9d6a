/// Tests the shipped scenes, with an independent transcription of the published ones.
#include <filesystem>

#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"
#include "xsharp/files/scene_json.hpp"
#include "xsharp/shapes.hpp"

namespace {

using namespace xsharp;

std::filesystem::path file(const std::string& name) { return paths::scene(name); }

/// A cube from the initialisers of listing 52.8: place, degrees about x y z, delay and base,
/// colours.
struct PublishedCube {
  std::array<int, 3> place;
  std::array<int, 3> degrees;
  std::array<int, 2> delay;
  std::array<int, 6> colors;
};

constexpr std::array<PublishedCube, 12> published{{
    {{100, 0, -6000}, {0, 6, 6}, {1, 1}, {15, 14, 12, 11, 10, 9}},
    {{100, 70, -6000}, {3, 0, 3}, {2, 2}, {1, 2, 3, 4, 5, 6}},
    {{100, -70, -6000}, {3, 3, 0}, {1, 1}, {35, 37, 39, 41, 43, 45}},
    {{33, 0, -6000}, {3, -3, 0}, {2, 2}, {47, 49, 51, 53, 55, 57}},
    {{33, 70, -6000}, {-3, 2, 0}, {1, 2}, {59, 61, 63, 65, 67, 69}},
    {{33, -70, -6000}, {-6, -3, 0}, {1, 1}, {71, 73, 75, 77, 79, 81}},
    {{-33, 0, -6000}, {3, 0, -6}, {1, 1}, {83, 85, 87, 89, 91, 93}},
    {{-33, 70, -6000}, {-2, 0, 3}, {1, 1}, {95, 97, 99, 101, 103, 105}},
    {{-33, -70, -6000}, {-3, 0, -3}, {1, 2}, {107, 109, 111, 113, 115, 117}},
    {{-100, 0, -6000}, {0, 2, -2}, {2, 2}, {119, 121, 123, 125, 127, 129}},
    {{-100, 70, -6000}, {0, -3, 3}, {1, 2}, {131, 133, 135, 137, 139, 141}},
    {{-100, -70, -6000}, {0, -6, -6}, {1, 1}, {143, 145, 147, 149, 151, 153}},
}};

TEST(Scenes, TwelveCubesAreThePublishedOnes) {
  const Scene scene = read_scene(file("twelve_cubes.json"));
  EXPECT_EQ(scene.width, 320);
  EXPECT_EQ(scene.height, 240);
  EXPECT_EQ(scene.projection_ratio, -2.0);
  EXPECT_EQ(scene.conversion, Conversion::published);
  EXPECT_EQ(scene.trigonometry, Trigonometry::floating);
  EXPECT_EQ(scene.depth_key, DepthKey::none);
  EXPECT_EQ(scene.palette, PaletteKind::vga);
  EXPECT_EQ(scene.background, 0);
  EXPECT_EQ(scene.restore_every, 0);
  EXPECT_EQ(scene.camera.position, (Triple{0, 0, 0}));
  EXPECT_EQ(scene.arithmetic.by, "type");
  EXPECT_EQ(scene.arithmetic.target, "i386");
  EXPECT_TRUE(scene.arithmetic.mul_round && scene.arithmetic.div_round);
  ASSERT_EQ(scene.objects.size(), published.size());
  for (std::size_t i = 0; i < published.size(); ++i) {
    const ObjectDescription& cube = scene.objects[i];
    SCOPED_TRACE(cube.name);
    EXPECT_EQ(cube.name, "cube " + std::to_string(i));
    ASSERT_EQ(cube.mesh.vertices.size(), 8U);
    EXPECT_EQ(cube.mesh.vertices[3], (Triple{15, -15, -15}));
    ASSERT_EQ(cube.paints.size(), 6U);
    for (std::size_t face = 0; face < 6; ++face) {
      EXPECT_TRUE(cube.paints[face].is_index);
      EXPECT_EQ(cube.paints[face].index, published[i].colors[face]);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(cube.position[axis], published[i].place[axis]);
      EXPECT_EQ(cube.spin.tenths[axis], 10 * published[i].degrees[axis]);
      EXPECT_EQ(cube.page[axis], 0);
    }
    EXPECT_EQ(cube.spin.delay.first, published[i].delay[0]);
    EXPECT_EQ(cube.spin.delay.base, published[i].delay[1]);
    ASSERT_TRUE(cube.drift);
    EXPECT_EQ(cube.drift->step, (Triple{0, 0, 80}));
    EXPECT_EQ(cube.drift->stop_z, -350.0);
    EXPECT_EQ(cube.drift->delay.first, 1);
    EXPECT_EQ(cube.drift->delay.base, 1);
    EXPECT_FALSE(cube.orbit);
  }
}

TEST(Scenes, BallAndCubesAreElevenCubesAndABall) {
  const Scene scene = read_scene(file("ball_and_cubes.json"));
  EXPECT_EQ(scene.depth_key, DepthKey::center);
  EXPECT_EQ(scene.trigonometry, Trigonometry::table);
  ASSERT_EQ(scene.objects.size(), 12U);
  for (const ObjectDescription& object : scene.objects) {
    EXPECT_EQ(object.mesh.faces.size(), object.name == "ball" ? 72U : 6U);
    // The whole object stays in front of the viewer in every frame.
    double nearest = object.position[2];
    if (object.orbit) nearest = object.orbit->about[2] + object.orbit->radius;
    EXPECT_LT(nearest + 50, -1) << object.name;
  }
  ASSERT_TRUE(scene.objects[0].orbit);
}

// In chapter 54, all light except spot two's is green.
TEST(Scenes, ShadedBallHasThreeSpotsAndUnitNormals) {
  const Scene scene = read_scene(file("shaded_ball.json"));
  EXPECT_EQ(scene.palette, PaletteKind::shading_gamma);
  ASSERT_EQ(scene.lights.spots.size(), 3U);
  const auto is_only = [](std::size_t component, const Intensity& light) {
    for (std::size_t i = 0; i < 3; ++i) {
      if ((light[i] > 0) != (i == component)) return false;
    }
    return true;
  };
  constexpr std::size_t green = 1;
  constexpr std::size_t blue = 2;
  EXPECT_TRUE(is_only(green, scene.lights.ambient));
  EXPECT_TRUE(is_only(green, scene.lights.spots[0].intensity));
  EXPECT_TRUE(is_only(green, scene.lights.spots[1].intensity));
  EXPECT_TRUE(is_only(blue, scene.lights.spots[2].intensity));
  ASSERT_EQ(scene.objects.size(), 1U);
  const ObjectDescription& ball = scene.objects[0];
  ASSERT_EQ(ball.shadings.size(), 72U);
  for (const Shading& shading : ball.shadings) EXPECT_TRUE(shading.ambient && shading.diffuse);
  ASSERT_EQ(ball.mesh.faces.size(), 72U);
  for (const Face& face : ball.mesh.faces) EXPECT_TRUE(face.normal_end);
}

TEST(Scenes, AllCanBeRead) {
  std::size_t scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(file(""))) {
    if (entry.path().extension() != ".json") continue;
    EXPECT_FALSE(read_scene(entry.path()).objects.empty()) << entry.path();
    ++scenes;
  }
  EXPECT_GE(scenes, 4U);
}

}  // namespace

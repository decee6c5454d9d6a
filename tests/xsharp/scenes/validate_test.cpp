/// Tests scenes that break a limit, with the error message of each.
#include "xsharp/validate.hpp"

#include "tests/support/test.hpp"
#include "tests/xsharp/scenes/refusal.hpp"
#include "xsharp/normals.hpp"
#include "xsharp/shapes.hpp"

namespace {

using namespace xsharp;
using xsharp_test::infinity;
using xsharp_test::nan;

Scene good_scene() {
  Scene scene;
  scene.name = "s";
  scene.lights.spots.resize(2);
  ObjectDescription object;
  object.name = "cube";
  object.mesh = cube(15);
  object.paints.resize(6);
  object.drift = Drift{};
  object.orbit = Orbit{{0, 0, -400}, 100, 0, 10, 200};
  scene.objects.push_back(object);
  object.name = "ball";
  object.mesh = with_normals(ball(40, 6));
  object.paints.assign(72, Paint{false, 0, {255, 128, 0}});
  object.shadings.assign(72, {true, true});
  scene.objects.push_back(object);
  return scene;
}

std::string said(const Scene& scene) {
  return xsharp_test::refusal([&] { validate(scene); });
}

struct BadScene {
  std::string message;
  std::function<void(Scene&)> spoil;
};

constexpr std::int32_t least = std::numeric_limits<std::int32_t>::min();

const std::vector<BadScene>& bad_settings() {
  static const std::vector<BadScene> table{
      {"width is 1, must be from 2 to 4096", [](Scene& s) { s.width = 1; }},
      {"width is 4097, must be from 2 to 4096", [](Scene& s) { s.width = 4097; }},
      {"height is -2147483648, must be from 1 to 4096", [](Scene& s) { s.height = least; }},
      {"frames_per_second is 0, must be from 0.001 to 1000",
       [](Scene& s) { s.frames_per_second = 0; }},
      {"frames_per_second is 1000.0001, must be from 0.001 to 1000",
       [](Scene& s) { s.frames_per_second = 1000.0001; }},
      {"frames_per_second is nan, must be from 0.001 to 1000",
       [](Scene& s) { s.frames_per_second = nan; }},
      {"projection_ratio is 2, must be from -1000 to -0.01",
       [](Scene& s) { s.projection_ratio = 2; }},
      {"projection_ratio is -inf, must be from -1000 to -0.01",
       [](Scene& s) { s.projection_ratio = -infinity; }},
      {"projection_ratio * (width / 2) is -16160, must be from -16000 to -0.01",
       [](Scene& s) { s.projection_ratio = -101; }},
      {"restore_every is -1, must be from 0 to 2147483647", [](Scene& s) { s.restore_every = -1; }},
      {"arithmetic.by is \"float\", must be one of type, model, double",
       [](Scene& s) { s.arithmetic.by = "float"; }},
      {"arithmetic.target is \"\", must be one of i386, i8088, standard, saturating, trapping",
       [](Scene& s) { s.arithmetic.target = ""; }},
      {"near is 0.5, must be from 1 to 16384", [](Scene& s) { s.near = 0.5; }},
      {"near is nan, must be from 1 to 16384", [](Scene& s) { s.near = nan; }},
      {"the spots' intensities, each the mean of three, add up to 1.5; a surface that shows light "
       "by a ramp has 1 at most",
       [](Scene& s) {
         s.objects[0].mesh = with_vertex_normals(s.objects[0].mesh);
         s.objects[0].surface.kind = SurfaceKind::gouraud16;
         s.palette = PaletteKind::ramps;
         s.lights.spots[0].intensity = {1, 2, 0};
         s.lights.spots[1].intensity = {0, 0, 1.5};
       }},
      {"object 'cube': surface.kind is \"distance\", so palette must be \"ramps\"",
       [](Scene& s) { s.objects[0].surface.kind = SurfaceKind::distance; }},
      {"object 'ball': surface.kind is \"phong\", so palette must be \"ramps\"",
       [](Scene& s) {
         s.palette = PaletteKind::shading;
         s.objects[1].mesh = with_vertex_normals(s.objects[1].mesh);
         s.objects[1].surface.kind = SurfaceKind::phong;
       }},
      {"camera: page is 1000001, must be from -1000000 to 1000000",
       [](Scene& s) { s.camera.page[2] = 1000001; }},
      {"camera: position is -16385, must be from -16384 to 16384",
       [](Scene& s) { s.camera.position[0] = -16385; }},
      {"camera: position is nan, must be from -16384 to 16384",
       [](Scene& s) { s.camera.position[1] = nan; }},
      {"camera: turn_tenths is 32768, must be from -32768 to 32767",
       [](Scene& s) { s.camera.turn_tenths[1] = 32768; }},
      {"camera: look_at is nan, must be from -16384 to 16384",
       [](Scene& s) {
         s.camera.look_at = Triple{0, 0, nan};
       }},
      {"camera: look_at must be at least 2^-14 away from position",
       [](Scene& s) { s.camera.look_at = s.camera.position; }},
      {"camera: must not have both turn_tenths and look_at",
       [](Scene& s) {
         s.camera.turn_tenths = {1, 0, 0};
         s.camera.look_at = Triple{0, 0, -9};
       }},
      {"lights.ambient is -0.1, must be from 0 to 100",
       [](Scene& s) { s.lights.ambient[1] = -0.1; }},
      {"17 spots, more than 16", [](Scene& s) { s.lights.spots.resize(17); }},
      {"spot 1: length of direction is 0, must be from 6.10352e-05 to 65536",
       [](Scene& s) { s.lights.spots[1].direction = {}; }},
      {"spot 0: direction is nan, must be from -32768 to 32768",
       [](Scene& s) { s.lights.spots[0].direction[2] = nan; }},
      {"spot 1: intensity is 101, must be from 0 to 100",
       [](Scene& s) { s.lights.spots[1].intensity[2] = 101; }},
      {"65537 objects, more than 65536", [](Scene& s) { s.objects.resize(65537, s.objects[0]); }},
      {"524300 faces, more than 524288",
       [](Scene& s) {
         for (int i = 0; i < 128; ++i) {
           s.objects.push_back(s.objects[0]);
           s.objects.back().mesh.faces.resize(i < 127 ? 4096 : 4030);
         }
       }},
  };
  return table;
}

const std::vector<BadScene>& bad_objects() {
  static const std::vector<BadScene> table{
      {"'cube': face 0 faces into the body: its vertices run the wrong way round",
       [](Scene& s) {
         s.objects[0].mesh.faces[0].vertices = {0, 2, 3, 1};
       }},
      {"'cube': 5 paints for 6 faces", [](Scene& s) { s.objects[0].paints.pop_back(); }},
      {"'cube': surface.ramp is 2, must be from 0 to 1",
       [](Scene& s) { s.objects[0].surface.ramp = 2; }},
      {"'cube': surface.exact_every is 2, must be 1, 8, 16 or 0 for never",
       [](Scene& s) { s.objects[0].surface.exact_every = 2; }},
      {"'cube': surface.kind needs normals at the vertices",
       [](Scene& s) { s.objects[0].surface.kind = SurfaceKind::gouraud8; }},
      {"'cube': a normal ends at vertex 99 of 8",
       [](Scene& s) {
         s.objects[0].surface.kind = SurfaceKind::phong;
         s.objects[0].mesh.vertex_normal_ends = {99};
       }},
      {"'ball': 0 paints for 72 faces", [](Scene& s) { s.objects[1].paints.clear(); }},
      {"'ball': 71 shadings for 72 faces", [](Scene& s) { s.objects[1].shadings.pop_back(); }},
      {"'ball': face 3 answers to light, so its paint must be a colour",
       [](Scene& s) { s.objects[1].paints[3].is_index = true; }},
      {"'ball': face 71 answers to diffuse light, but has no normal",
       [](Scene& s) { s.objects[1].mesh.faces[71].normal_end.reset(); }},
      {"'ball': face 5 has a highlight, but no normal",
       [](Scene& s) {
         s.objects[1].shadings[5] = {.highlight = Highlight{8, 1}};
         s.objects[1].mesh.faces[5].normal_end.reset();
       }},
      {"'ball': face 5: highlight.exponent is nan, must be from 1 to 1000",
       [](Scene& s) {
         s.objects[1].shadings[5].highlight = Highlight{nan, 1};
       }},
      {"'ball': face 5: highlight.strength is inf, must be from 0 to 1",
       [](Scene& s) {
         s.objects[1].shadings[5].highlight = Highlight{8, infinity};
       }},
      {"'cube': look_at is inf, must be from -16384 to 16384",
       [](Scene& s) {
         s.objects[0].look_at = Triple{infinity, 0, 0};
       }},
      {"'cube': must not have both spin and look_at",
       [](Scene& s) {
         s.objects[0].spin.tenths = {0, 0, -1};
         s.objects[0].look_at = Triple{};
       }},
      {"'cube': page is -1000001, must be from -1000000 to 1000000",
       [](Scene& s) { s.objects[0].page[0] = -1000001; }},
      {"'cube': position is 16384.5, must be from -16384 to 16384",
       [](Scene& s) { s.objects[0].position[2] = 16384.5; }},
      {"'ball': position is nan, must be from -16384 to 16384",
       [](Scene& s) { s.objects[1].position[0] = nan; }},
      {"'cube': spin.tenths is -32769, must be from -32768 to 32767",
       [](Scene& s) { s.objects[0].spin.tenths[2] = -32769; }},
      {"'cube': spin.delay, first is 0, must be from 1 to 2147483647",
       [](Scene& s) { s.objects[0].spin.delay.first = 0; }},
      {"'cube': spin.delay, base is -1, must be from 1 to 2147483647",
       [](Scene& s) { s.objects[0].spin.delay.base = -1; }},
      {"'cube': drift.step is inf, must be from -16384 to 16384",
       [](Scene& s) { s.objects[0].drift->step[0] = infinity; }},
      {"'cube': drift.stop_z is nan, must be from -1.6384e+10 to 1.6384e+10",
       [](Scene& s) { s.objects[0].drift->stop_z = nan; }},
      {"'cube': drift must not have both stop_z and bounce_z",
       [](Scene& s) {
         s.objects[0].drift->stop_z = -350;
         s.objects[0].drift->bounce_z = Bounds{-6000, -350};
       }},
      {"'cube': drift.bounce_z, least is nan, must be from -1.6384e+10 to 1.6384e+10",
       [](Scene& s) {
         s.objects[0].drift->stop_z.reset();
         s.objects[0].drift->bounce_z = Bounds{nan, 0};
       }},
      {"'cube': drift.bounce_z, most is -7, must be from -6 to 1.6384e+10",
       [](Scene& s) {
         s.objects[0].drift->stop_z.reset();
         s.objects[0].drift->bounce_z = Bounds{-6, -7};
       }},
      {"'cube': drift.delay, base is 0, must be from 1 to 2147483647",
       [](Scene& s) { s.objects[0].drift->delay.base = 0; }},
      {"'cube': orbit.radius is -1, must be from 0 to 16384",
       [](Scene& s) { s.objects[0].orbit->radius = -1; }},
      {"'cube': orbit.about, with this radius, is -400, must be from -384 to 384",
       [](Scene& s) { s.objects[0].orbit->radius = 16000; }},
      {"'cube': orbit.about, with this radius, is nan, must be from -16284 to 16284",
       [](Scene& s) { s.objects[0].orbit->about[0] = nan; }},
      {"'cube': orbit.start_tenths is 40000, must be from -32768 to 32767",
       [](Scene& s) { s.objects[0].orbit->start_tenths = 40000; }},
      {"'cube': orbit.step_tenths is -40000, must be from -32768 to 32767",
       [](Scene& s) { s.objects[0].orbit->step_tenths = -40000; }},
      {"'cube': orbit.tilt_tenths is 32768, must be from -32768 to 32767",
       [](Scene& s) { s.objects[0].orbit->tilt_tenths = 32768; }},
  };
  return table;
}

TEST(Validate, AcceptsAScene) { EXPECT_EQ(said(good_scene()), "accepted"); }

TEST(Validate, AcceptsTheEndsOfRanges) {
  Scene scene = good_scene();
  scene.width = scene.height = 4096;
  scene.projection_ratio = -7.8125;
  scene.camera.position = {16384, -16384, 0};
  scene.camera.turn_tenths = {-32768, 32767, 0};
  scene.objects[0].page = {-1000000, 1000000, 0};
  scene.objects[0].orbit->radius = 16384;
  scene.objects[0].orbit->about = {};
  scene.lights.ambient = {100, 0, 100};
  scene.objects.resize(256, scene.objects[0]);
  EXPECT_EQ(said(scene), "accepted");
}

TEST(Validate, AmbientLightNeedsNoNormals) {
  Scene scene = good_scene();
  scene.objects[1].mesh = ball(40, 6);
  scene.objects[1].shadings.assign(72, {.ambient = true, .diffuse = false});
  EXPECT_EQ(said(scene), "accepted");
}

TEST(Validate, OnlyAFaceThatAnswersToLightNeedsAColourAndANormal) {
  Scene scene = good_scene();
  scene.objects[1].paints[3].is_index = true;
  scene.objects[1].mesh.faces[3].normal_end.reset();
  scene.objects[1].shadings[3] = {};
  EXPECT_EQ(said(scene), "accepted");
}

TEST(Validate, ATextureNeedsTheInverseOfZ) {
  Scene scene = good_scene();
  scene.objects[0].surface.kind = SurfaceKind::texture;
  EXPECT_EQ(said(scene), "accepted");
  scene.depth_measure = DepthMeasure::z;
  EXPECT_EQ(said(scene),
            "scene 's': object 'cube': a texture needs depth_measure \"inverse\", not \"z\"");
}

TEST(Validate, RefusesASettingOutOfRange) {
  for (const auto& [message, spoil] : bad_settings()) {
    Scene scene = good_scene();
    spoil(scene);
    EXPECT_EQ(said(scene), "scene 's': " + message);
  }
}

TEST(Validate, RefusesAnObjectByItsName) {
  for (const auto& [message, spoil] : bad_objects()) {
    Scene scene = good_scene();
    spoil(scene);
    EXPECT_EQ(said(scene), "scene 's': object " + message);
  }
}

}  // namespace

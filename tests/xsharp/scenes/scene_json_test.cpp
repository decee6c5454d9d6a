/// Tests every key of the scene format and every kind of invalid input.
#include "xsharp/files/scene_json.hpp"

#include <rapidcheck.h>

#include <filesystem>
#include <fstream>

#include "fixed/fixed.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"
#include "tests/xsharp/scenes/refusal.hpp"
#include "xsharp/animation.hpp"

namespace {

using namespace xsharp;

const std::filesystem::path root = paths::source("");

std::string contents(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

Scene parsed(const std::string& text) { return parse_scene(text, "s", root / "xsharp" / "scenes"); }
std::string said_of_scene(const std::string& text) {
  return xsharp_test::refusal([&] { parsed(text); });
}
std::string cube_with(const std::string& keys) {
  return R"({"objects": [{"shape": {"cube": {"half_edge": 1}}, )" + keys + "}]}";
}
std::string paint_of(const std::string& paint) { return cube_with("\"paint\": " + paint); }

TEST(SceneJson, ReadsTheExampleOfTheDocument) {
  const std::string page = contents(root / "docs" / "scenes.md");
  const std::string fence = "```json\n";
  const auto begin = page.find(fence);
  ASSERT_NE(begin, std::string::npos);
  const Scene scene = parsed(
      page.substr(begin + fence.size(), page.find("```\n", begin + 3) - begin - fence.size()));
  EXPECT_EQ(scene.name, "two bodies");
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_EQ(scene.objects[0].mesh.faces.size(), 72U);
  EXPECT_EQ(scene.objects[1].mesh.faces.size(), 6U);
}

TEST(SceneJson, ReadsEveryKey) {
  const Scene scene = parsed(R"({
    "name": "n", "width": 100, "height": 50, "frames_per_second": 12.5, "projection_ratio": -3,
    "conversion": "nearest", "trigonometry": "floating", "depth_key": "farthest",
    "palette": "shading", "background": 7, "restore_every": 5, "restore_rows": "one",
    "depth_measure": "z",
    "arithmetic": {"by": "model", "target": "i8088", "mul_round": false, "div_round": false,
                   "repaired": true},
    "camera": {"page": [1, 2, 3], "position": [4, 5, 6.5], "turn_tenths": [7, 8, 9]},
    "lights": {"ambient_on": false, "ambient": [0.25, 0.5, 1],
               "spots": [{"on": false, "direction": [1, 2, 3], "intensity": [4, 5, 6]}]},
    "objects": [{"name": "o", "shape": {"cube": {"half_edge": 2.5}}, "paint": [1, 2, 3],
                 "shading": {"ambient": true, "diffuse": true}, "page": [-1, -2, -3],
                 "position": [-4, -5, -6], "spin": {"tenths": [10, -20, 30], "delay": [2, 3]},
                 "drift": {"step": [1, 2, 3], "stop_z": -9, "delay": [4, 5]},
                 "orbit": {"about": [1, 2, 3], "radius": 4, "start_tenths": 5, "step_tenths": 6,
                           "tilt_tenths": 7}}]})");
  EXPECT_EQ(scene.name, "n");
  EXPECT_EQ(std::pair(scene.width, scene.height), std::pair(100, 50));
  EXPECT_EQ(scene.frames_per_second, 12.5);
  EXPECT_EQ(scene.projection_ratio, -3);
  EXPECT_EQ(scene.conversion, Conversion::nearest);
  EXPECT_EQ(scene.trigonometry, Trigonometry::floating);
  EXPECT_EQ(scene.depth_key, DepthKey::farthest);
  EXPECT_EQ(scene.palette, PaletteKind::shading);
  EXPECT_EQ(scene.background, 7);
  EXPECT_EQ(scene.restore_every, 5);
  EXPECT_EQ(scene.restore_rows, RestoredRows::one);
  EXPECT_EQ(scene.depth_measure, DepthMeasure::z);
  EXPECT_EQ(scene.arithmetic.by + scene.arithmetic.target, "modeli8088");
  EXPECT_FALSE(scene.arithmetic.mul_round || scene.arithmetic.div_round);
  EXPECT_TRUE(scene.arithmetic.repaired);
  EXPECT_EQ(scene.camera.page, (std::array{1, 2, 3}));
  EXPECT_EQ(scene.camera.position, (Triple{4, 5, 6.5}));
  EXPECT_EQ(scene.camera.turn_tenths, (std::array{7, 8, 9}));
  EXPECT_FALSE(scene.lights.ambient_on);
  EXPECT_EQ(scene.lights.ambient, (Triple{0.25, 0.5, 1}));
  ASSERT_EQ(scene.lights.spots.size(), 1U);
  EXPECT_FALSE(scene.lights.spots[0].on);
  EXPECT_EQ(scene.lights.spots[0].direction, (Triple{1, 2, 3}));
  EXPECT_EQ(scene.lights.spots[0].intensity, (Triple{4, 5, 6}));
  ASSERT_EQ(scene.objects.size(), 1U);
  const ObjectDescription& object = scene.objects[0];
  EXPECT_EQ(object.name, "o");
  EXPECT_EQ(object.mesh.vertices.at(13), (Triple{2.5, 2.5, 3.5}));
  EXPECT_EQ(object.paints, (std::vector<Paint>(6, Paint{false, 0, {1, 2, 3}})));
  ASSERT_EQ(object.shadings.size(), 6U);
  for (const Shading& s : object.shadings) EXPECT_TRUE(s.ambient && s.diffuse);
  EXPECT_EQ(object.page, (std::array{-1, -2, -3}));
  EXPECT_EQ(object.position, (Triple{-4, -5, -6}));
  EXPECT_EQ(object.spin.tenths, (std::array{10, -20, 30}));
  EXPECT_EQ(std::pair(object.spin.delay.first, object.spin.delay.base), std::pair(2, 3));
  ASSERT_TRUE(object.drift && object.orbit);
  EXPECT_EQ(object.drift->step, (Triple{1, 2, 3}));
  EXPECT_EQ(object.drift->stop_z, -9.0);
  EXPECT_EQ(std::pair(object.drift->delay.first, object.drift->delay.base), std::pair(4, 5));
  EXPECT_EQ(object.orbit->about, (Triple{1, 2, 3}));
  EXPECT_EQ(object.orbit->radius, 4);
  EXPECT_EQ(object.orbit->start_tenths, 5);
  EXPECT_EQ(object.orbit->step_tenths, 6);
  EXPECT_EQ(object.orbit->tilt_tenths, 7);
}

TEST(SceneJson, EveryFaceCanAnswerToItsOwnLight) {
  const Scene scene = parsed(R"({"objects": [{"shape": {"cube": {"half_edge": 9}},
    "paints": [1, "#ffffff", "#ff0000", 2, "#00ff00", 3],
    "shadings": [{}, {"ambient": true, "diffuse": true}, {"diffuse": true}, {},
                 {"ambient": true}, {}]}]})");
  const ObjectDescription& cube = scene.objects.at(0);
  ASSERT_EQ(cube.shadings.size(), 6U);
  for (std::size_t face = 0; face < 6; ++face) {
    EXPECT_EQ(cube.shadings[face].ambient, face == 1 || face == 4) << face;
    EXPECT_EQ(cube.shadings[face].diffuse, face == 1 || face == 2) << face;
    // Only faces with diffuse light need a normal.
    EXPECT_EQ(cube.mesh.faces[face].normal_end.has_value(), face == 1 || face == 2) << face;
  }
  EXPECT_EQ(cube.mesh.vertices.size(), 10U);
}

TEST(SceneJson, AnObjectsShadingReplacesThatOfTheDefaults) {
  const auto first_face = [](const std::string& object) {
    return parsed(R"({"defaults": {"shape": {"cube": {"half_edge": 9}}, "paint": "#808080",
                      "shadings": [{"ambient": true}, {}, {}, {}, {}, {}]}, "objects": [{)" +
                  object + "}]}")
        .objects.at(0)
        .shadings.at(0);
  };
  EXPECT_TRUE(first_face("").ambient);
  EXPECT_FALSE(first_face(R"("shading": {"diffuse": true})").ambient);
  EXPECT_TRUE(first_face(R"("shading": {"diffuse": true})").diffuse);
}

TEST(SceneJson, ReadsSurfaces) {
  const auto read = [](const std::string& surface, const std::string& scene = "") {
    return parsed(R"({)" + scene +
                  R"("objects": [{"shape": {"cube": {"half_edge": 9}}, "paint": 1, "surface": )" +
                  surface + "}]}");
  };
  const Surface texture =
      read(R"({"kind": "texture", "exact_every": 8, "bitmap": {"bricks": [3, 255]}})")
          .objects[0]
          .surface;
  EXPECT_EQ(texture.kind, SurfaceKind::texture);
  EXPECT_EQ(texture.exact_every, 8);
  EXPECT_EQ(texture.pattern, Pattern::bricks);
  EXPECT_EQ(texture.texels, (std::array<std::uint8_t, 2>{3, 255}));
  EXPECT_EQ(read(R"({"kind": "texture", "exact_every": "never"})").objects[0].surface.exact_every,
            0);
  const Scene phong = read(R"({"kind": "phong", "phong": "fourth", "ramp": 1})",
                           R"("palette": "ramps", "depth_buffer": "no-clear", "near": 12.5, )");
  EXPECT_EQ(phong.objects[0].surface.phong, PhongForm::fourth);
  EXPECT_EQ(phong.objects[0].surface.ramp, 1);
  EXPECT_EQ(phong.objects[0].mesh.vertex_normal_ends.size(), 8U);
  EXPECT_EQ(phong.palette, PaletteKind::ramps);
  EXPECT_EQ(phong.depth_buffer, DepthBuffering::no_clear);
  EXPECT_EQ(phong.near, 12.5);
  std::size_t kind = 0;
  for (const std::string word :
       {"flat", "gouraud8", "gouraud16", "depth", "distance", "texture", "environment", "phong"}) {
    EXPECT_EQ(
        read(R"({"kind": ")" + word + "\"}", R"("palette": "ramps", )").objects[0].surface.kind,
        static_cast<SurfaceKind>(kind++));
  }
}

TEST(SceneJson, RefusesSurfaces) {
  const auto said = [](const std::string& surface) {
    return said_of_scene(cube_with("\"paint\": 1, \"surface\": " + surface));
  };
  const std::string place = "objects[0].surface";
  EXPECT_EQ(said("{}"), place + ": must have the key \"kind\"");
  EXPECT_EQ(said(R"({"kind": "shiny"})"),
            place +
                ".kind: must be one of \"flat\" \"gouraud8\" \"gouraud16\" \"depth\" "
                "\"distance\" \"texture\" \"environment\" \"phong\", not \"shiny\"");
  EXPECT_EQ(said(R"({"kind": "texture", "exact_every": 4})"),
            place + ".exact_every: must be 1, 8, 16 or \"never\"");
  EXPECT_EQ(said(R"({"kind": "texture", "bitmap": {}})"),
            place + ".bitmap: must have one key: checker or bricks");
  EXPECT_EQ(said(R"({"kind": "texture", "bitmap": {"checker": [1, 2], "bricks": [1, 2]}})"),
            place + ".bitmap: must have one key: checker or bricks");
  EXPECT_NE(said(R"({"kind": "phong", "ramp": 2})").find(place + ".ramp: must be"),
            std::string::npos);
}

TEST(SceneJson, ReadsPaints) {
  EXPECT_EQ(parsed(paint_of("255")).objects[0].paints[5], (Paint{true, 255, {}}));
  EXPECT_EQ(parsed(paint_of("\"#0aFF10\"")).objects[0].paints[5], (Paint{false, 0, {10, 255, 16}}));
  const Scene ball =
      parsed(R"({"objects": [{"shape": {"ball": {"radius": 9, "bands": 2}}, "checks": [1, 2]}]})");
  std::string checks;
  for (const Paint& paint : ball.objects[0].paints) checks += std::to_string(paint.index);
  EXPECT_EQ(checks, "12122121");
}

TEST(SceneJson, DefaultsGiveWay) {
  const Scene scene = parsed(R"({
    "objects": [{"name": "a"}, {"paints": [1, 2, 3, 4, 5, 6], "spin": {"tenths": [0, 0, 9]}}],
    "defaults": {"shape": {"cube": {"half_edge": 1}}, "paint": 9,
                 "spin": {"tenths": [1, 2, 3], "delay": [4, 4]}}})");
  EXPECT_EQ(scene.name, "s");
  EXPECT_EQ(scene.objects[0].paints[0].index, 9);
  EXPECT_EQ(scene.objects[0].spin.delay.base, 4);
  EXPECT_EQ(scene.objects[1].name, "object 1");
  EXPECT_EQ(scene.objects[1].paints[5].index, 6);
  EXPECT_EQ(scene.objects[1].spin.tenths, (std::array{0, 0, 9}));
  EXPECT_EQ(scene.objects[1].spin.delay.base, 1);
}

TEST(SceneJson, SaysWhatIsWrongAndWhere) {
  const std::vector<std::pair<std::string, std::string>> table{
      {"[]", "must be an object {…}, not []"},
      {"{}", "must have the key \"objects\""},
      {"{\"objects\": " + std::string(500'000, '['), "nested too deeply"},
      {"{\"name\": " + std::string(500'000, '['), "nested too deeply"},
      {R"({"objects": {}})", "objects: must be a list, not {}"},
      {R"({"objects": [3]})", "objects[0]: must be an object {…}, not 3"},
      {R"({"objects": [], "objects": []})", "the key \"objects\" occurs twice in one object"},
      {R"({"objects": [], "camera": {"poistion": [0, 0, 0]}})",
       "camera: unknown key \"poistion\"; choose one of page, position, turn_tenths, look_at"},
      {R"({"objects": [], "arithmetic": {"repaired": true}})",
       "arithmetic: repaired is for the target i8088: only its ConcatXforms loses a carry"},
      {R"({"objects": [], "arithmetic": {"by": "double", "target": "i8088", "repaired": true}})",
       "arithmetic: repaired is for the target i8088: only its ConcatXforms loses a carry"},
      {R"({"objects": [{"shape": {"cube": {"half_edge": 1}}, "paint": 1, "shadings": []}]})",
       "objects[0]: shadings must have one for each face"},
      {R"({"objects": [], "width": "wide"})",
       "width: must be a whole number from 2 to 4096, not \"wide\""},
      {R"({"objects": [], "width": 320.0})",
       "width: must be a whole number from 2 to 4096, not 320.0"},
      {R"({"objects": [], "width": 18446744073709551615})",
       "width: must be a whole number from 2 to 4096, not 18446744073709551615"},
      {R"({"objects": [], "background": 256})",
       "background: must be a whole number from 0 to 255, not 256"},
      {R"({"objects": [], "palette": "cga"})",
       "palette: must be one of \"vga\" \"shading\" \"shading-gamma\" \"ramps\", not \"cga\""},
      {R"({"objects": [], "depth_key": 1})",
       "depth_key: must be one of \"none\" \"center\" \"nearest\" \"farthest\", not 1"},
      {R"({"objects": [], "camera": {"position": [0, 0]}})",
       "camera.position: must be a list of 3, not [0,0]"},
      {R"({"objects": [], "camera": {"position": [0, null, 0]}})",
       "camera.position[1]: must be a number, not null"},
      {R"({"objects": [], "lights": {"ambient_on": 1}})",
       "lights.ambient_on: must be true or false, not 1"},
      {R"({"objects": [], "lights": {"spots": [{"direction": [0, 0, 1]}]}})",
       "lights.spots[0]: must have the key \"intensity\""},
      {R"({"objects": [], "name": 5})", "name: must be a text, not 5"},
      {R"({"objects": [], "width": 1})", "width: must be a whole number from 2 to 4096, not 1"},
      {R"({"objects": [], "height": 0})", "height: must be a whole number from 1 to 4096, not 0"},
      {R"({"objects": [], "camera": {"page": [0, 1000001, 0]}})",
       "camera.page[1]: must be a whole number from -1000000 to 1000000, not 1000001"},
      {R"({"objects": [], "camera": {"turn_tenths": [0, 0, 32768]}})",
       "camera.turn_tenths[2]: must be a whole number from -32768 to 32767, not 32768"},
      {R"({"objects": [{"shape": {"cube": {"half_edge": 0}}}]})",
       "objects[0].shape.cube.half_edge: must be above 0, not 0"},
      {R"({"objects": [{"shape": {"ball": {"radius": -2.5, "bands": 2}}}]})",
       "objects[0].shape.ball.radius: must be above 0, not -2.5"},
      {cube_with(R"("paint": 1, "spin": {"tenths": [1, 1, 1], "delay": [1, 0]})"),
       "objects[0].spin.delay[1]: must be a whole number from 1 to 2147483647, not 0"},
      {R"({"objects": [], "frames_per_second": 0})",
       "scene 's': frames_per_second is 0, must be from 0.001 to 1000"},
      {R"({"objects": [{"paint": 1}]})", "objects[0]: must have the key \"shape\""},
      {R"({"objects": [{"shape": {}, "paint": 1}]})",
       "objects[0].shape: must have one key: cube, ball or obj"},
      {R"({"objects": [{"shape": {"cube": {"half_edge": 1}, "obj": "dodecahedron.obj"}}]})",
       "objects[0].shape: must have one key: cube, ball or obj"},
      {R"({"objects": [{"shape": {"cube": 15}}]})",
       "objects[0].shape.cube: must be an object {…}, not 15"},
      {R"({"objects": [{"shape": {"ball": {"radius": 1, "bands": 46}}}]})",
       "objects[0].shape.ball.bands: must be a whole number from 2 to 45, not 46"},
      {R"({"objects": [{"shape": {"ball": {"radius": 1}}}]})",
       "objects[0].shape.ball: must have the key \"bands\""},
      {R"({"defaults": {"shape": {"obj": "no.obj"}}, "objects": []})",
       "defaults.shape.obj: " + (root / "xsharp" / "scenes" / "no.obj").string() +
           ": there is no such file"},
      {cube_with(R"("name": "x")"), "objects[0]: must have one of paint, paints and checks"},
      {cube_with(R"("paint": 1, "checks": [1, 2])"),
       "objects[0]: must have one of paint, paints and checks"},
      {cube_with(R"("checks": [1, 2])"), "objects[0]: only a ball has checks"},
      {cube_with(R"("checks": [1, 2, 3])"), "objects[0].checks: must be a list of 2, not [1,2,3]"},
      {cube_with(R"("name": "x", "paints": [1, 2])"),
       "scene 's': object 'x': 2 paints for 6 faces"},
      {paint_of("-1"), "objects[0].paint: must be a whole number from 0 to 255, not -1"},
      {paint_of("[0, 0, 300]"),
       "objects[0].paint[2]: must be a whole number from 0 to 255, not 300"},
      {paint_of("\"red\""), "objects[0].paint: a colour is written \"#rrggbb\", not \"red\""},
      {paint_of("\"#12345\""), "objects[0].paint: a colour is written \"#rrggbb\", not \"#12345\""},
      {paint_of("\"#12345g\""),
       "objects[0].paint: a colour is written \"#rrggbb\", not \"#12345g\""},
      {paint_of("\"#-12345\""),
       "objects[0].paint: a colour is written \"#rrggbb\", not \"#-12345\""},
      {cube_with(R"("paint": 1, "spin": {"delay": [1, 1]})"),
       "objects[0].spin: must have the key \"tenths\""},
      {cube_with(R"("paint": 1, "spin": {"tenths": [1, 1, 1], "delay": 1})"),
       "objects[0].spin.delay: must be a list of 2, not 1"},
      {cube_with(R"("paint": "#ffffff", "shadings": [{}])"),
       "scene 's': object 'object 0': 1 shadings for 6 faces"},
      {cube_with(R"("paint": "#ffffff", "shading": {}, "shadings": [{}])"),
       "objects[0]: must have one of shading and shadings"},
      {cube_with(R"("paint": 1, "shading": {"diffuse": true})"),
       "scene 's': object 'object 0': face 0 answers to light, so its paint must be a colour"},
      {R"({"objects": [], "name": "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa",
          "width": [1111111111, 2222222222, 3333333333, 4444444444]})",
       "width: must be a whole number from 2 to 4096, not "
       "[1111111111,2222222222,3333333333,444..."},
  };
  for (const auto& [text, message] : table) EXPECT_EQ(said_of_scene(text), message) << text;
}

TEST(SceneJson, ADriftBouncesAndAPaletteHasAGamma) {
  const Scene scene = parse_scene(
      R"({"palette": "shading-gamma", "objects": [
          {"shape": {"cube": {"half_edge": 1}}, "paint": 1,
           "drift": {"step": [0, 0, 1], "bounce_z": [-6000, -350.5]}}]})",
      "s", {});
  EXPECT_EQ(scene.palette, PaletteKind::shading_gamma);
  const auto& drift = scene.objects.at(0).drift;
  ASSERT_TRUE(drift && drift->bounce_z);
  EXPECT_FALSE(drift->stop_z);
  EXPECT_EQ(drift->bounce_z->least, -6000);
  EXPECT_EQ(drift->bounce_z->most, -350.5);
}

TEST(SceneJson, SaysWhereItIsNotJson) {
  EXPECT_EQ(said_of_scene("{\n  \"objects\": [}").substr(0, 38),
            "not JSON: parse error at line 2, colum");
  EXPECT_EQ(said_of_scene("").substr(0, 22), "not JSON: parse error ");
  EXPECT_EQ(said_of_scene(R"({"objects": [], "width": 1e999})").substr(0, 25),
            "not JSON: number overflow");
  EXPECT_EQ(said_of_scene("// all of it\n{\"objects\": /* none */ []}"), "accepted");
  EXPECT_EQ(said_of_scene("[[[[[[[[[[").substr(0, 9), "not JSON:");
  // The library would end there and accept what is before it.
  EXPECT_EQ(said_of_scene(std::string("{\"objects\": []}") + '\0'), "not JSON: a zero byte");
}

TEST(SceneJson, NamesOnlyFilesOfItsFolder) {
  const auto said_of_file = [](const std::string& file) {
    return said_of_scene(R"({"defaults": {"shape": {"obj": ")" + file + R"("}}, "objects": []})");
  };
  EXPECT_EQ(said_of_file("dodecahedron.obj"), "accepted");
  const std::string scenes = (root / "xsharp" / "scenes").string();
  EXPECT_EQ(said_of_file("../README.md"),
            "defaults.shape.obj: " + scenes + "/../README.md: leads out of the folder");
  for (const std::string& file : {scenes + "/dodecahedron.obj", std::string("/proc/kmsg")}) {
    EXPECT_EQ(said_of_file(file), "defaults.shape.obj: " + file + ": leads out of the folder");
  }
}

TEST(SceneJson, ASmallTextMakesNoHugeScene) {
  std::string objects = "{}";
  for (int i = 0; i < 100000; ++i) objects += ",{}";
  const auto many = [&](const std::string& shape) {
    return said_of_scene(R"({"defaults": {"paint": 1, "shape": )" + shape + "}, \"objects\": [" +
                         objects + "]}");
  };
  EXPECT_EQ(many(R"({"cube": {"half_edge": 1}})"), "scene 's': 65537 objects, more than 65536");
  EXPECT_EQ(many(R"({"ball": {"radius": 99, "bands": 45}})"),
            "scene 's': 526500 faces, more than 524288");
  // Vertices of no face, and shadings of no face.
  const ScratchFolder folder;
  std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (int i = 3; i < 8192; ++i) mesh += "v 0 0 0\n";
  std::ofstream(folder.path("many.obj")) << mesh;
  const std::string text =
      R"({"defaults": {"paint": 1, "shape": {"obj": "many.obj"}}, "objects": [)" + objects + "]}";
  EXPECT_EQ(xsharp_test::refusal([&] { parse_scene(text, "s", folder.path()); }),
            "scene 's': 2105344 vertices, more than 2097152");
  std::string shadings = "{}";
  for (int i = 1; i < 1000; ++i) shadings += ",{}";
  EXPECT_EQ(many(R"({"cube": {"half_edge": 1}}, "shadings": [)" + shadings + "]"),
            "scene 's': object 'object 0': 1000 shadings for 6 faces");
}

TEST(SceneJson, DrawsEachOfManyObjects) {
  // 150 columns and 134 rows of cubes in view, none before another.
  constexpr std::size_t count = 20'000;
  std::string objects;
  for (std::size_t i = 0; i < count; ++i) {
    const auto column = static_cast<int>(i % 150);
    const auto row = static_cast<int>(i / 150);
    objects += (i == 0 ? "" : ",") + std::string(R"({"position": [)") +
               std::to_string(6 * column - 447) + "," + std::to_string(6 * row - 399) + ",-2000]}";
  }
  const Scene scene =
      parse_scene(R"({"width": 4096, "height": 4096, )"
                  R"("defaults": {"paint": 1, "shape": {"cube": {"half_edge": 1}}}, "objects": [)" +
                      objects + "]}",
                  "many", root);
  Animation<fixproof::q16_16_i386> animation(scene);
  Picture picture;
  animation.draw(picture);
  std::vector<bool> drawn(count);
  for (const Polygon& polygon : picture.polygons) drawn.at(polygon.object) = true;
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(drawn, true)), count);
}

TEST(SceneJson, NamesTheFile) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.path("s.json");
  std::ofstream(file) << R"({"objects": [], "projection_ratio": 0})";
  EXPECT_EQ(xsharp_test::refusal([&] { read_scene(file); }),
            file.string() + ": scene 's': projection_ratio is 0, must be from -1000 to -0.01");
  std::ofstream(file) << std::string((1U << 24U) + 1, ' ');
  EXPECT_EQ(xsharp_test::refusal([&] { read_scene(file); }),
            file.string() + ": longer than 16 MiB");
}

TEST(SceneJson, OutlivesAnyBytes) {
  std::vector<std::string> texts;
  for (const char* name : {"ball_and_cubes.json", "highlight.json", "look_at.json",
                           "shaded_ball.json", "solid.json"}) {
    texts.push_back(contents(root / "xsharp" / "scenes" / name));
    ASSERT_EQ(said_of_scene(texts.back()), "accepted");
  }
  ASSERT_TRUE(rc::check([&] {
    std::string text = *rc::gen::elementOf(texts);
    for (int i = *rc::gen::inRange(1, 6); i > 0; --i) {
      const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
      text[at] = *rc::gen::weightedOneOf<char>(
          {{1, rc::gen::arbitrary<char>()},
           {3, rc::gen::element('0', '9', '-', '.', 'e', ',', ' ', '"', '[', ']', '{', '}')}});
    }
    RC_CLASSIFY(said_of_scene(text) == "accepted");
  }));
}

}  // namespace

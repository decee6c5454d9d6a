/// Tests the keys for highlights and for what faces a point, and the message for each bad value.
#include "tests/support/test.hpp"
#include "tests/xsharp/scenes/refusal.hpp"
#include "xsharp/files/scene_json.hpp"

namespace {

using namespace xsharp;

Scene scene_of(const std::string& text) { return parse_scene(text, "s", {}); }
std::string said(const std::string& text) {
  return xsharp_test::refusal([&] { scene_of(text); });
}
std::string orange_cube_with(const std::string& keys) {
  return R"({"objects": [{"shape": {"cube": {"half_edge": 9}}, "paint": "#ff8000", )" + keys +
         "}]}";
}
std::string highlight_of(const std::string& highlight) {
  return orange_cube_with(R"("shading": {"highlight": )" + highlight + "}");
}

TEST(LightJson, ReadsHighlights) {
  const Scene scene = scene_of(
      R"({"objects": [{"shape": {"cube": {"half_edge": 9}}, "paint": "#ffffff",
          "shadings": [{}, {"diffuse": true}, {"highlight": {"exponent": 1, "strength": 1}},
                       {"ambient": true, "highlight": {"exponent": 1000, "strength": 0}},
                       {"highlight": {"strength": 0.25, "exponent": 12.5}}, {"ambient": true}]}]})");
  const ObjectDescription& cube = scene.objects.at(0);
  for (std::size_t face = 0; face < 6; ++face) {
    EXPECT_EQ(cube.shadings.at(face).highlight.has_value(), face >= 2 && face <= 4) << face;
    // Only faces with diffuse light or a highlight need a normal.
    EXPECT_EQ(cube.mesh.faces.at(face).normal_end.has_value(), face >= 1 && face <= 4) << face;
  }
  EXPECT_EQ(cube.shadings[4].highlight->exponent, 12.5);
  EXPECT_EQ(cube.shadings[4].highlight->strength, 0.25);
}

TEST(LightJson, RefusesHighlights) {
  const std::string place = "objects[0].shading.highlight";
  const std::string face = "scene 's': object 'object 0': face 0: highlight.";
  const std::vector<std::pair<std::string, std::string>> table{
      {"true", place + ": must be an object {…}, not true"},
      {"[8, 1]", place + ": must be an object {…}, not [8,1]"},
      {"{}", place + ": must have the key \"exponent\""},
      {R"({"exponent": 8})", place + ": must have the key \"strength\""},
      {R"({"strength": 1})", place + ": must have the key \"exponent\""},
      {R"({"exponent": 8, "strength": 1, "color": 1})",
       place + ": unknown key \"color\"; choose one of exponent, strength"},
      {R"({"exponent": 8, "exponent": 9, "strength": 1})",
       "the key \"exponent\" occurs twice in one object"},
      {R"({"exponent": "8", "strength": 1})", place + ".exponent: must be a number, not \"8\""},
      {R"({"exponent": 8, "strength": null})", place + ".strength: must be a number, not null"},
      {R"({"exponent": 0.99, "strength": 1})", face + "exponent is 0.99, must be from 1 to 1000"},
      {R"({"exponent": -8, "strength": 1})", face + "exponent is -8, must be from 1 to 1000"},
      {R"({"exponent": 1001, "strength": 1})", face + "exponent is 1001, must be from 1 to 1000"},
      {R"({"exponent": 1e308, "strength": 1})",
       face + "exponent is 1e+308, must be from 1 to 1000"},
      {R"({"exponent": 8, "strength": -0.5})", face + "strength is -0.5, must be from 0 to 1"},
      {R"({"exponent": 8, "strength": 1.5})", face + "strength is 1.5, must be from 0 to 1"},
  };
  for (const auto& [highlight, message] : table) {
    EXPECT_EQ(said(highlight_of(highlight)), message) << highlight;
  }
  EXPECT_EQ(said(R"({"objects": [{"shape": {"cube": {"half_edge": 9}}, "paint": 3,
                     "shading": {"highlight": {"exponent": 8, "strength": 1}}}]})"),
            "scene 's': object 'object 0': face 0 answers to light, so its paint must be a colour");
}

TEST(LookAtJson, ReadsPoints) {
  const Scene scene = scene_of(
      R"({"camera": {"position": [1, 2, 3], "look_at": [4, 5.5, -16384]},
          "defaults": {"shape": {"cube": {"half_edge": 9}}, "paint": 1, "look_at": [1, 2, 3]},
          "objects": [{}, {"look_at": [0, 16384, -0.5]}]})");
  EXPECT_EQ(scene.camera.look_at, (Triple{4, 5.5, -16384}));
  EXPECT_EQ(scene.objects.at(0).look_at, (Triple{1, 2, 3}));
  EXPECT_EQ(scene.objects.at(1).look_at, (Triple{0, 16384, -0.5}));
  EXPECT_FALSE(scene_of(R"({"objects": []})").camera.look_at);
}

TEST(LookAtJson, RefusesPoints) {
  const std::string object = "scene 's': object 'object 0': ";
  EXPECT_EQ(said(orange_cube_with(R"("look_at": [0, 0])")),
            "objects[0].look_at: must be a list of 3, not [0,0]");
  EXPECT_EQ(said(orange_cube_with(R"("look_at": "ball")")),
            "objects[0].look_at: must be a list of 3, not \"ball\"");
  EXPECT_EQ(said(orange_cube_with(R"("look_at": [0, true, 0])")),
            "objects[0].look_at[1]: must be a number, not true");
  EXPECT_EQ(said(orange_cube_with(R"("look_at": [0, 0, 16385])")),
            object + "look_at is 16385, must be from -16384 to 16384");
  EXPECT_EQ(said(orange_cube_with(R"("look_at": [1e308, 0, 0])")),
            object + "look_at is 1e+308, must be from -16384 to 16384");
  EXPECT_EQ(said(orange_cube_with(R"("look_at": [0, 0, 0], "spin": {"tenths": [0, 1, 0]})")),
            object + "must not have both spin and look_at");
  EXPECT_EQ(said(orange_cube_with(R"("look_at": [0, 0, 0], "spin": {"tenths": [0, 0, 0]})")),
            "accepted");
  const auto of_camera = [](const std::string& keys) {
    return said(R"({"objects": [], "camera": {)" + keys + "}}");
  };
  EXPECT_EQ(of_camera(R"("look_at": 5)"), "camera.look_at: must be a list of 3, not 5");
  EXPECT_EQ(of_camera(R"("look_at": [0, -16385, 0])"),
            "scene 's': camera: look_at is -16385, must be from -16384 to 16384");
  EXPECT_EQ(of_camera(R"("look_at": [0, 0, -1], "turn_tenths": [0, 0, 1])"),
            "scene 's': camera: must not have both turn_tenths and look_at");
  EXPECT_EQ(of_camera(R"("look_at": [1, 2, 3], "position": [1, 2, 3])"),
            "scene 's': camera: look_at must be at least 2^-14 away from position");
  EXPECT_EQ(of_camera(R"("look_at": [1, 2, 1e-300], "position": [1, 2, 0])"),
            "scene 's': camera: look_at must be at least 2^-14 away from position");
  EXPECT_EQ(of_camera(R"("look_at": [16384, 16384, 16384], "position": [-16384, -16384, -16384])"),
            "accepted");
}

}  // namespace

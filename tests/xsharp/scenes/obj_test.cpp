/// Tests bodies from Wavefront OBJ files, and invalid files.
#include "xsharp/files/obj.hpp"

#include <rapidcheck.h>

#include <filesystem>
#include <fstream>

#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"
#include "tests/xsharp/scenes/refusal.hpp"
#include "xsharp/validate_mesh.hpp"

namespace {

using namespace xsharp;
using xsharp_test::refusal;

const std::string tetrahedron =
    "# comment\r\nmtllib /nothing/there.mtl\r\no body\r\n"
    "v 1 1 1\r\nv -1 -1 1 0.5\r\nv -1 1 -1\r\nv 1.0 -1e0 -1 1 0 0\r\n"
    "vn 0 0 1\nvt 0.5 0.5\ng a b\nusemtl none\n"
    "f 1/1/1 3//1 2/1\nf 1 2 4\n  f -4 -1 -2\nf 2 3 4\nl 1 2\n";

TEST(Obj, ReadsFacesClockwise) {
  const Mesh mesh = parse_obj(tetrahedron);
  const std::vector<Triple> vertices{{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
  EXPECT_EQ(mesh.vertices, vertices);
  ASSERT_EQ(mesh.faces.size(), 4U);
  EXPECT_EQ(mesh.faces[0].vertices, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(mesh.faces[1].vertices, (std::vector<std::size_t>{0, 3, 1}));
  EXPECT_EQ(mesh.faces[2].vertices, (std::vector<std::size_t>{0, 2, 3}));
  EXPECT_EQ(mesh.faces[3].vertices, (std::vector<std::size_t>{1, 3, 2}));
  EXPECT_NO_THROW(validate_mesh(mesh));
}

TEST(Obj, KeepsPolygonsWhole) {
  const Mesh mesh = parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4");
  ASSERT_EQ(mesh.faces.size(), 1U);
  EXPECT_EQ(mesh.faces[0].vertices, (std::vector<std::size_t>{0, 3, 2, 1}));
}

std::string said_of_obj(const std::string& text) {
  return refusal([&] { parse_obj(text); });
}

TEST(Obj, SaysWhatIsWrong) {
  const std::string places = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(said_of_obj(""), "the file has no faces");
  EXPECT_EQ(said_of_obj(places), "the file has no faces");
  EXPECT_EQ(said_of_obj("v 0 0 0\r\nv 1 2\r\n"),
            "line 2: a vertex must have three numbers, not \"\"");
  EXPECT_EQ(said_of_obj("v 0 0 x1"), "line 1: a vertex must have three numbers, not \"x1\"");
  EXPECT_EQ(said_of_obj("\n\nv 0 nan 0"), "line 3: a vertex must have three numbers, not \"nan\"");
  EXPECT_EQ(said_of_obj("v inf 0 0"), "line 1: a vertex must have three numbers, not \"inf\"");
  EXPECT_EQ(said_of_obj("v 0 0 1e999"), "line 1: a vertex must have three numbers, not \"1e999\"");
  EXPECT_EQ(said_of_obj("v 0 0 0\nv 0 0e999 0"), "vertex 2 is not finite");
  EXPECT_EQ(said_of_obj(places + "f 1 2"), "face 0 has 2 vertices, must have 3 to 16");
  EXPECT_EQ(said_of_obj(places + "f 1 2 3 1 2 3 1 2 3 1 2 3 1 2 3 1 2"),
            "face 0 has 17 vertices, must have 3 to 16");
  EXPECT_EQ(said_of_obj(places + "f 1 2 3\nf 1 2 4"), "face 1 has vertex 4 of 3 so far");
  EXPECT_EQ(said_of_obj(places + "f 1 2 3\nf "),
            "line 5: a face must have vertex numbers, not \"\"");
  EXPECT_EQ(said_of_obj(places + "f 1 2 0"), "line 4: a face must have vertex numbers, not \"0\"");
  EXPECT_EQ(said_of_obj(places + "f 1 2 -4"), "face 0 has vertex -4 of 3 so far");
  EXPECT_EQ(said_of_obj(places + "f 1/2 2//1 3/-1/2"), "accepted");
  for (const std::string word : {"a", "3.7", "3x", "99999999999", "3/", "3/x", "3//", "3/1/", "/1",
                                 "3/1/1/1", "+3", "\\", "#"}) {
    EXPECT_EQ(said_of_obj(places + "f 1 2 3 " + word),
              "line 4: a face must have vertex numbers, not \"" + word + '"');
  }
}

TEST(Obj, StopsAtTheLimits) {
  std::string text;
  for (int i = 0; i < 8192; ++i) text += "v 0 0 0\n";
  EXPECT_EQ(said_of_obj(text + "f 1 2 3"), "accepted");
  EXPECT_EQ(said_of_obj(text + "v 0 0 0\nf 1 2 3"), "more than 8192 vertices");
  text = "v 0 0 0\n";
  for (int i = 0; i < 4096; ++i) text += "f 1 1 1\n";
  EXPECT_EQ(said_of_obj(text), "accepted");
  EXPECT_EQ(said_of_obj(text + "f 1 1 1"), "more than 4096 faces");
}

TEST(Obj, HasNoZeroByte) {
  EXPECT_EQ(said_of_obj(tetrahedron + std::string(1, '\0')), "a zero byte in the text");
  EXPECT_EQ(refusal([] { read_obj(".", std::string("a.obj\0", 6)); }),
            "the name of an OBJ file has a zero byte");
}

TEST(Obj, NamesTheFile) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.path("a.obj");
  const auto read = [&] {
    return refusal([&] { read_obj(file.parent_path(), file.filename().string()); });
  };
  EXPECT_EQ(read(), file.string() + ": there is no such file");
  std::ofstream(file) << "v 0 0 0\n";
  EXPECT_EQ(read(), file.string() + ": the file has no faces");
  std::ofstream(file, std::ios::app) << std::string((4U << 20U) - 8, '\n');
  EXPECT_EQ(read(), file.string() + ": the file has no faces");
  std::ofstream(file, std::ios::app) << '\n';
  EXPECT_EQ(read(), file.string() + ": longer than 4 MiB");
  EXPECT_EQ(refusal([] { read_obj("/dev", "zero"); }), "/dev/zero: not a regular file");
}

TEST(Obj, OutlivesAnyBytes) {
  ASSERT_TRUE(rc::check([] {
    std::string text = tetrahedron;
    const int changes = *rc::gen::inRange(1, 20);
    for (int i = 0; i < changes; ++i) {
      const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
      text[at] = *rc::gen::weightedOneOf<char>(
          {{1, rc::gen::arbitrary<char>()},
           {3, rc::gen::element('\n', '\r', '\0', ' ', '/', '-', '0', '9', 'e', '.', 'f', 'v')}});
    }
    try {
      const Mesh mesh = parse_obj(text);
      RC_ASSERT(!mesh.faces.empty());
      for (const Face& face : mesh.faces) {
        for (const auto index : face.vertices) RC_ASSERT(index < mesh.vertices.size());
      }
      validate_mesh(mesh);
    } catch (const SceneError&) {
    }
  }));
}

}  // namespace

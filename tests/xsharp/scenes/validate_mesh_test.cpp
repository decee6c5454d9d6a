/// Tests meshes that are not convex bodies, with the error message of each.
#include "xsharp/validate_mesh.hpp"

#include <rapidcheck.h>

#include "tests/support/test.hpp"
#include "tests/xsharp/scenes/refusal.hpp"
#include "xsharp/shapes.hpp"

namespace {

using namespace xsharp;
using xsharp_test::infinity;
using xsharp_test::nan;

std::string said(const Mesh& mesh) {
  return xsharp_test::refusal([&] { validate_mesh(mesh); });
}

TEST(ValidateMesh, AcceptsShapes) {
  EXPECT_EQ(said(cube(15)), "accepted");
  EXPECT_EQ(said(with_normals(cube(15))), "accepted");
  EXPECT_EQ(said(cube(4729)), "accepted");
  EXPECT_EQ(said(cube(0.001)), "accepted");
  for (int bands = 2; bands <= max_bands; ++bands) {
    EXPECT_EQ(said(with_normals(ball(60, bands))), "accepted") << bands;
  }
  // A single face with as many corners as allowed.
  Mesh disc{{}, {{{}}}};
  for (int i = 0; i < 16; ++i) {
    disc.vertices.push_back({std::sin(i * 0.39), std::cos(i * 0.39), 0});
    disc.faces[0].vertices.push_back(static_cast<std::size_t>(i));
  }
  EXPECT_EQ(said(disc), "accepted");
}

TEST(ValidateMesh, AcceptsCoordinatesThatAreRounded) {
  ASSERT_TRUE(rc::check([] {
    Mesh mesh = ball(*rc::gen::inRange(1, 8000), *rc::gen::inRange(2, 12));
    // The published conversion moves coordinates by at most one ulp of 16.16.
    for (Triple& vertex : mesh.vertices) {
      for (double& x : vertex) x = std::trunc(x * 65536.0 + 0.5) / 65536.0;
    }
    RC_ASSERT(said(mesh) == "accepted");
    RC_ASSERT(said(with_normals(mesh)) == "accepted");
  }));
}

struct BadMesh {
  std::string message;
  std::function<void(Mesh&)> spoil;
};

/// Modifications that spoil the cube of half edge 15, with their messages.
const std::vector<BadMesh>& bad_meshes() {
  static const std::vector<BadMesh> table{
      {"the mesh has no faces", [](Mesh& m) { m.faces.clear(); }},
      {"the mesh has 4097 faces, more than 4096",
       [](Mesh& m) { m.faces.resize(4097, m.faces[0]); }},
      {"the mesh has 8193 vertices, more than 8192", [](Mesh& m) { m.vertices.resize(8193); }},
      {"vertex 3 is not finite", [](Mesh& m) { m.vertices[3][1] = nan; }},
      {"vertex 0 is not finite", [](Mesh& m) { m.vertices[0][2] = -infinity; }},
      {"vertex 8 is 8193 from the origin of the body, more than 8192",
       [](Mesh& m) {
         m.vertices.push_back({0, -8193, 0});
       }},
      {"vertex 7 is 1e+300 from the origin of the body, more than 8192",
       [](Mesh& m) { m.vertices[7][0] = 1e300; }},
      {"face 2 has 2 vertices, fewer than 3", [](Mesh& m) { m.faces[2].vertices.resize(2); }},
      {"face 5 has 0 vertices, fewer than 3", [](Mesh& m) { m.faces[5].vertices.clear(); }},
      {"face 1 has 17 vertices, more than 16", [](Mesh& m) { m.faces[1].vertices.resize(17); }},
      {"face 3 has vertex 8 of 8", [](Mesh& m) { m.faces[3].vertices[1] = 8; }},
      {"face 3 has vertex 18446744073709551615 of 8",
       [](Mesh& m) { m.faces[3].vertices[1] = SIZE_MAX; }},
      {"face 3 has vertex 9 of 8", [](Mesh& m) { m.faces[3].normal_end = 9; }},
      {"face 0 has vertices 3 and 3 at one place", [](Mesh& m) { m.faces[0].vertices[2] = 3; }},
      {"face 0 has vertices 1 and 3 at one place",
       [](Mesh& m) {
         m.vertices[3] = {15, 15.0005, -15};
       }},
      {"face 0 has no area",
       [](Mesh& m) {
         m.vertices.push_back({15, 0, -15});
         m.faces[0].vertices = {1, 3, 8};
       }},
      {"face 0 has no area",
       [](Mesh& m) {
         m.faces[0].vertices = {1, 3, 0, 2};
       }},
      // The diagonals span a plane with normal 1800 90 90; the distance is 3 / 4 * 1800 / |1800 90
      // 90|.
      {"face 0 is not flat: vertex 1 is 0.748132 off its plane",
       [](Mesh& m) { m.vertices[1][0] = 12; }},
      {"face 0 is not convex: vertex 1 is outside the edge that begins at vertex 2",
       [](Mesh& m) {
         m.vertices.push_back({15, -5, -5});
         m.faces[0].vertices = {3, 2, 8, 1};
       }},
      {"face 0 begins at vertex 8, where it has no corner",
       [](Mesh& m) {
         m.vertices.push_back({15, 0, -15});
         m.faces[0].vertices = {8, 3, 2, 0, 1};
       }},
      {"face 0 faces into the body: its vertices run the wrong way round",
       [](Mesh& m) { std::ranges::reverse(m.faces[0].vertices); }},
      {"face 4 faces into the body: its vertices run the wrong way round",
       [](Mesh& m) { std::ranges::reverse(m.faces[4].vertices); }},
      {"face 0: the body is not convex: vertex 8 is 60 before the face",
       [](Mesh& m) {
         for (std::size_t i = 0; i < 8; ++i) {
           m.vertices.push_back({m.vertices[i][0] + 60, m.vertices[i][1], m.vertices[i][2]});
         }
         for (std::size_t i = 0; i < 6; ++i) {
           Face face = m.faces[i];
           for (std::size_t& vertex : face.vertices) vertex += 8;
           m.faces.push_back(face);
         }
       }},
  };
  return table;
}

TEST(ValidateMesh, RefusesWhatIsNoBody) {
  for (const auto& [message, spoil] : bad_meshes()) {
    Mesh mesh = cube(15);
    spoil(mesh);
    EXPECT_EQ(said(mesh), message);
  }
}

TEST(ValidateMesh, RefusesWrongNormals) {
  // Face 0 faces +x; its normal starts at 15 15 -15.
  const auto with_end = [](const Triple& end) {
    Mesh mesh = with_normals(cube(15));
    mesh.vertices[*mesh.faces[0].normal_end] = end;
    return said(mesh);
  };
  EXPECT_EQ(with_end({16, 15, -15}), "accepted");
  EXPECT_EQ(with_end({16.0002, 15, -15}), "accepted");
  EXPECT_EQ(with_end({16.0003, 15, -15}), "face 0 has a normal of length 1.0003 instead of 1");
  EXPECT_EQ(with_end({15.5, 15, -15}), "face 0 has a normal of length 0.5 instead of 1");
  EXPECT_EQ(with_end({14, 15, -15}),
            "face 0 has a normal that is not at right angles to it, outward");
  EXPECT_EQ(with_end({15.8, 15.6, -15}),
            "face 0 has a normal that is not at right angles to it, outward");
}

TEST(ValidateMesh, OutlivesAnyMesh) {
  ASSERT_TRUE(rc::check([] {
    Mesh mesh;
    const auto coordinate = rc::gen::weightedOneOf<double>(
        {{4, rc::gen::cast<double>(rc::gen::inRange(-3, 4))},
         {1, rc::gen::arbitrary<double>()},
         {1, rc::gen::element(nan, infinity, -infinity, 1e308, -1e308, 5e-324, 1e-160)}});
    for (int i = *rc::gen::inRange(0, 9); i > 0; --i) {
      mesh.vertices.push_back({*coordinate, *coordinate, *coordinate});
    }
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
      mesh.faces.push_back(
          {*rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(0, 9))});
    }
    const std::string message = said(mesh);
    RC_CLASSIFY(message == "accepted");
  }));
}

}  // namespace

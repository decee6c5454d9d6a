/// Tests the published order of cube and ball, and the properties of every ball.
#include "xsharp/shapes.hpp"

#include <rapidcheck.h>

#include "tests/support/test.hpp"

namespace {

using namespace xsharp;

TEST(Cube, HasThePublishedOrder) {
  const Mesh mesh = cube(15);
  const std::vector<Triple> vertices{{15, 15, 15},   {15, 15, -15},  {15, -15, 15},
                                     {15, -15, -15}, {-15, 15, 15},  {-15, 15, -15},
                                     {-15, -15, 15}, {-15, -15, -15}};
  EXPECT_EQ(mesh.vertices, vertices);
  const std::vector<std::vector<std::size_t>> faces{{1, 3, 2, 0}, {5, 7, 3, 1}, {4, 5, 1, 0},
                                                    {3, 7, 6, 2}, {5, 4, 6, 7}, {0, 2, 6, 4}};
  ASSERT_EQ(mesh.faces.size(), faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    EXPECT_EQ(mesh.faces[i].vertices, faces[i]);
    EXPECT_FALSE(mesh.faces[i].normal_end);
  }
}

/// The rule of mesh.hpp: the cross product of the first and last edge, on a screen with y downward.
bool shows(const Mesh& mesh, const Face& face, const Triple& place) {
  const auto on_screen = [&](std::size_t index) {
    const Triple& v = mesh.vertices[index];
    const double z = v[2] + place[2];
    return std::pair(160 - 320 * (v[0] + place[0]) / z, 120 + 320 * (v[1] + place[1]) / z);
  };
  const auto first = on_screen(face.vertices[0]);
  const auto next = on_screen(face.vertices[1]);
  const auto last = on_screen(face.vertices.back());
  return (next.first - first.first) * (last.second - first.second) -
             (next.second - first.second) * (last.first - first.first) >
         0;
}

TEST(Cube, ShowsTheFacesTurnedToTheViewer) {
  // The outward direction of each face.
  const std::vector<Triple> outside{{1, 0, 0},  {0, 0, -1}, {0, 1, 0},
                                    {0, -1, 0}, {-1, 0, 0}, {0, 0, 1}};
  const Mesh mesh = cube(15);
  for (const Triple& place : std::vector<Triple>{{0, 0, -300}, {90, 40, -200}, {-70, -60, -150}}) {
    for (std::size_t i = 0; i < outside.size(); ++i) {
      // The face is visible if the viewer, at the origin, is beyond its plane.
      double beyond = -15;
      for (std::size_t axis = 0; axis < 3; ++axis) beyond -= outside[i][axis] * place[axis];
      EXPECT_EQ(shows(mesh, mesh.faces[i], place), beyond > 0) << i << " at " << place[0];
    }
  }
}

TEST(Ball, OfSixBandsHasThePublished72Faces) {
  const Mesh mesh = ball(40, 6);
  EXPECT_EQ(mesh.faces.size(), 72U);
  EXPECT_EQ(mesh.vertices.size(), 62U);
}

// By hand for two bands, whose one circle is the equator: from -x by +z to +x and back.
TEST(Ball, BeginsAtMinusXAndGoesRoundByPlusZ) {
  const Mesh mesh = ball(10, 2);
  EXPECT_TRUE(mesh.computed);
  const std::vector<Triple> places{{0, 10, 0}, {-10, 0, 0}, {0, 0, 10},
                                   {10, 0, 0}, {0, 0, -10}, {0, -10, 0}};
  ASSERT_EQ(mesh.vertices.size(), places.size());
  for (std::size_t v = 0; v < places.size(); ++v) {
    EXPECT_LT(length(difference(mesh.vertices[v], places[v])), 1e-12) << v;
  }
  const std::vector<std::vector<std::size_t>> faces{{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 1, 4},
                                                    {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {4, 1, 5}};
  ASSERT_EQ(mesh.faces.size(), faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) EXPECT_EQ(mesh.faces[i].vertices, faces[i]) << i;
}

TEST(Ball, RefusesOtherBands) {
  EXPECT_THROW(static_cast<void>(ball(1, 1)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(ball(1, -6)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(ball(1, max_bands + 1)), std::invalid_argument);
  EXPECT_EQ(ball(1, max_bands).faces.size(), 4050U);
}

struct AnyBall {
  int bands;
  double radius;
  Mesh mesh;
};

AnyBall any_ball() {
  const int bands = *rc::gen::inRange(2, 16);
  const double radius = *rc::gen::inRange(1, 8000 * 16) / 16.0;
  return {bands, radius, ball(radius, bands)};
}

void property(const std::function<void()>& holds) { ASSERT_TRUE(rc::check(holds)); }

TEST(Ball, HasItsVerticesOnTheSphereAndFacesInOrder) {
  property([] {
    const AnyBall any = any_ball();
    const int bands = any.bands;
    const double radius = any.radius;
    const Mesh& mesh = any.mesh;
    const auto around = static_cast<std::size_t>(2 * bands);
    RC_ASSERT(mesh.faces.size() == around * static_cast<std::size_t>(bands));
    for (const Triple& v : mesh.vertices) {
      RC_ASSERT(std::fabs(std::hypot(v[0], v[1], v[2]) - radius) <= radius * 1e-12);
    }
    // Faces go from pole to pole, band by band.
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
      const bool polar = i < around || i >= mesh.faces.size() - around;
      RC_ASSERT(mesh.faces[i].vertices.size() == (polar ? 3U : 4U));
      if (i < around) continue;
      const auto height = [&](std::size_t face) {
        double sum = 0;
        for (const auto v : mesh.faces[face].vertices) sum += mesh.vertices[v][1];
        return sum / static_cast<double>(mesh.faces[face].vertices.size());
      };
      RC_ASSERT(height(i) < height(i - around));
    }
  });
}

TEST(Ball, IsClosed) {
  property([] {
    const AnyBall any = any_ball();
    const Mesh& mesh = any.mesh;
    // Every edge has two faces, which traverse it in opposite directions.
    std::set<std::pair<std::size_t, std::size_t>> ways;
    for (const Face& face : mesh.faces) {
      for (std::size_t i = 0; i < face.vertices.size(); ++i) {
        const auto next = face.vertices[(i + 1) % face.vertices.size()];
        RC_ASSERT(ways.emplace(face.vertices[i], next).second);
      }
    }
    for (const auto& [from, to] : ways) RC_ASSERT(ways.contains(std::pair(to, from)));
    RC_ASSERT(mesh.vertices.size() + mesh.faces.size() == ways.size() / 2 + 2);
  });
}

/// Six times the volume of the tetrahedron a b c d; positive if b c d are clockwise seen from a.
double volume(const Triple& a, const Triple& b, const Triple& c, const Triple& d) {
  std::array<std::array<double, 3>, 3> m{};
  for (std::size_t i = 0; i < 3; ++i) m[i] = {b[i] - a[i], c[i] - a[i], d[i] - a[i]};
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

TEST(Ball, IsConvexWithFlatFacesClockwiseFromOutside) {
  property([] {
    const AnyBall any = any_ball();
    const double radius = any.radius;
    const Mesh& mesh = any.mesh;
    const double rounding = radius * radius * radius * 1e-12;
    for (const Face& face : mesh.faces) {
      const auto& v = face.vertices;
      for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const double side =
            volume(mesh.vertices[i], mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]);
        const bool of_face = std::find(v.begin(), v.end(), i) != v.end();
        // The vertices are counterclockwise from inside.
        RC_ASSERT((of_face ? std::fabs(side) <= rounding : side < -rounding));
      }
    }
  });
}

TEST(Ball, NormalsAreUnitAndPointOutward) {
  property([] {
    const AnyBall any = any_ball();
    const double radius = any.radius;
    const Mesh& plain = any.mesh;
    const Mesh mesh = with_normals(plain);
    RC_ASSERT(mesh.vertices.size() == plain.vertices.size() + plain.faces.size());
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
      const Face& face = mesh.faces[i];
      RC_ASSERT(face.vertices == plain.faces[i].vertices);
      RC_ASSERT(face.normal_end == plain.vertices.size() + i);
      const Triple& start = mesh.vertices[face.vertices[0]];
      const Triple& end = mesh.vertices[*face.normal_end];
      Triple middle{};
      for (const auto v : face.vertices) {
        for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] += mesh.vertices[v][axis];
      }
      double square = 0;
      double outward = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double component = end[axis] - start[axis];
        square += component * component;
        outward += component * middle[axis];
      }
      RC_ASSERT(std::fabs(square - 1) < 1e-6);
      RC_ASSERT(outward > 0);
      for (const auto v : face.vertices) {
        double along = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          along += (end[axis] - start[axis]) * (mesh.vertices[v][axis] - start[axis]);
        }
        RC_ASSERT(std::fabs(along) <= radius * 1e-9);
      }
    }
  });
}

TEST(Normals, OfACubePointAlongTheAxes) {
  const Mesh mesh = with_normals(cube(15));
  ASSERT_EQ(mesh.vertices.size(), 14U);
  // Face 1 3 2 0 starts at vertex 1 and faces +x; face 0 2 6 4 starts at vertex 0 and faces +z.
  EXPECT_EQ(mesh.vertices[8], (Triple{16, 15, -15}));
  EXPECT_EQ(mesh.vertices[13], (Triple{15, 15, 16}));
}

TEST(Normals, OfAFaceWithoutAreaHaveNoLength) {
  const Mesh mesh = with_normals({{{1, 2, 3}, {2, 4, 6}, {3, 6, 9}}, {{{0, 1, 2}}, {{}}}});
  ASSERT_EQ(mesh.vertices.size(), 4U);
  EXPECT_EQ(mesh.vertices[3], mesh.vertices[0]);
}

}  // namespace

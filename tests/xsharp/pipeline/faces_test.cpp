/// Tests which faces of a body are visible, and that visible faces leave no holes.
#include "tests/support/test.hpp"
#include "tests/xsharp/pipeline/draws.hpp"
#include "tests/xsharp/pipeline/matrix.hpp"
#include "tests/xsharp/pipeline/stage.hpp"
#include "tests/xsharp/pipeline/types.hpp"
#include "tests/xsharp/raster/definition.hpp"
#include "xsharp/polyhedron.hpp"

namespace xsharp {
namespace {

using draws::Integers;
using ScreenPoints = std::vector<ScreenPoint>;

/// Twice the area; positive if corners turn from positive x to positive y.
std::int64_t area(const ScreenPoints& points) {
  std::int64_t sum = 0;
  for (std::size_t i = 2; i < points.size(); ++i) {
    const auto [ax, ay] = std::pair{std::int64_t{points[i - 1].x} - points[0].x,
                                    std::int64_t{points[i - 1].y} - points[0].y};
    const auto [bx, by] =
        std::pair{std::int64_t{points[i].x} - points[0].x, std::int64_t{points[i].y} - points[0].y};
    sum += ax * by - ay * bx;
  }
  return sum;
}

bool faces_viewer(const ScreenPoints& polygon) {
  return xsharp::faces_viewer(polygon[0], polygon[1], polygon.back());
}

TEST(FacesViewer, IsTheSignOfTheAreaOfAConvexPolygon) {
  const auto check = [](const Integers& drawn) {
    ScreenPoints points;
    for (std::size_t i = 0; i + 1 < drawn.size(); i += 2) {
      points.push_back(
          {static_cast<std::int32_t>(drawn[i]), static_cast<std::int32_t>(drawn[i + 1])});
    }
    points = definition::hull(points);
    if (points.size() < 3) return true;
    bool agree = true;
    for (std::size_t start = 0; start < points.size(); ++start) {
      std::rotate(points.begin(), points.begin() + 1, points.end());
      const ScreenPoints other_way(points.rbegin(), points.rend());
      for (const ScreenPoints& polygon : {points, other_way}) {
        agree = agree && faces_viewer(polygon) == (area(polygon) > 0) &&
                shows_front_area(polygon) == (area(polygon) > 0);
      }
    }
    return agree;
  };
  EXPECT_TRUE(draws::hold(12, -5, 5, check));
  EXPECT_TRUE(draws::hold(16, -40000, 40000, check));
}

TEST(FacesViewer, ClockwiseOnTheScreenIsTheFront) {
  EXPECT_TRUE(faces_viewer(ScreenPoints{{0, 0}, {9, 0}, {9, 9}, {0, 9}}));
  EXPECT_FALSE(faces_viewer(ScreenPoints{{0, 9}, {9, 9}, {9, 0}, {0, 0}}));
  EXPECT_FALSE(faces_viewer(ScreenPoints{{0, 0}, {4, 4}, {8, 8}}));
  // The first, the next and the last corner are on a line. Such faces are the black pixels in the
  // balls of docs/scenes.md.
  const ScreenPoints three_on_a_line{{1, 1}, {2, 1}, {2, 2}, {0, 1}};
  EXPECT_FALSE(faces_viewer(three_on_a_line));
  EXPECT_GT(area(three_on_a_line), 0);
  EXPECT_FALSE(shows_front_area(ScreenPoints{{0, 0}, {4, 4}, {8, 8}}));
  EXPECT_FALSE(shows_front_area(ScreenPoints{{1, 2}, {3, 4}}));
}

template <class N>
struct Faces : testing::Test {};
TYPED_TEST_SUITE(Faces, pipeline::scene_types, );

/// The body after one frame with rotation `tenths`, and its Picture.
template <class N>
struct Turned {
  Turned(const ObjectDescription& object, const std::array<std::int32_t, 3>& tenths,
         std::int32_t side)
      : animation(scene_of(object, tenths, side)) {
    animation.move();
    tally = animation.draw(picture);
  }

  static Scene scene_of(ObjectDescription object, const std::array<std::int32_t, 3>& tenths,
                        std::int32_t side) {
    object.spin.tenths = tenths;
    Scene scene = pipeline::scene(side, {object});
    scene.from_scratch = true;
    return scene;
  }

  Animation<N> animation;
  Picture picture;
  Tally tally;
};

/// The sine of the viewing angle of each face, in long double: the viewer's signed distance from
/// the face's plane over its distance from the face. Negative means behind the plane.
std::vector<double> seen_under(const ObjectDescription& object,
                               const std::array<std::int32_t, 3>& tenths) {
  const pipeline::Matrix turn = pipeline::rotation(tenths);
  Mesh mesh = object.mesh;
  for (Triple& vertex : mesh.vertices) {
    Triple turned = object.position;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) turned[i] += static_cast<double>(turn[i][j]) * vertex[j];
    }
    vertex = turned;
  }
  std::vector<double> sines;
  for (const Face& face : mesh.faces) {
    const Triple out = outward_area(mesh, face);
    const Triple& corner = mesh.vertices[face.vertices[0]];
    sines.push_back(-dot(out, corner) / (length(out) * length(corner)));
  }
  return sines;
}

std::array<std::int32_t, 3> angles(const Integers& drawn) {
  return {static_cast<std::int32_t>(drawn[0]), static_cast<std::int32_t>(drawn[1]),
          static_cast<std::int32_t>(drawn[2])};
}

constexpr std::int32_t page_side = 256;

TYPED_TEST(Faces, ShowWhoseNormalPointsToTheViewerAndTileTheSilhouette) {
  using N = TypeParam;
  const ObjectDescription cube = pipeline::body(xsharp::cube(300), {100, -60, -1400});
  EXPECT_TRUE(draws::hold(3, -1800, 1800, [&](const Integers& drawn) {
    const std::vector<double> sines = seen_under(cube, angles(drawn));
    // Below this sine, rounding to pixels is as large as the face is thin.
    for (const double sine : sines) {
      if (std::fabs(sine) < 0.06) return true;
    }
    const Turned<N> turned(cube, angles(drawn), page_side);
    std::vector<std::size_t> expected;
    for (std::size_t face = 0; face < sines.size(); ++face) {
      if (sines[face] > 0) expected.push_back(face);
    }
    const pipeline::Mask times = pipeline::times_covered(turned.picture, page_side);
    const std::ptrdiff_t once = pipeline::pixels(times, 1);
    return turned.animation.state(0).visible == expected && once > 5000 &&
           once + pipeline::pixels(times, 0) == page_side * page_side;
  }));
}

TYPED_TEST(Faces, AWallCloseByHasNoHoles) {
  using N = TypeParam;
  // The wall extends 4000 to every side at distance 20 and turns by up to two degrees. Each clip
  // plane cuts edges that earlier planes have made.
  const ObjectDescription wall = pipeline::plain_body(xsharp::cube(4000), {0, 0, -4020}, 1);
  EXPECT_TRUE(draws::hold(3, -20, 20, [&](const Integers& drawn) {
    const Turned<N> turned(wall, angles(drawn), page_side);
    return turned.tally.out_of_reach == 0 && turned.tally.faults == 0 &&
           pipeline::pixels(pipeline::drawn(turned.picture, page_side), 1) == page_side * page_side;
  }));
}

}  // namespace
}  // namespace xsharp

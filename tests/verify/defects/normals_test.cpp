// Tests how the unprinted generator of the shaded ball spoils its normals.
#include "tests/support/test.hpp"
#include "xsharp/shapes.hpp"

namespace {

using namespace xsharp;

double degrees_between(const Triple& a, const Triple& b) {
  const double angle = std::atan2(length(cross(a, b)), dot(a, b));
  return angle * 180 / std::numbers::pi;
}

// In the generator's order, the edges at a face's first vertex have a cross product that points
// into the ball. Subtracting the vertex therefore lengthens and turns it.
TEST(Defects, WrongNormals) {
  const Mesh body = with_normals(ball(25, 6));
  double least = 180;
  double most = 0;
  for (const Face& face : body.faces) {
    const Triple& base = body.vertices[face.vertices[0]];
    const Triple to_next = difference(body.vertices[face.vertices[1]], base);
    const Triple to_last = difference(body.vertices[face.vertices.back()], base);
    const Triple inward = cross(to_next, to_last);
    const Triple outward = scaled(inward, -1);
    const Triple leaning = scaled(difference(inward, base), -1);
    const double angle = degrees_between(leaning, outward);
    least = std::min(least, angle);
    most = std::max(most, angle);
    // Our normal has length 1 along the cross product.
    const Triple ours = difference(body.vertices[face.normal_end.value()], base);
    EXPECT_NEAR(length(ours), 1, 1e-12);
    EXPECT_NEAR(degrees_between(ours, outward), 0, 1e-6);
  }
  EXPECT_NEAR(least, 2.66, 0.01);
  EXPECT_NEAR(most, 4.25, 0.01);
}

}  // namespace

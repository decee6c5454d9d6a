/// Tests repeated preparation of an object that does not move: its faults and exceptions.
#include "fixed/error.hpp"
#include "tests/support/test.hpp"
#include "tests/xsharp/pipeline/stage.hpp"
#include "tests/xsharp/pipeline/types.hpp"
#include "xsharp/polyhedron.hpp"

namespace xsharp {
namespace {

/// A triangle in front of the viewer with a variable first corner.
Polyhedron<fixproof::q16_16_trapping> with_corner(const Triple& corner) {
  Mesh mesh;
  mesh.vertices = {corner, {0, 10, -40}, {10, 0, -40}};
  mesh.faces = {{.vertices = {0, 1, 2}}};
  return {pipeline::body(std::move(mesh), {}), 0, {}};
}

/// A view that stretches x. The clip volume holds every point behind z = -1.
View<fixproof::q16_16_trapping> stretched(double x, double constant) {
  using N = fixproof::q16_16_trapping;
  View<N> view{.world_to_view = identity<N>()};
  view.world_to_view.rows[0][0] = pipeline::number<N>(x);
  view.projection = {pipeline::number<N>(constant), 160, 120, std::int32_t{1} << 20};
  return view;
}

TEST(Preparing, ThrowsAgain) {
  auto object = with_corner({300, -200, -1.5});
  const auto view = stretched(1, -320);  // 200 times 320 overflows
  for (int frame = 0; frame < 2; ++frame) {
    Tally tally;
    EXPECT_THROW(object.prepare(view, tally), fixproof::overflow_error) << frame;
  }
}

TEST(Preparing, TellsOfFaultsInEveryFrame) {
  auto object = with_corner({-8192, 0, -1});
  const auto view = stretched(4, -1);  // the quotient would be 2^15
  Tally tally;
  for (std::uint64_t frames = 1; frames < 4; ++frames) {
    object.prepare(view, tally);
    EXPECT_EQ(tally.faults, 2 * frames) << "of the vertex, and of the corner of the face";
    EXPECT_EQ(tally.out_of_reach, 0U);
  }
}

}  // namespace
}  // namespace xsharp

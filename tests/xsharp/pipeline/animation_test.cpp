/// Tests moving scenes: pages, reach, flights past the viewer and custom objects.
#include "xsharp/animation.hpp"

#include "tests/support/test.hpp"
#include "tests/xsharp/pipeline/draws.hpp"
#include "tests/xsharp/pipeline/stage.hpp"
#include "tests/xsharp/pipeline/types.hpp"
#include "xsharp/validate.hpp"

namespace xsharp {
namespace {

using draws::Integers;
using Page3 = std::array<std::int32_t, 3>;

constexpr std::int32_t frame_side = 200;

ObjectDescription spinning(double half_edge, const Triple& position) {
  ObjectDescription object = pipeline::body(cube(half_edge), position);
  object.spin.tenths = {30, 50, -20};
  return object;
}

template <class N>
struct AnimationOf : testing::Test {};
TYPED_TEST_SUITE(AnimationOf, pipeline::scene_types, );

/// Expects the same polygons in the same order with the same points.
void expect_same(const Picture& a, const Picture& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.values, b.values);
  ASSERT_EQ(a.polygons.size(), b.polygons.size());
  for (std::size_t i = 0; i < a.polygons.size(); ++i) {
    EXPECT_EQ(a.polygons[i].object, b.polygons[i].object);
    EXPECT_EQ(a.polygons[i].first, b.polygons[i].first);
    EXPECT_EQ(a.polygons[i].points, b.polygons[i].points);
    EXPECT_EQ(a.polygons[i].paint, b.polygons[i].paint);
  }
}

/// Two cubes, a ball that drifts out of its page, an orbiting object and a turned viewer.
Scene moved_to(const Page3& page) {
  std::vector<ObjectDescription> objects{
      spinning(40, {100, 20, -700}), spinning(60, {-90, -50, -900.25}),
      pipeline::body(ball(50, 4), {16300, 0, -16200}), spinning(25, {})};
  objects[2].drift = Drift{{40.5, 0, -60.25}, {}, {}};
  objects[3].orbit = Orbit{{0, 0, -800}, 200, 0, 35, 150};
  Scene scene = pipeline::scene(frame_side, std::move(objects));
  scene.camera.position = {-5.5, 12, 40};
  scene.camera.turn_tenths = {20, -30, 100};
  scene.camera.page = page;
  for (ObjectDescription& object : scene.objects) object.page = page;
  return scene;
}

/// Balls of 3,962 vertices each, in a row away from the viewer.
std::vector<ObjectDescription> balls(int count) {
  std::vector<ObjectDescription> all(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    ObjectDescription& one = all[static_cast<std::size_t>(i)];
    one =
        pipeline::body(ball(30, max_bands), {-60.5 + 7 * i, 50.0 - 9 * (i % 12), -300.0 - 40 * i});
    one.spin.tenths = {10, -25 + i, 5};
  }
  return all;
}

/// Enough vertices for three threads.
Scene crowded() {
  Scene scene = moved_to({0, 0, 0});
  scene.objects[1].surface.kind = SurfaceKind::texture;
  std::ranges::move(balls(31), std::back_inserter(scene.objects));
  return scene;
}

TYPED_TEST(AnimationOf, IsTheSameOnAnyNumberOfThreads) {
  const Scene scene = crowded();
  for (const std::size_t threads : {2U, 3U}) {
    Animation<TypeParam> alone(scene);
    Animation<TypeParam> shared(scene, threads);
    ASSERT_EQ(shared.threads(), threads);
    for (int frame = 0; frame < 3; ++frame) {
      Picture one;
      Picture other;
      EXPECT_EQ(alone.draw(one).out_of_reach, shared.draw(other).out_of_reach);
      expect_same(one, other);
      alone.move();
      shared.move();
    }
  }
}

TEST(UsefulThreads, ASmallSceneTakesOne) {
  EXPECT_EQ(Animation<double>(moved_to({0, 0, 0}), 9).threads(), 1U);
  EXPECT_EQ(useful_threads(crowded(), 9), 3U);
  EXPECT_EQ(useful_threads(crowded(), 0), 1U);
  EXPECT_EQ(useful_threads(pipeline::scene(frame_side, {}), 2), 1U);
}

TEST(UsefulThreads, NoneHasLessThanAnObject) {
  ObjectDescription heavy = pipeline::body(cube(1), {});
  heavy.mesh.vertices.resize(2 * vertices_per_thread);
  EXPECT_EQ(useful_threads(pipeline::scene(frame_side, {heavy}), 2), 1U);
  EXPECT_EQ(useful_threads(pipeline::scene(frame_side, {heavy, spinning(9, {})}), 2), 2U);
  heavy.mesh.vertices.resize(2 * vertices_per_thread - 9);  // and eight of the cube
  EXPECT_EQ(useful_threads(pipeline::scene(frame_side, {heavy, spinning(9, {})}), 2), 1U);
}

/// An invisible object with an interpolated surface gives the other objects no values.
TYPED_TEST(AnimationOf, HasNoValuesWhereNothingIsInterpolated) {
  std::vector<ObjectDescription> objects = balls(21);
  for (ObjectDescription& object : objects) object.position[2] = 600;
  objects[20].surface.kind = SurfaceKind::texture;
  objects.insert(objects.begin(), spinning(40, {0, 0, -600}));
  const Scene scene = pipeline::scene(frame_side, std::move(objects));
  for (const std::size_t threads : {1U, 2U}) {
    Animation<TypeParam> animation(scene, threads);
    ASSERT_EQ(animation.threads(), threads);
    Picture picture;
    animation.draw(picture);
    EXPECT_FALSE(picture.points.empty());
    EXPECT_TRUE(picture.values.empty()) << threads;
  }
}

TYPED_TEST(AnimationOf, AFarPageIsSeenAsTheFirstIs) {
  Animation<TypeParam> here(moved_to({0, 0, 0}));
  for (const Page3& page : {Page3{1000000, -1000000, 999999}, {1, 0, -1}, {-7, 300000, 12}}) {
    Animation<TypeParam> near(moved_to({0, 0, 0}));
    Animation<TypeParam> far(moved_to(page));
    std::size_t polygons = 0;
    for (int frame = 0; frame < 20; ++frame) {
      Picture one;
      Picture other;
      EXPECT_EQ(near.draw(one).out_of_reach, far.draw(other).out_of_reach);
      expect_same(one, other);
      for (std::size_t object = 0; object < 4; ++object) {
        EXPECT_EQ(near.state(object).view, far.state(object).view);
      }
      polygons += one.polygons.size();
      near.move();
      far.move();
    }
    EXPECT_GT(polygons, 60U);
  }
}

TYPED_TEST(AnimationOf, APlaceIsTheSameFromTheNextPage) {
  using N = TypeParam;
  // In the next page, 384.5 stands for 16384 - 15999.5. The viewer has a page of its own.
  const auto state = [](const Page3& object_page, const Triple& position, const Page3& camera) {
    Scene scene = pipeline::scene(frame_side, {spinning(30, position)});
    scene.objects[0].page = object_page;
    scene.camera.page = camera;
    Animation<N> animation(scene);
    Picture picture;
    EXPECT_EQ(animation.draw(picture).out_of_reach, 0U);
    EXPECT_FALSE(picture.polygons.empty());
    return animation.state(0);
  };
  const ObjectState expected = state({0, 0, 0}, {200, -100, -900.5}, {0, 0, 0});
  EXPECT_EQ(expected.xform[3], 200 * 65536);
  EXPECT_EQ(expected.xform[11], -900 * 65536 - 32768);
  for (const auto& [page, position] :
       {std::pair{Page3{1, 0, 0}, Triple{200 - 16384, -100, -900.5}},
        {Page3{-1, 1, -1}, {16384 + 200, -16384 - 100, 16384 - 900.5}}}) {
    const ObjectState found =
        state({page[0] + 500, page[1] - 9, page[2] - 999}, position, {500, -9, -999});
    EXPECT_EQ(found.xform, expected.xform);
    EXPECT_EQ(found.view, expected.view);
    EXPECT_EQ(found.screen, expected.screen);
    EXPECT_EQ(found.visible, expected.visible);
  }
}

TYPED_TEST(AnimationOf, WhatIsOutOfReachIsCountedAndNotDrawn) {
  Scene scene =
      pipeline::scene(frame_side, {spinning(40, {0, 0, -600}), spinning(40, {0, 0, -700})});
  for (const Page3& page : {Page3{2, 0, 0}, {0, 0, -2}, {0, -3, 0}, {0, 0, 1000000}}) {
    scene.objects[1].page = page;
    Animation<TypeParam> animation(scene);
    for (int frame = 0; frame < 3; ++frame) {
      Picture picture;
      EXPECT_EQ(animation.draw(picture).out_of_reach, 1U);
      EXPECT_FALSE(picture.polygons.empty());
      for (const Polygon& polygon : picture.polygons) EXPECT_EQ(polygon.object, 0U);
      EXPECT_TRUE(animation.state(1).visible.empty());
      if (frame > 0) animation.move();
    }
  }
}

/// An object that flies past the viewer is either out of reach or exactly in place. Its matrix is
/// the identity, so nothing rounds.
TYPED_TEST(AnimationOf, AnObjectIsOutOfReachOrInItsPlace) {
  Scene scene = pipeline::scene(frame_side, {pipeline::body(cube(100), {50, 60, 0})});
  // In one frame the centre is at -32753.25, inside 16.16, while some corners are outside.
  scene.objects[0].page = {0, 0, -4};
  scene.objects[0].drift = Drift{{0.875, 0, 250.25}, {}, {}};
  Animation<TypeParam> animation(scene);
  int in_reach = 0;
  for (int frame = 0; frame < 520; ++frame, animation.move()) {
    Picture picture;
    const Tally tally = animation.draw(picture);
    EXPECT_EQ(tally.faults, 0U);
    const double z = -4 * 16384 + frame * 250.25;
    // The margin of 1000 exceeds the object's size and its sideways offset.
    if (std::fabs(z) > 32768) {
      EXPECT_EQ(tally.out_of_reach, 1U) << z;
    }
    if (std::fabs(z) < 32767 - 1000) {
      EXPECT_EQ(tally.out_of_reach, 0U) << z;
    }
    if (tally.out_of_reach == 1) {
      EXPECT_TRUE(picture.polygons.empty());
      continue;
    }
    ++in_reach;
    const ObjectState state = animation.state(0);
    for (std::size_t v = 0; v < 8; ++v) {
      const Triple& vertex = scene.objects[0].mesh.vertices[v];
      EXPECT_EQ(state.view[v][0], (50 + frame * 0.875 + vertex[0]) * 65536);
      EXPECT_EQ(state.view[v][1], (60 + vertex[1]) * 65536);
      EXPECT_EQ(state.view[v][2], (z + vertex[2]) * 65536);
    }
  }
  EXPECT_GT(in_reach, 240);
}

TYPED_TEST(AnimationOf, WhatFliesPastTheViewerNeverFaults) {
  for (const double x : {0.0, 35.0, 200.0}) {
    Scene scene = pipeline::scene(frame_side, {spinning(40, {x, 3, -400})});
    scene.objects[0].drift = Drift{{0, 0, 3}, {}, {}};
    Animation<TypeParam> animation(scene);
    for (int frame = 0; frame < 200; ++frame, animation.move()) {
      Picture picture;
      const Tally tally = animation.draw(picture);
      EXPECT_EQ(tally.faults + tally.out_of_reach, 0U);
      // Corners are within 70 of the centre, which is at -400 + 3 * frame.
      if (frame <= 100) {
        EXPECT_FALSE(picture.polygons.empty()) << frame;
      }
      if (frame >= 160) {
        EXPECT_TRUE(picture.polygons.empty()) << frame;
      }
      for (const ScreenPoint& point : picture.points) {
        EXPECT_LE(std::max(std::abs(point.x - frame_side / 2), std::abs(point.y - frame_side / 2)),
                  32001);
      }
    }
  }
}

TYPED_TEST(AnimationOf, AmbientLightNeedsNoNormals) {
  Scene scene = pipeline::scene(frame_side, {spinning(40, {0, 0, -400})});
  ObjectDescription& object = scene.objects[0];
  object.shadings.assign(object.mesh.faces.size(), {.ambient = true});
  for (Paint& paint : object.paints) paint = {false, 0, {200, 100, 0}};
  scene.lights.ambient = {0.5, 0.5, 0.5};
  Animation<TypeParam> animation(scene);
  Picture picture;
  animation.draw(picture);
  ASSERT_FALSE(picture.polygons.empty());
  for (const Polygon& polygon : picture.polygons) {
    EXPECT_EQ(polygon.paint, (Paint{false, 0, {100, 50, 0}}));
  }
}

TYPED_TEST(AnimationOf, LightsAreSwitched) {
  Scene scene = pipeline::scene(frame_side, {pipeline::body(with_normals(cube(40)), {0, 0, -400})});
  // Every level is whole, so builds with truncated products give the same result.
  scene.objects[0].shadings.assign(6, {.ambient = true, .diffuse = true});
  for (Paint& paint : scene.objects[0].paints) paint = {false, 0, {128, 128, 128}};
  scene.lights.ambient = {0.25, 0.25, 0.25};
  scene.lights.spots.push_back({.direction = {0, 0, -1}, .intensity = {0.5, 0.5, 0.5}});
  Animation<TypeParam> animation(scene);
  const auto red = [&animation] {
    Picture picture;
    animation.draw(picture);
    EXPECT_EQ(picture.polygons.size(), 1U);
    return static_cast<int>(picture.polygons[0].paint.color.red);
  };
  EXPECT_EQ(red(), 96);
  animation.switch_light(1);
  EXPECT_EQ(red(), 32);
  animation.switch_light(0);
  EXPECT_EQ(red(), 0);
  animation.switch_light(1);
  animation.switch_light(2);
  EXPECT_EQ(red(), 64);
}

// A cube seen from a corner shows three faces: one unlit, one under ambient light, and one under
// ambient and diffuse light.
TYPED_TEST(AnimationOf, TheKindOfShadingBelongsToTheFace) {
  using N = TypeParam;
  Scene scene = pipeline::scene(frame_side, {pipeline::body(cube(40), {-100, -100, -400})});
  ObjectDescription& object = scene.objects[0];
  constexpr std::size_t right = 0;
  constexpr std::size_t above = 2;
  constexpr std::size_t front = 5;
  object.shadings.resize(6);
  object.shadings[above] = {.ambient = true};
  object.shadings[front] = {.ambient = true, .diffuse = true};
  for (Paint& paint : object.paints) paint = {false, 0, {128, 64, 32}};
  object.paints[right] = {true, 77, {}};
  object.mesh =
      with_normals(std::move(object.mesh), [](std::size_t face) { return face == front; });
  scene.lights.ambient = {0.25, 0.25, 0.25};
  scene.lights.spots.push_back({.direction = {0, 0, -1}, .intensity = {0.5, 0.5, 0.5}});
  validate(scene);
  Animation<N> animation(scene);
  Picture picture;
  animation.draw(picture);
  EXPECT_EQ(animation.state(0).visible, (std::vector<std::size_t>{right, above, front}));
  ASSERT_EQ(picture.polygons.size(), 3U);
  EXPECT_EQ(picture.polygons[0].paint, (Paint{true, 77, {}}));
  EXPECT_EQ(picture.polygons[1].paint, (Paint{false, 0, {32, 16, 8}}));
  EXPECT_EQ(picture.polygons[2].paint, (Paint{false, 0, {96, 48, 24}}));
}

/// A bitmap that always faces the viewer, with a quad for each pixel.
template <class N>
class Bitmap final : public Object<N> {
 public:
  Bitmap(std::uint32_t index, const Vec3<N>& place) : index_(index), place_(place) {}

  void prepare(const View<N>& view, Tally& tally) override {
    view_place_ = Arithmetic<N>::apply(view.world_to_view, place_);
    quads_.clear();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) add_quad(row, column, view.projection, tally);
    }
  }
  [[nodiscard]] N depth(DepthKey) const override { return view_place_.z; }
  void draw(const Lighting<N>&, Picture& picture) const override {
    for (std::size_t i = 0; i < quads_.size(); ++i) {
      picture.polygons.push_back({index_,
                                  static_cast<std::uint32_t>(picture.points.size()),
                                  4,
                                  {true, static_cast<std::uint8_t>(100 + i), {}}});
      picture.points.insert(picture.points.end(), quads_[i].begin(), quads_[i].end());
    }
  }
  void move() override { place_.z = place_.z + pipeline::number<N>(100); }
  [[nodiscard]] ObjectState state() const override { return {}; }

 private:
  void add_quad(int row, int column, const Projection<N>& projection, Tally& tally) {
    std::array<ScreenPoint, 4> quad;
    for (std::size_t i = 0; i < 4; ++i) {
      const int right = column + (i == 1 || i == 2 ? 1 : 0);
      const int down = row + (i >= 2 ? 1 : 0);
      const Vec3<N> corner{view_place_.x + pipeline::number<N>(right * 20 - 30),
                           view_place_.y - pipeline::number<N>(down * 20 - 30), view_place_.z};
      if (!inside(corner, projection.slope)) return;
      const auto on_screen = project(corner, projection);
      if (!on_screen) ++tally.faults;
      quad[i] = on_screen.value_or(ScreenPoint{});
    }
    quads_.push_back(quad);
  }

  std::uint32_t index_;
  Vec3<N> place_;
  Vec3<N> view_place_{};
  std::vector<std::array<ScreenPoint, 4>> quads_;
};

TYPED_TEST(AnimationOf, ObjectsOfAnotherKindAreSortedAndDrawn) {
  using N = TypeParam;
  Animation<N> animation(
      pipeline::scene(frame_side, {pipeline::plain_body(cube(10), {0, 0, -510}, 7)}));
  animation.add(std::make_unique<Bitmap<N>>(1, pipeline::vector<N>({0, 0, -800})));
  const auto middle = [&animation] {
    Picture picture;
    EXPECT_EQ(animation.draw(picture).faults, 0U);
    EXPECT_EQ(picture.polygons.size(), 10U);
    return static_cast<int>(
        pipeline::drawn(picture, frame_side).row(frame_side / 2)[frame_side / 2]);
  };
  // The middle pixel of the bitmap is 104. At -800, -700 and -600 the bitmap is behind the cube.
  for (int frame = 0; frame < 3; ++frame, animation.move()) {
    EXPECT_EQ(middle(), 7);
    EXPECT_EQ(animation.order().back(), 0U);
  }
  for (int frame = 0; frame < 3; ++frame, animation.move()) {
    EXPECT_EQ(middle(), 104);
    EXPECT_EQ(animation.order().back(), 1U);
  }
}

// Listing 53.2 inserts a new object before those of equal depth. A later sort moves an object only
// past strictly smaller depths, so objects that reach the same depth keep their order.
TYPED_TEST(AnimationOf, ObjectsOfEqualDepthAreDrawnInTheReverseOrder) {
  using N = TypeParam;
  Scene scene = pipeline::scene(frame_side, {pipeline::plain_body(cube(10), {0, 0, -600}, 1),
                                             pipeline::plain_body(cube(10), {0, 0, -500}, 2),
                                             pipeline::plain_body(cube(10), {0, 0, -600}, 3)});
  scene.objects[1].drift = Drift{.step = {0, 0, -50}};
  Animation<N> animation(scene);
  const auto order = [&animation] {
    Picture picture;
    animation.draw(picture);
    return std::vector<std::size_t>(animation.order().begin(), animation.order().end());
  };
  EXPECT_EQ(order(), (std::vector<std::size_t>{2, 0, 1}));
  for (int frame = 0; frame < 2; ++frame) animation.move();
  EXPECT_EQ(order(), (std::vector<std::size_t>{2, 0, 1}));  // all at -600
  animation.move();
  EXPECT_EQ(order(), (std::vector<std::size_t>{1, 2, 0}));
  animation.add(std::make_unique<Bitmap<N>>(3, pipeline::vector<N>({0, 0, -600})));
  EXPECT_EQ(order(), (std::vector<std::size_t>{1, 3, 2, 0}));

  // Without sorting, objects keep the order of addition. A depth buffer starts at the list's other
  // end.
  for (const bool buffered : {false, true}) {
    scene.depth_key = buffered ? DepthKey::center : DepthKey::none;
    scene.depth_buffer = buffered ? DepthBuffering::on : DepthBuffering::off;
    Animation<N> other(scene);
    Picture picture;
    other.draw(picture);
    const std::vector<std::size_t> drawn(other.order().begin(), other.order().end());
    EXPECT_EQ(drawn,
              buffered ? (std::vector<std::size_t>{1, 0, 2}) : (std::vector<std::size_t>{0, 1, 2}));
  }
}

TYPED_TEST(AnimationOf, AViewerWhoHasTurnedSeesWhatIsThere) {
  using N = TypeParam;
  // The camera turns left by 90 degrees about y and looks down -x.
  Scene scene = pipeline::scene(frame_side, {pipeline::plain_body(cube(10), {-600, 0, 0}, 1),
                                             pipeline::plain_body(cube(10), {0, 0, -600}, 2)});
  scene.camera.turn_tenths = {0, 900, 0};
  scene.camera.position = {-100, 0, 0};
  Animation<N> animation(scene);
  Picture picture;
  animation.draw(picture);
  for (const Polygon& polygon : picture.polygons) EXPECT_EQ(polygon.object, 0U);
  EXPECT_FALSE(picture.polygons.empty());
  EXPECT_NEAR(static_cast<double>(animation.state(0).xform[11]), -500 * 65536, 1e-9);
}

}  // namespace
}  // namespace xsharp

/// Compares batches with single vertices: places, faults, exceptions and whole pictures.
#include "xsharp/place.hpp"

#include <compare>

#include "tests/support/test.hpp"
#include "tests/xsharp/pipeline/stage.hpp"
#include "tests/xsharp/pipeline/types.hpp"

namespace pipeline {

/// Wraps a number type so that the pipeline handles vertices one by one.
template <class N>
struct Plain {
  N n{};

  friend Plain operator+(Plain a, Plain b) { return {a.n + b.n}; }
  friend Plain operator-(Plain a, Plain b) { return {a.n - b.n}; }
  Plain operator-() const { return {-n}; }
  friend Plain operator*(Plain a, Plain b) { return {a.n * b.n}; }
  friend bool operator==(Plain, Plain) = default;
  friend auto operator<=>(Plain, Plain) = default;
  explicit operator double() const { return static_cast<double>(n); }
};

}  // namespace pipeline

namespace xsharp {

template <class M>
struct Arithmetic<pipeline::Plain<M>> {
  using N = pipeline::Plain<M>;
  using Of = Arithmetic<M>;
  static constexpr bool divides_by_whole_part() { return Of::divides_by_whole_part(); }

  static std::int32_t raw(N x) { return Of::raw(x.n); }
  static N from_raw(std::int32_t raw) { return {Of::from_raw(raw)}; }
  static N constant(double value, Conversion conversion) {
    return {Of::constant(value, conversion)};
  }
  static std::optional<N> divide(N n, N d) {
    const auto quotient = Of::divide(n.n, d.n);
    return quotient ? std::optional(N{*quotient}) : std::nullopt;
  }
  static Turn<N> turn(std::int32_t tenths) {
    const Turn<M> turn = Of::turn(tenths);
    return {{turn.cos}, {turn.sin}};
  }
  static N midpoint(N a, N b) { return {Of::midpoint(a.n, b.n)}; }
  static Vec3<N> apply(const Transform<N>& t, const Vec3<N>& v) { return apply_products(t, v); }
  static Transform<N> concatenate(const Transform<N>& first, const Transform<N>& second,
                                  Concatenation /*how*/) {
    return concatenate_products(first, second);
  }
  static N length(const Vec3<N>& v) { return {Of::length({v.x.n, v.y.n, v.z.n})}; }
  static N power(N base, N exponent) { return {Of::power(base.n, exponent.n)}; }
};

namespace {

template <class N>
struct Placing : testing::Test {};
// tests/fixed/batch covers the operations under every preset.
using batch_types =
    testing::Types<fixproof::q16_16, fixproof::q16_16_saturating, fixproof::q16_16_trapping,
                   fixproof::q16_16_i386, fixproof::q16_16_i8088, fixproof::q16_16_i8088_unrounded>;
TYPED_TEST_SUITE(Placing, batch_types, );

/// The placed vertices and the exception, if any.
template <class N>
struct Result {
  std::vector<Vec3<N>> view;
  std::vector<std::optional<ScreenPoint>> screen;
  Unplaced unplaced{};
  std::string thrown{};

  template <class Place>
  Result(std::size_t count, const Place& place) : view(count), screen(count) {
    try {
      unplaced = place(Places<N>{view, screen});
    } catch (const std::exception& error) {
      thrown = error.what();
    }
  }
};

/// Random vertices of `bits`-bit coordinates that fill two blocks and part of a third.
template <class N>
std::vector<Vec3<N>> vertices_of_bits(int bits) {
  std::mt19937 random(1994);
  const auto draw = [&] {
    return Arithmetic<N>::from_raw(static_cast<std::int32_t>(random()) >> (32 - bits));
  };
  std::vector<Vec3<N>> vertices(2 * 256 + 77);
  for (Vec3<N>& v : vertices) v = {draw(), draw(), draw()};
  return vertices;
}

template <class N>
Transform<N> seen_from(double distance) {
  Transform<N> t;
  const std::array<Triple, 3> turn{Triple{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) t.rows[i][j] = pipeline::number<N>(turn[i][j]);
  }
  t.rows[2][3] = pipeline::number<N>(-distance);
  return t;
}

template <class N>
Projection<N> projected_by(double constant, std::int32_t slope) {
  return {pipeline::number<N>(constant), 160, 120, slope};
}

/// A slope so large that every point behind z = -1 is inside the volume.
constexpr std::int32_t everything = std::int32_t{1} << 20;

template <class N>
Result<N> expect_same(const Transform<N>& to_view, const std::vector<Vec3<N>>& vertices,
                      const Projection<N>& projection) {
  const std::span<const Vec3<N>> from = vertices;
  const Result<N> one(
      from.size(), [&](const Places<N>& to) { return place_each(to_view, from, projection, to); });
  const Result<N> batch(from.size(), [&](const Places<N>& to) {
    return place_in_batches(to_view, from, projection, to);
  });
  EXPECT_EQ(one.thrown, batch.thrown);
  if (one.thrown.empty()) {
    EXPECT_EQ(one.view, batch.view);
    EXPECT_EQ(one.screen, batch.screen);
    EXPECT_EQ(one.unplaced, batch.unplaced);
  }
  return batch;
}

template <class N>
constexpr bool traps = N::rules.range == fixproof::overflow::trap;

TYPED_TEST(Placing, IsTheSameInBatches) {
  using N = TypeParam;
  const auto vertices = vertices_of_bits<N>(24);
  const auto all = expect_same(seen_from<N>(1000), vertices, projected_by<N>(-320, 32));
  EXPECT_EQ(all.unplaced, Unplaced{});
  // Some vertices are behind the viewer and some are beside the volume.
  const auto some = expect_same(seen_from<N>(20), vertices, projected_by<N>(-320, 1));
  EXPECT_GT(some.unplaced.outside, vertices.size() / 4);
  EXPECT_LT(some.unplaced.outside, vertices.size());
  EXPECT_EQ(some.unplaced.faults, 0U);
}

TYPED_TEST(Placing, OverflowsTheSameWhenTransformed) {
  using N = TypeParam;
  Transform<N> to_view = seen_from<N>(0);
  to_view.rows[0][0] = pipeline::number<N>(7);
  const auto result =
      expect_same(to_view, vertices_of_bits<N>(32), projected_by<N>(-1, everything));
  EXPECT_EQ(!result.thrown.empty(), traps<N>);
}

/// Puts every seventh vertex at `place`; the others are uncritical.
template <class N>
std::vector<Vec3<N>> with_some(const Triple& place) {
  auto vertices = vertices_of_bits<N>(20);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    vertices[i].z = pipeline::number<N>(-40);
    if (i % 7 == 0) vertices[i] = pipeline::vector<N>(place);
  }
  return vertices;
}

TYPED_TEST(Placing, OverflowsTheSameWhenProjected) {
  using N = TypeParam;
  const auto vertices = with_some<N>({300, -200, -1.5});
  const auto result = expect_same(identity<N>(), vertices, projected_by<N>(-320, everything));
  EXPECT_EQ(!result.thrown.empty(), traps<N>);
}

TYPED_TEST(Placing, HasTheSameFaults) {
  using N = TypeParam;
  const auto vertices = with_some<N>({-32768, 0, -1});
  const auto result = expect_same(identity<N>(), vertices, projected_by<N>(-1, everything));
  EXPECT_EQ(result.thrown, "");
  const bool fault = traps<N> || N::rules.fault == fixproof::divide_fault::signed_quotient;
  EXPECT_EQ(result.unplaced.faults, fault ? (vertices.size() + 6) / 7 : 0);
  EXPECT_EQ(result.unplaced.outside, 0U);
}

/// A ball larger than one block, one that the near plane cuts, a cube outside the view, and a
/// texture.
Scene hard_scene() {
  std::vector<ObjectDescription> objects{
      pipeline::body(ball(80, 16), {20, 10, -500}), pipeline::body(ball(30, 6), {5, -8, -20}),
      pipeline::body(cube(40), {-900, 0, -50}), pipeline::body(ball(60, 5), {-60, -50, -300})};
  for (ObjectDescription& object : objects) object.spin.tenths = {31, -17, 22};
  objects[3].surface.kind = SurfaceKind::texture;
  Scene scene = pipeline::scene(200, std::move(objects));
  scene.depth_key = DepthKey::nearest;
  return scene;
}

template <class N>
struct PlacedPicture : testing::Test {};
using picture_types = testing::Types<fixproof::q16_16_trapping, fixproof::q16_16_i8088_unrounded>;
TYPED_TEST_SUITE(PlacedPicture, picture_types, );

TYPED_TEST(PlacedPicture, IsTheSameInBatches) {
  const Scene scene = hard_scene();
  Animation<TypeParam> in_batches(scene);
  Animation<pipeline::Plain<TypeParam>> one_by_one(scene);
  for (int frame = 0; frame < 20; ++frame) {
    Picture a;
    Picture b;
    EXPECT_EQ(in_batches.draw(a).faults, one_by_one.draw(b).faults);
    EXPECT_GT(a.polygons.size(), 150U);
    EXPECT_EQ(a.points, b.points);
    EXPECT_EQ(a.values, b.values);
    const auto same = [](const Polygon& p, const Polygon& q) {
      return p.object == q.object && p.first == q.first && p.points == q.points &&
             p.paint == q.paint;
    };
    EXPECT_TRUE(std::ranges::equal(a.polygons, b.polygons, same));
    for (std::size_t object = 0; object < scene.objects.size(); ++object) {
      EXPECT_EQ(in_batches.state(object).view, one_by_one.state(object).view);
      EXPECT_EQ(in_batches.state(object).screen, one_by_one.state(object).screen);
    }
    in_batches.move();
    one_by_one.move();
  }
}

}  // namespace
}  // namespace xsharp

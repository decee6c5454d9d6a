/// Tests the light on a face against the formula in double.
#include "xsharp/shade.hpp"

#include "tests/support/test.hpp"
#include "tests/xsharp/pipeline/draws.hpp"
#include "tests/xsharp/pipeline/types.hpp"

namespace xsharp {
namespace {

using draws::Integers;
using pipeline::direction;
using pipeline::number;
using pipeline::product_error;
using pipeline::triple;
using pipeline::ulp;

constexpr Shading both{.ambient = true, .diffuse = true};
constexpr Color white{255, 255, 255};

template <class N>
Ray<N> ray(const Triple& to_light, double intensity) {
  return {true,
          pipeline::vector<N>(to_light),
          {number<N>(intensity), number<N>(intensity), number<N>(intensity)}};
}

template <class N>
Lighting<N> ambient(double intensity) {
  return {true, {number<N>(intensity), number<N>(intensity), number<N>(intensity)}, {}};
}

/// 255 times the reflected light of a component, in double, from the rounded inputs.
template <class N>
double formula(const Vec3<N>& normal, std::uint8_t reflectance, const Shading& shading,
               const Lighting<N>& lighting, std::size_t component) {
  double light = 0;
  if (shading.ambient && lighting.ambient_on) {
    light = static_cast<double>(lighting.ambient[component]);
  }
  for (const Ray<N>& ray : lighting.rays) {
    if (!shading.diffuse || !ray.on) continue;
    light += static_cast<double>(ray.intensity[component]) *
             std::max(0.0, dot(triple(ray.to_light), triple(normal)));
  }
  return std::min(255.0, light * reflectance);
}

/// Three spots and ambient light with intensities up to 2, from 18 numbers from -100 to 100.
template <class N>
Lighting<N> lighting_of_draw(const Integers& d) {
  const auto intensity = [&](std::size_t i) {
    return number<N>(static_cast<double>(d[i] + 100) / 100);
  };
  Lighting<N> lighting{d[0] % 2 == 0, {intensity(0), intensity(1), intensity(2)}, {}};
  for (std::size_t i = 3; i < 18; i += 5) {
    lighting.rays.push_back({d[i] % 3 != 0,
                             direction<N>(d[i], d[i + 1], d[i + 2]),
                             {intensity(i + 2), intensity(i + 3), intensity(i + 4)}});
  }
  return lighting;
}

template <class N>
struct Shade : testing::Test {};
TYPED_TEST_SUITE(Shade, pipeline::multiplying_types, );

/// With products within p, a cosine is within 3 p, its product with an intensity of at most 2
/// within 7 p, and the light of three spots within 21 p, so 255 times that is below 0.1. The last
/// product is in 255ths and rounds or truncates like every product.
TYPED_TEST(Shade, IsTheFormula) {
  using N = TypeParam;
  const double allowed = std::max(0.5, product_error<N>() / ulp) + 255 * 21 * product_error<N>();
  EXPECT_LT(allowed, 1.1);
  EXPECT_TRUE(draws::hold(26, -100, 100, [=](const Integers& d) {
    const Lighting<N> lighting = lighting_of_draw<N>(d);
    const Vec3<N> normal = direction<N>(d[18], d[19], d[20]);
    const auto level = [&](std::size_t i) { return static_cast<std::uint8_t>(d[i] + 128); };
    const Color reflectance{level(21), level(22), level(23)};
    const Shading shading{d[24] % 4 != 0, d[25] % 4 != 0};
    const Color shown = shade(normal, reflectance, shading, lighting);
    const auto near = [&](std::uint8_t found, std::uint8_t full, std::size_t component) {
      return std::fabs(found - formula(normal, full, shading, lighting, component)) <= allowed;
    };
    return near(shown.red, reflectance.red, 0) && near(shown.green, reflectance.green, 1) &&
           near(shown.blue, reflectance.blue, 2);
  }));
}

/// Checks every reflectance under light in 16.16. The level is one integer product, in 2^-16 of a
/// 255th.
template <class N>
void expect_levels(std::int64_t added) {
  for (std::int32_t light = 0; light <= 0x18000; light += 0x0777) {
    const N intensity = Arithmetic<N>::from_raw(light);
    const Lighting<N> lighting{true, {intensity, intensity, intensity}, {}};
    for (int full = 0; full <= 255; ++full) {
      const auto component = static_cast<std::uint8_t>(full);
      const Color shown =
          shade(Vec3<N>{}, {component, 0, 255}, {.ambient = true, .diffuse = false}, lighting);
      const auto level = [&](std::int64_t of) {
        return static_cast<int>(std::min<std::int64_t>((of * light + added) / 65536, 255));
      };
      ASSERT_EQ(shown.red, level(full)) << full << " under " << light;
      ASSERT_EQ(shown.green, 0);
      ASSERT_EQ(shown.blue, level(255));
    }
  }
}

TEST(ShadeOrder, LightIsMultipliedWithTheReflectanceOnce) {
  expect_levels<fixproof::q16_16_i386>(0x8000);
  expect_levels<fixproof::q16_16_i386_mul_rounded>(0x8000);
  expect_levels<fixproof::q16_16_i386_unrounded>(0);
  expect_levels<fixproof::q16_16_i8088>(0x8000);
  expect_levels<double>(0x8000);
}

TYPED_TEST(Shade, FullLightOnAWhiteFaceIsWhiteHoweverBright) {
  using N = TypeParam;
  for (const double intensity : {1.0, 2.0, 100.0}) {
    Lighting<N> lighting = ambient<N>(intensity);
    for (int i = 0; i < 16; ++i) lighting.rays.push_back(ray<N>({0, 0, 1}, 100));
    EXPECT_EQ(shade(pipeline::vector<N>({0, 0, 1}), white, both, lighting), white);
    EXPECT_EQ(shade(pipeline::vector<N>({0, 0, 1}), {0, 255, 0}, both, lighting),
              (Color{0, 255, 0}));
  }
}

TYPED_TEST(Shade, MoreLightIsNeverDarker) {
  using N = TypeParam;
  EXPECT_TRUE(draws::hold(3, -100, 100, [](const Integers& d) {
    const Vec3<N> normal = direction<N>(d[0], d[1], d[2]);
    int last = 0;
    for (int step = 0; step <= 300; ++step) {
      Lighting<N> lighting = ambient<N>(0.125);
      lighting.rays.push_back(ray<N>({0.6, 0, 0.8}, step * 0.01));
      const int level = shade(normal, white, both, lighting).red;
      if (level < last) return false;
      last = level;
    }
    return true;
  }));
}

TYPED_TEST(Shade, AFaceTurnedAwayHasAmbientLightOnly) {
  using N = TypeParam;
  EXPECT_TRUE(draws::hold(3, -100, 100, [](const Integers& d) {
    const Vec3<N> normal = direction<N>(d[0], d[1], d[2]);
    const Vec3<N> away{-normal.x, -normal.y, -normal.z};
    Lighting<N> lighting = ambient<N>(0.25);
    const Color without = shade(normal, {255, 128, 3}, both, lighting);
    const std::array<N, 3> bright{number<N>(2), number<N>(2), number<N>(2)};
    lighting.rays.push_back({true, away, bright});
    return shade(normal, {255, 128, 3}, both, lighting) == without;
  }));
}

TYPED_TEST(Shade, LightsThatAreOffAddNothing) {
  using N = TypeParam;
  Lighting<N> lighting = ambient<N>(0.5);
  lighting.rays.push_back(ray<N>({0, 0, 1}, 0.25));
  const Vec3<N> normal = pipeline::vector<N>({0, 0, 1});
  const auto level = [&](const Shading& shading) {
    return static_cast<int>(shade(normal, {128, 128, 128}, shading, lighting).green);
  };
  EXPECT_EQ(level(both), 96);
  EXPECT_EQ(level({.ambient = true, .diffuse = false}), 64);
  EXPECT_EQ(level({.ambient = false, .diffuse = true}), 32);
  EXPECT_EQ(level({}), 0);
  lighting.rays[0].on = false;
  EXPECT_EQ(level(both), 64);
  lighting.ambient_on = false;
  EXPECT_EQ(level(both), 0);
}

TYPED_TEST(Shade, ASpotIsTurnedIntoViewSpaceAndPointsBack) {
  using N = TypeParam;
  Lights lights;
  lights.ambient = {0.25, 0, 1};
  lights.spots.push_back({.on = false, .direction = {0, 0, -20}, .intensity = {1, 0.5, 0}});
  // Maps z to x, x to y and y to z. The translation does not affect a direction.
  Transform<N> to_view;
  to_view.rows[0][2] = to_view.rows[1][0] = to_view.rows[2][1] = number<N>(1);
  to_view.rows[0][3] = number<N>(100);
  const Lighting<N> lighting = lighting_of<N>(lights, Conversion::nearest, to_view);
  EXPECT_EQ(lighting.ambient, (std::array{number<N>(0.25), number<N>(0), number<N>(1)}));
  ASSERT_EQ(lighting.rays.size(), 1U);
  EXPECT_FALSE(lighting.rays[0].on);
  EXPECT_EQ(lighting.rays[0].to_light, pipeline::vector<N>({1, 0, 0}));
  EXPECT_EQ(lighting.rays[0].intensity, (std::array{number<N>(1), number<N>(0.5), number<N>(0)}));
}

// By hand: (1, -0.5, -1) converts to (65536, -32767, -65535), whose length is 98303. The unit
// vector has 43691.1, -21844.9 and -43690.4, which convert to 43691, -21844 and -43689. The exact
// unit vector has -43690.7, which would convert to -43690.
TEST(ShadePublished, ADirectionIsConvertedBeforeAndAfterItIsMadeAUnitVectorAndThenNegated) {
  using N = fixproof::q16_16_i386;
  Lights lights;
  lights.spots.push_back({.direction = {1, -0.5, -1}, .intensity = {1, 1, 1}});
  const auto lighting = lighting_of<N>(lights, Conversion::published, identity<N>());
  ASSERT_EQ(lighting.rays.size(), 1U);
  EXPECT_EQ(lighting.rays[0].to_light.x.raw(), -43691);
  EXPECT_EQ(lighting.rays[0].to_light.y.raw(), 21844);
  EXPECT_EQ(lighting.rays[0].to_light.z.raw(), 43689);
}

}  // namespace
}  // namespace xsharp

// Tests the number with a run-time format against q16_16, and the format that a scene needs against
// hand calculations.
#include "measure/trade/advice/formats.hpp"

#include <filesystem>

#include "fixed/fixed.hpp"
#include "measure/trade/advice/fraction_number.hpp"
#include "measure/trade/advice/screen_corners.hpp"
#include "tests/measure/one_cube.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"
#include "xsharp/files/scene_json.hpp"

namespace fixproof {
namespace {

using trade::FractionNumber;
using trade::FractionRun;
using Fractions = xsharp::Arithmetic<FractionNumber>;
using Words = xsharp::Arithmetic<q16_16>;

TEST(FractionNumber, With16FractionBitsIsQ16_16) {
  FractionRun run{.fraction_bits = 16, .range = {}};
  const FractionNumber::Scope scope(run);
  std::mt19937 random(53);
  const auto same = [](std::int32_t raw) { return FractionNumber::from_ulps(raw); };
  for (int i = 0; i < 200'000; ++i) {
    // Products of these fit, and so do quotients by the larger ones.
    const auto a = static_cast<std::int32_t>(random()) >> (9 + i % 20);
    const auto b = static_cast<std::int32_t>(random()) >> (8 + i % 7);
    const q16_16 x = q16_16::from_raw(a);
    const q16_16 y = q16_16::from_raw(b);
    ASSERT_EQ((same(a) * same(b)).ulps(), (x * y).raw()) << a << ' ' << b;
    ASSERT_EQ((same(a) - same(b)).ulps(), (x - y).raw());
    ASSERT_EQ((-same(a) + same(b)).ulps(), (-x + y).raw());
    ASSERT_EQ(Fractions::midpoint(same(a), same(b)).ulps(), Words::midpoint(x, y).raw());
    if (std::abs(b) > std::abs(a) / 32'000) {
      ASSERT_EQ(FractionNumber::divide(same(a), same(b)).value().ulps(), (x / y).raw())
          << a << ' ' << b;
    }
    const double value = std::ldexp(a, -20);
    for (const auto conversion : {xsharp::Conversion::nearest, xsharp::Conversion::published}) {
      ASSERT_EQ(Fractions::constant(value, conversion).ulps(),
                Words::constant(value, conversion).raw());
    }
  }
  for (int tenths = -3600; tenths <= 3600; ++tenths) {
    const auto is = Fractions::turn(tenths);
    const auto expected = Words::turn(tenths);
    ASSERT_EQ(is.cos.ulps(), expected.cos.raw()) << tenths;
    ASSERT_EQ(is.sin.ulps(), expected.sin.raw()) << tenths;
  }
  EXPECT_FALSE(FractionNumber::divide(same(1), same(0)));
}

/// The corners of the first 200 frames of a scene have the same bits.
void expect_same_corners(const xsharp::Scene& scene) {
  FractionRun run{.fraction_bits = 16, .range = {}};
  const FractionNumber::Scope scope(run);
  const xsharp::RotationStyle style{scene.trigonometry, scene.conversion, scene.from_scratch,
                                    scene.restore_every, scene.restore_rows};
  const auto view = xsharp::view_of<FractionNumber>(scene);
  const auto expected_view = xsharp::view_of<q16_16>(scene);
  for (const auto& object : scene.objects) {
    trade::ScreenCorners<FractionNumber> fractions(object, style);
    trade::ScreenCorners<q16_16> words(object, style);
    for (int frame = 0; frame < 200; ++frame) {
      ASSERT_EQ(fractions.advance(), words.advance());
      const auto& corners = fractions.view(view);
      const auto& expected = words.view(expected_view);
      ASSERT_EQ(corners.size(), expected.size());
      for (std::size_t i = 0; i < corners.size(); ++i) {
        ASSERT_EQ(corners[i].x.ulps(), expected[i].x.raw()) << frame;
        ASSERT_EQ(corners[i].y.ulps(), expected[i].y.raw()) << frame;
        ASSERT_EQ(corners[i].z.ulps(), expected[i].z.raw()) << frame;
      }
    }
  }
}

TEST(FractionNumber, With16FractionBitsDrawsEveryScene) {
  int scenes = 0;
  for (const auto& file : std::filesystem::directory_iterator(paths::source("xsharp/scenes"))) {
    if (file.path().extension() != ".json") continue;
    SCOPED_TRACE(file.path());
    expect_same_corners(xsharp::read_scene(file.path().string()));
    ++scenes;
  }
  EXPECT_GE(scenes, 14);
}

xsharp::Scene cube_at(double half_edge, double z) {
  xsharp::Scene scene = one_cube(half_edge, z);
  scene.conversion = xsharp::Conversion::nearest;
  return scene;
}

std::vector<trade::TriedFormat> tried(const xsharp::Scene& scene, double budget,
                                      std::uint64_t frames) {
  const std::atomic<bool> stop = false;
  return trade::try_formats(scene, budget, frames, stop, [](std::uint64_t) {});
}

// The largest result is the projection's constant, -2 * 160: 10 bits with the sign. A corner at
// x = y = 1 and z = -9 or -11 is at 320 / 9 or 320 / 11; its quotient is off by half an ulp and its
// product by another half.
TEST(AdviseFormats, OfAStillCube) {
  const auto formats = tried(cube_at(1, -10), 1000, 1);
  ASSERT_EQ(formats.size(), 2U * 25);
  for (const trade::TriedFormat& format : formats) {
    const int bits = format.fraction_bits;
    EXPECT_EQ(format.word_bits, 10 + bits);
    const double ulp = std::ldexp(1, -bits);
    const auto off = [&](int z) {
      const double quotient = std::floor(1.0 / z / ulp + 0.5) * ulp;
      return std::sqrt(2) * 320 * std::abs(quotient - 1.0 / z);
    };
    // The product of an exact constant has no rounding: 320 is even.
    const double expected = std::max(off(9), off(11));
    EXPECT_NEAR(format.error.pixels, expected, 320 * ulp) << bits;
    EXPECT_LE(format.error.pixels, std::sqrt(2) * (320 * ulp / 2 + ulp / 2)) << bits;
  }
}

TEST(AdviseFormats, TheNarrowestHasTheFewestFractionBits) {
  xsharp::Scene scene = cube_at(1, -10);
  scene.objects[0].spin.tenths = {10, 20, 0};
  const auto formats = tried(scene, 0.5, 600);
  const auto take = trade::narrowest(formats);
  ASSERT_TRUE(take);
  EXPECT_FALSE(formats[*take].error.over);
  EXPECT_LE(formats[*take].error.pixels, 0.5);
  for (const trade::TriedFormat& format : formats) {
    if (format.fraction_bits < formats[*take].fraction_bits) {
      EXPECT_TRUE(format.error.over) << format.fraction_bits;
    }
  }
  EXPECT_FALSE(trade::narrowest(tried(scene, 1e-9, 60)));
}

TEST(AdviseFormats, AWordHoldsTheBits) {
  const std::vector<std::array<int, 2>> widths{{1, 8},   {8, 8},   {9, 16},  {16, 16},
                                               {17, 32}, {32, 32}, {33, 64}, {40, 64}};
  for (const auto& [bits, width] : widths) EXPECT_EQ(trade::integer_width(bits), width);
}

// A cube has 8 vertices: 8 * 6 words and 24 for its transforms.
TEST(AdviseFormats, MemoryIsThatOfVerticesAndTransforms) {
  const std::atomic<bool> stop = false;
  const auto costs = trade::format_costs(cube_at(1, -10), 16, stop);
  ASSERT_EQ(costs.size(), 2U);
  EXPECT_EQ(costs[0].width, 32);
  EXPECT_EQ(costs[0].bytes, 72U * 4);
  EXPECT_EQ(costs[1].width, 16);
  EXPECT_EQ(costs[1].bytes, 72U * 2);
  EXPECT_GT(costs[1].nanoseconds.median, 0);
}

TEST(AdviseFormats, AsJson) {
  trade::FormatReport report;
  report.tried = {{4, {true, 0}, {}, 12}, {5, {false, 60}, {}, 13}};
  report.tried[0].error.pixels = std::numeric_limits<double>::infinity();
  report.tried[0].error.over = 3;
  const auto json = nlohmann::json::parse(support::json_text(report));
  EXPECT_EQ(json.at("take"), 1);
  EXPECT_EQ(json.at("formats").at(0).at("worst_pixels"), nullptr);
  EXPECT_EQ(json.at("formats").at(0).at("first_frame_over"), 3);
  EXPECT_EQ(json.at("formats").at(1).at("turning"), "restored every 60");
  EXPECT_EQ(json.at("formats").at(1).at("word_bits"), 13);
}

}  // namespace
}  // namespace fixproof

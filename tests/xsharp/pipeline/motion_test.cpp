/// Tests delays, spins, drifts, orbits and pages.
#include "xsharp/motion.hpp"

#include "tests/support/test.hpp"
#include "tests/xsharp/pipeline/draws.hpp"
#include "tests/xsharp/pipeline/matrix.hpp"
#include "tests/xsharp/pipeline/types.hpp"

namespace xsharp {
namespace {

using draws::Integers;
using pipeline::triple;
using pipeline::ulp;

constexpr RotationStyle plain{.conversion = Conversion::nearest};

template <class N>
Triple place(const Motion<N>& motion) {
  return triple(motion.to_world().translation());
}

/// The frames, out of the first `count`, in which the object changed.
template <class N>
std::vector<int> frames_of_change(const ObjectDescription& object, int count) {
  Motion<N> motion(object, plain);
  std::vector<int> frames;
  for (int frame = 1; frame <= count; ++frame) {
    const Transform<N> before = motion.to_world();
    const bool changed = motion.advance();
    EXPECT_EQ(changed, motion.to_world() != before);
    if (changed) frames.push_back(frame);
  }
  return frames;
}

template <class N>
struct MotionOf : testing::Test {};
TYPED_TEST_SUITE(MotionOf, pipeline::multiplying_types, );

TYPED_TEST(MotionOf, DelaysCountDownFromTheFirstThenFromTheBase) {
  ObjectDescription spinning;
  spinning.spin = {{900, 0, 0}, {.first = 3, .base = 2}};
  EXPECT_EQ(frames_of_change<TypeParam>(spinning, 9), (std::vector{3, 5, 7, 9}));
  spinning.spin.delay = {.first = 1, .base = 4};
  EXPECT_EQ(frames_of_change<TypeParam>(spinning, 9), (std::vector{1, 5, 9}));

  ObjectDescription drifting;
  drifting.drift = Drift{.step = {1, 0, 0}, .delay = {.first = 2, .base = 3}};
  EXPECT_EQ(frames_of_change<TypeParam>(drifting, 9), (std::vector{2, 5, 8}));

  EXPECT_EQ(frames_of_change<TypeParam>(ObjectDescription{}, 9), std::vector<int>{});
}

TYPED_TEST(MotionOf, BeyondStopZItMovesInZNoMore) {
  ObjectDescription object;
  object.position = {7, 0, -6000};
  object.drift = Drift{{1, 0, 80}, -350.0, {}};
  Motion<TypeParam> motion(object, plain);
  for (int frame = 1; frame <= 100; ++frame) {
    motion.advance();
    // -6000 + 70 * 80 is -400, which is not beyond stop_z; the next position, -320, is.
    EXPECT_EQ(place(motion), (Triple{7.0 + frame, 0, frame <= 71 ? -6000.0 + 80 * frame : -320}));
  }
}

TYPED_TEST(MotionOf, StopZIsAPlaceInTheWorldNotInThePage) {
  ObjectDescription object;
  object.page = {0, 0, 2};
  object.drift = Drift{{0, 0, 8192}, 3 * 16384.0, {}};
  Motion<TypeParam> motion(object, plain);
  for (int frame = 0; frame < 10; ++frame) motion.advance();
  EXPECT_EQ(motion.page()[2] * 16384.0 + place(motion)[2], 3 * 16384 + 8192);
}

TYPED_TEST(MotionOf, OutsideOfItsBoundsItTurnsBackInZ) {
  ObjectDescription object;
  object.position = {0, 0, -400};
  object.drift = Drift{.step = {1, 0, 30}, .bounce_z = Bounds{-420, -350}};
  Motion<TypeParam> motion(object, plain);
  // -340 is beyond -350 and -430 is beyond -420; -400 is between the bounds.
  const std::vector<double> expected{-370, -340, -370, -400, -430, -400, -370, -340, -370};
  for (std::size_t frame = 0; frame < expected.size(); ++frame) {
    motion.advance();
    EXPECT_EQ(place(motion), (Triple{1.0 + static_cast<double>(frame), 0, expected[frame]}));
  }
  // A position on a bound is still within the bounds.
  object.drift = Drift{.step = {0, 0, 50}, .bounce_z = Bounds{-400, -350}};
  Motion<TypeParam> between(object, plain);
  between.advance();
  EXPECT_EQ(place(between)[2], -350);
  between.advance();
  EXPECT_EQ(place(between)[2], -300);
  between.advance();
  EXPECT_EQ(place(between)[2], -350);
}

TYPED_TEST(MotionOf, SpinsAboutXThenYThenZ) {
  ObjectDescription object;
  object.position = {1, 2, 3};
  object.spin.tenths = {900, 900, -900};
  for (const bool from_scratch : {false, true}) {
    Motion<TypeParam> motion(object, {.from_scratch = from_scratch});
    const pipeline::Matrix step = pipeline::rotation(object.spin.tenths);
    pipeline::Matrix expected = pipeline::unit_matrix;
    for (int frame = 0; frame < 3; ++frame) {
      motion.advance();
      expected = pipeline::product(step, expected);
      EXPECT_LT(pipeline::distance(pipeline::matrix_of(motion.to_world()), expected), 1e-12);
    }
    EXPECT_EQ(place(motion), (Triple{1, 2, 3}));
  }
}

/// The error bound of an orbit position. With cosines within e = half an ulp and products within p,
/// the x offset is within a = radius * e + p, and y and z within a + radius * e + p each.
template <class N>
double orbit_error(double radius) {
  const double a = radius * ulp / 2 + pipeline::product_error<N>();
  return a + 2 * (a + radius * ulp / 2 + pipeline::product_error<N>());
}

TYPED_TEST(MotionOf, AnOrbitIsATiltedCircle) {
  using N = TypeParam;
  EXPECT_TRUE(draws::hold(7, -4000, 4000, [](const Integers& drawn) {
    const auto tenths = [&](std::size_t i) { return static_cast<std::int32_t>(drawn[i]); };
    const auto whole = [&](std::size_t i) { return static_cast<double>(drawn[i]); };
    ObjectDescription object;
    object.orbit =
        Orbit{{whole(0), whole(1), whole(2)}, std::fabs(whole(3)), tenths(4), tenths(5), tenths(6)};
    const double radius = object.orbit->radius;
    const double tilt = tenths(6) * std::numbers::pi / 1800;
    Motion<N> motion(object, plain);
    for (int frame = 0; frame < 50; ++frame, motion.advance()) {
      const double angle = (tenths(4) + frame * tenths(5)) * std::numbers::pi / 1800;
      const Triple on_circle{radius * std::cos(angle), -radius * std::sin(angle) * std::sin(tilt),
                             radius * std::sin(angle) * std::cos(tilt)};
      const Triple offset = difference(place(motion), object.orbit->about);
      if (length(difference(offset, on_circle)) > orbit_error<N>(radius) + 1e-8) return false;
      if (std::fabs(length(offset) - radius) > orbit_error<N>(radius) + 1e-8) return false;
    }
    return true;
  }));
}

TYPED_TEST(MotionOf, ADriftGoesOnFromPageToPage) {
  using N = TypeParam;
  // Positions and steps reach up to a page in either direction; clamping makes the ends likely.
  EXPECT_TRUE(draws::hold(6, -16400, 16400, [](const Integers& drawn) {
    ObjectDescription object;
    object.drift = Drift{};
    std::array<double, 3> expected{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto within = [](std::int64_t x) {
        return std::min(16384.0, std::max(-16384.0, static_cast<double>(x) * 1.0625));
      };
      object.position[i] = within(drawn[i]);
      object.drift->step[i] = within(drawn[3 + i]);
      object.page[i] = static_cast<std::int32_t>(drawn[i]);
      expected[i] = object.page[i] * 16384.0 + object.position[i];
    }
    Motion<N> motion(object, plain);
    for (int frame = 0; frame < 40; ++frame) {
      motion.advance();
      for (std::size_t i = 0; i < 3; ++i) {
        expected[i] += object.drift->step[i];
        if (std::fabs(place(motion)[i]) > 16384) return false;
        if (motion.page()[i] * 16384.0 + place(motion)[i] != expected[i]) return false;
      }
    }
    return true;
  }));
}

TYPED_TEST(MotionOf, FromTheEndOfAPageAStepOfAPage) {
  for (const double sign : {1.0, -1.0}) {
    ObjectDescription object;
    object.position = {sign * 16384, 0, 0};
    object.drift = Drift{{sign * 16384, 0, 0}, {}, {}};
    Motion<TypeParam> motion(object, plain);
    for (int frame = 1; frame <= 3; ++frame) {
      motion.advance();
      EXPECT_EQ(motion.page()[0] * 16384.0 + place(motion)[0], sign * 16384 * (frame + 1));
    }
  }
}

TYPED_TEST(MotionOf, AnOrbitStaysOnItsPageWhateverDrifts) {
  ObjectDescription object;
  object.orbit = Orbit{{16000, 0, 0}, 100, 0, 10, 0};
  object.drift = Drift{{1000, 0, 0}, {}, {}};
  Motion<TypeParam> motion(object, plain);
  for (int frame = 0; frame < 5; ++frame) motion.advance();
  EXPECT_EQ(motion.page()[0], 0);
}

}  // namespace
}  // namespace xsharp

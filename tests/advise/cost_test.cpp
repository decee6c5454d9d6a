// What frames cost: by hand from the clocks of single multiplies.
#include "verify/advise/cost.hpp"

#include <gtest/gtest.h>

#include "verify/parties/interpreter.hpp"
#include "x86model/count_clocks.hpp"
#include "xsharp/shapes.hpp"

namespace fixproof {
namespace {

constexpr auto cpu = x86model::Cpu::i386;

/// A cube that turns about so many axes, in every frame.
xsharp::Scene turning_cube(std::int32_t axes) {
  xsharp::Scene scene;
  xsharp::ObjectDescription cube;
  cube.mesh = xsharp::cube(10);
  cube.paints.resize(cube.mesh.faces.size(), {true, 1, {}});
  cube.position = {0, 0, -100};
  for (std::int32_t i = 0; i < axes; ++i) cube.spin.tenths.at(static_cast<std::size_t>(i)) = 10;
  scene.objects.push_back(cube);
  return scene;
}

double clocks(const xsharp::Scene& scene, const Turning& turning) {
  const std::atomic<bool> stop = false;
  const Choice choice{.turning = turning};
  return clocks_a_frame(scene, std::vector{choice}, cpu, stop).at(0).ranked;
}

/// The dearest and the cheapest FixedMul there are.
x86model::Range of_a_multiply() {
  const x86model::Program program = program_of({});
  const auto count = [&](std::uint32_t factor) {
    const std::array in{factor, factor};
    return x86model::count_clocks<x86model::Routine::mul>(program.instructions(), in, cpu).clocks;
  };
  return {count(0).min, count(0x80000000U).max};
}

TEST(Clocks, OfACubeThatStandsStillAreNone) {
  for (const Turning& turning : {Turning{}, Turning{false, 1}, Turning{true, 0}}) {
    EXPECT_EQ(clocks(turning_cube(0), turning), 0);
  }
}

// Restoring orthogonality is 33 products: two cross products of 6, and three times 7 towards unit
// length. An axis appended is 12, with sines computed in double.
TEST(Clocks, AreThoseOfTheProductsMade) {
  const x86model::Range multiply = of_a_multiply();
  const auto expect_products = [&](double difference, double products) {
    EXPECT_GE(difference, products * static_cast<double>(multiply.min));
    EXPECT_LE(difference, products * static_cast<double>(multiply.max));
  };
  const auto floating_cube = [](int axes) {
    xsharp::Scene scene = turning_cube(axes);
    scene.trigonometry = xsharp::Trigonometry::floating;
    return scene;
  };
  const double never = clocks(floating_cube(2), {});
  expect_products(clocks(floating_cube(2), {false, 1}) - never, 33);
  expect_products(never - clocks(floating_cube(1), {}), 12);
}

TEST(Clocks, OfRestoringAreSharedOut) {
  const xsharp::Scene scene = turning_cube(2);
  const double never = clocks(scene, {});
  const double always = clocks(scene, {false, 1});
  EXPECT_NEAR(clocks(scene, {false, 10}) - never, (always - never) / 10, 1e-6);
  EXPECT_NEAR(clocks(scene, {false, 600}) - never, (always - never) / 600, 1e-6);
}

// Turns of 360 degrees leave the matrix as it is, so that the products of both ways are the same
// twelve. From scratch takes the CosSin of the whole angle, appending that of a step; where sines
// are computed in double, appending takes none.
TEST(Clocks, FromScratchTakesOneCosSinForAnAxisAsAppendingDoes) {
  xsharp::Scene scene = turning_cube(1);
  scene.objects[0].spin.tenths = {3600, 0, 0};
  const std::array<std::uint32_t, 1> angle{0};
  const auto sine = x86model::count_clocks<x86model::Routine::cossin>(
      program_of({.operation = Operation::cossin}).instructions(), angle, cpu);
  const auto more = [&scene] { return clocks(scene, {true, 0}) - clocks(scene, {}); };
  scene.trigonometry = xsharp::Trigonometry::floating;
  EXPECT_EQ(more(), static_cast<double>(sine.clocks.min));
  // Of a step of 360 degrees, and of 0: the same way through the routine but for bringing it into
  // range.
  scene.trigonometry = xsharp::Trigonometry::table;
  const std::array<std::uint32_t, 1> step{3600};
  const auto of_step = x86model::count_clocks<x86model::Routine::cossin>(
      program_of({.operation = Operation::cossin}).instructions(), step, cpu);
  EXPECT_EQ(more(), static_cast<double>(sine.clocks.min) - static_cast<double>(of_step.clocks.min));
}

TEST(Clocks, HalfOfTheFramesCostHalf) {
  xsharp::Scene scene = turning_cube(2);
  const double always = clocks(scene, {});
  scene.objects[0].spin.delay = {1, 2};
  EXPECT_NEAR(clocks(scene, {}), always / 2, always / 50);
}

TEST(Clocks, StopWhenAsked) {
  const std::atomic<bool> stop = true;
  EXPECT_TRUE(clocks_a_frame(turning_cube(1), choices_on(cpu), cpu, stop).empty());
  EXPECT_TRUE(nanoseconds_a_frame(turning_cube(1), choices_on({}), stop).empty());
}

TEST(Nanoseconds, AreOfEveryChoice) {
  const std::atomic<bool> stop = false;
  const std::vector<Choice> choices{{}, {.target = Target::i8088}};
  const auto costs = nanoseconds_a_frame(turning_cube(1), choices, stop);
  ASSERT_EQ(costs.size(), 2U);
  for (const Cost& cost : costs) {
    EXPECT_GT(cost.least, 0);
    EXPECT_LE(cost.least, cost.most);
    EXPECT_EQ(cost.ranked, cost.most);
  }
}

// Whatever the times are: a tenth of the way from never to always, on average over rounds.
TEST(Nanoseconds, OfRestoringLieBetween) {
  const std::atomic<bool> stop = false;
  const std::vector<Choice> choices{
      {}, {.turning = {false, 600}}, {.turning = {false, 10}}, {.turning = {false, 1}}};
  const auto costs = nanoseconds_a_frame(turning_cube(2), choices, stop);
  ASSERT_EQ(costs.size(), 4U);
  for (std::size_t i = 1; i < costs.size(); ++i) {
    EXPECT_LT(costs[i - 1].ranked, costs[i].ranked) << i;
  }
}

}  // namespace
}  // namespace fixproof

// Tests the cost of frames against hand sums of single multiplies.
#include "measure/trade/advice/cost.hpp"

#include "measure/clocks/frame_clocks.hpp"
#include "tests/measure/one_cube.hpp"
#include "tests/support/test.hpp"
#include "verify/parties/interpreter.hpp"
#include "x86model/count_clocks.hpp"

namespace fixproof {
namespace {

constexpr auto cpu = x86model::Cpu::i386;

xsharp::Scene turning_cube(std::int32_t axes) {
  xsharp::Scene scene = one_cube(10, -100);
  auto& spin = scene.objects.front().spin;
  for (std::int32_t i = 0; i < axes; ++i) spin.tenths.at(static_cast<std::size_t>(i)) = 10;
  return scene;
}

double clocks(const xsharp::Scene& scene, const trade::Turning& turning) {
  const std::atomic<bool> stop = false;
  const trade::Choice choice{.turning = turning};
  return trade::clocks_per_frame(scene, std::vector{choice}, cpu, stop).at(0).ranked;
}

x86model::Range of_a_multiply() {
  const x86model::Program program = parties::program_of({});
  const auto count = [&](std::uint32_t factor) {
    const std::array in{factor, factor};
    return x86model::count_clocks<x86model::Routine::mul>(program.instructions(), in, cpu).clocks;
  };
  return {count(0).min, count(0x80000000U).max};
}

double of_a_sine(std::uint32_t tenths) {
  const x86model::Program program = parties::program_of({.operation = cases::Operation::cossin});
  const std::array in{tenths};
  const auto counted =
      x86model::count_clocks<x86model::Routine::cossin>(program.instructions(), in, cpu);
  return static_cast<double>(counted.clocks.min);
}

TEST(FrameClocks, OfACubeThatStandsStillAreNone) {
  for (const trade::Turning& turning :
       {trade::Turning{}, trade::Turning{false, 1}, trade::Turning{true, 0}}) {
    EXPECT_EQ(clocks(turning_cube(0), turning), 0);
  }
}

// Restoring orthogonality takes 33 products: two cross products of 6, and three normalisations of
// 7. Appending an axis takes 12, and a CosSin of one degree.
TEST(FrameClocks, AreThoseOfTheProductsMade) {
  const x86model::Range multiply = of_a_multiply();
  const auto expect_products = [&](double difference, double products) {
    EXPECT_GE(difference, products * static_cast<double>(multiply.min));
    EXPECT_LE(difference, products * static_cast<double>(multiply.max));
  };
  const double never = clocks(turning_cube(2), {});
  expect_products(clocks(turning_cube(2), {false, 1}) - never, 33);
  expect_products(never - clocks(turning_cube(1), {}) - of_a_sine(10), 12);
}

TEST(FrameClocks, OfRestoringAreSharedOut) {
  const xsharp::Scene scene = turning_cube(2);
  const double never = clocks(scene, {});
  const double always = clocks(scene, {false, 1});
  EXPECT_NEAR(clocks(scene, {false, 10}) - never, (always - never) / 10, 1e-6);
  EXPECT_NEAR(clocks(scene, {false, 600}) - never, (always - never) / 600, 1e-6);
}

// Turns of 360 degrees keep the matrix, so both ways take the same CosSin and twelve products.
TEST(FrameClocks, FromScratchAreThoseOfAppendingForOneAxis) {
  xsharp::Scene scene = turning_cube(1);
  scene.objects[0].spin.tenths = {3600, 0, 0};
  const double appended = clocks(scene, {});
  // Only the appended angle, 3600, must be reduced to the range.
  EXPECT_EQ(appended - clocks(scene, {true, 0}), of_a_sine(3600) - of_a_sine(0));
}

// CosSin of 0 on an 8088 executes 77 bytes, counted by hand: 28 to the comparison with 90 degrees,
// 29 for the shifts, four reads by CS: and a near jump, and 20 from CSDone on. They move 16 words
// of data. Without MUL or DIV, the bus time of 4 * 109 clocks exceeds the table's.
TEST(FrameClocks, TheBusLimitsACosSin) {
  player::OperandLog log;
  log.at(static_cast<std::size_t>(cases::Operation::cossin)) = {0};
  const measure::FrameClocks clocks =
      measure::clocks_of(log, {.target = cases::Target::i8088}, x86model::Cpu::i8088);
  EXPECT_EQ(clocks.bus, (x86model::BusBytes{77, 32}));
  EXPECT_LT(clocks.table.max, 436U);
  EXPECT_EQ(clocks.per_frame(1).at_least().min, 436);
  EXPECT_EQ(clocks.per_frame(1).at_least().max, 436);
}

// The larger of table and bus time counts. Only an 8088 has a bus time.
TEST(FrameClocks, OfAn8088HaveABus) {
  const std::atomic<bool> stop = false;
  const std::vector choices{
      trade::Choice{.build = {.target = cases::Target::i8088}, .turning = {}}};
  const auto on = [&](x86model::Cpu processor) {
    return trade::clocks_per_frame(turning_cube(1), choices, processor, stop).at(0);
  };
  EXPECT_EQ(on(x86model::Cpu::i386).bus, std::nullopt);
  const trade::Cost cost = on(x86model::Cpu::i8088);
  ASSERT_TRUE(cost.bus);
  EXPECT_GT(*cost.bus, 0);
  EXPECT_GE(cost.least, *cost.bus);
  EXPECT_GE(cost.most, cost.least);
}

TEST(FrameClocks, HalfOfTheFramesCostHalf) {
  xsharp::Scene scene = turning_cube(2);
  const double always = clocks(scene, {});
  scene.objects[0].spin.delay = {1, 2};
  EXPECT_NEAR(clocks(scene, {}), always / 2, always / 50);
}

TEST(FrameClocks, StopWhenAsked) {
  const std::atomic<bool> stop = true;
  EXPECT_TRUE(trade::clocks_per_frame(turning_cube(1), trade::choices_on(cpu), cpu, stop).empty());
  EXPECT_TRUE(trade::nanoseconds_per_frame(turning_cube(1), trade::choices_on({}), stop).empty());
}

TEST(Nanoseconds, AreOfEveryChoice) {
  const std::atomic<bool> stop = false;
  const std::vector<trade::Choice> choices{{}, {.build = {.target = cases::Target::i8088}}};
  const auto costs = trade::nanoseconds_per_frame(turning_cube(1), choices, stop);
  ASSERT_EQ(costs.size(), 2U);
  for (const trade::Cost& cost : costs) {
    EXPECT_GT(cost.least, 0);
    EXPECT_LE(cost.least, cost.most);
    EXPECT_EQ(cost.ranked, cost.most);
  }
}

// A mean of two times is never below the lesser of them, whatever the machine does meanwhile. How
// the mean is weighted, FrameClocks.OfRestoringAreSharedOut tests with clocks, which are counted
// and not timed.
TEST(Nanoseconds, OfRestoringLieBetween) {
  const std::atomic<bool> stop = false;
  const std::vector<trade::Choice> choices{
      {}, {.turning = {false, 600}}, {.turning = {false, 10}}, {.turning = {false, 1}}};
  const auto costs = trade::nanoseconds_per_frame(turning_cube(2), choices, stop);
  ASSERT_EQ(costs.size(), 4U);
  const double least = std::min(costs.front().least, costs.back().least);
  for (const trade::Cost& cost : costs) EXPECT_GE(cost.least, least * (1 - 1e-9));
}

}  // namespace
}  // namespace fixproof

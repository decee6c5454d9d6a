// Plants differences in runs of a hundred thousand operations. compare() must name the operation
// and say what differs. Equal runs must not differ.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "judge/desync/compare.hpp"
#include "tests/fixed/record/sim.hpp"
#include "tests/support/scratch_folder.hpp"

namespace desync_test {

using namespace fixproof;
using desync::Comparison;
using desync::LogFile;
using desync::Verdict;
using recorder_test::Plant;

class Runs : public testing::Test {
 protected:
  [[nodiscard]] std::string a() const { return folder_.path("a.log"); }
  [[nodiscard]] std::string b() const { return folder_.path("b.log"); }

  [[nodiscard]] Comparison compare() const {
    LogFile first(a());
    LogFile second(b());
    return desync::compare(first, second);
  }

 private:
  ScratchFolder folder_;
};

constexpr std::uint64_t turns = 25000;
// The first operation is from_raw() for the loop's constant.
constexpr std::uint64_t before = 1;

/// Records both runs, finds the block, records it in full, and returns what compare() then finds.
Comparison find(const std::string& a, const std::string& b, std::uint64_t count, Plant plant,
                std::uint64_t turn) {
  recorder_test::run(a, count, Plant::nothing, 0);
  recorder_test::run(b, count, plant, turn);
  record::full_range full;
  {
    LogFile first(a);
    LogFile second(b);
    const Comparison found = desync::compare(first, second);
    EXPECT_EQ(found.verdict, Verdict::block);
    EXPECT_LE(found.steps, 2 + static_cast<std::uint64_t>(std::log2(first.blocks() + 1)));
    full.first = static_cast<std::int64_t>(found.a.block);
    full.last = full.first + 1;
  }
  recorder_test::run(a, count, Plant::nothing, 0, full);
  recorder_test::run(b, count, plant, turn, full);
  LogFile first(a);
  LogFile second(b);
  return desync::compare(first, second);
}

void expect_at(const Comparison& found, std::uint64_t operation) {
  ASSERT_TRUE(found.a.index && found.b.index);
  EXPECT_EQ(found.a.records[*found.a.index].operation, operation);
  EXPECT_EQ(found.b.records[*found.b.index].operation, operation);
}

TEST_F(Runs, EqualRunsHaveNoDifference) {
  recorder_test::run(a(), turns, Plant::nothing, 0);
  recorder_test::run(b(), turns, Plant::nothing, 0);
  const Comparison found = compare();
  EXPECT_EQ(found.verdict, Verdict::equal);
  EXPECT_EQ(found.operations, before + 4 * turns);
  EXPECT_EQ(found.steps, 1U);
}

TEST_F(Runs, AShorterRunHasNoDifference) {
  recorder_test::run(a(), turns, Plant::nothing, 0,
                     {.is_of_frames = false, .first = 0, .last = 99999});
  recorder_test::run(b(), turns - 777, Plant::nothing, 0,
                     {.is_of_frames = false, .first = 0, .last = 99999});
  const Comparison found = compare();
  EXPECT_EQ(found.verdict, Verdict::ended);
  EXPECT_EQ(found.operations, before + 4 * (turns - 777));
}

TEST_F(Runs, AShorterRunHasNoDifferenceWithoutRecords) {
  recorder_test::run(a(), turns, Plant::nothing, 0);
  recorder_test::run(b(), turns - 777, Plant::nothing, 0);
  EXPECT_EQ(compare().verdict, Verdict::ended);
}

TEST_F(Runs, OneOperand) {
  const Comparison found = find(a(), b(), turns, Plant::operand, turns - 5);
  EXPECT_EQ(found.verdict, Verdict::operands);
  expect_at(found, before + 4 * (turns - 5) + 1);
  const desync::Record& record = found.a.records[*found.a.index];
  const auto mine = desync::operation_of(record.words);
  const auto theirs = desync::operation_of(found.b.records[*found.b.index].words);
  EXPECT_EQ(mine.kind, record::kind::add);
  EXPECT_EQ(mine.operands.at(0).bits ^ theirs.operands.at(0).bits, 1U);
  EXPECT_EQ(mine.operands.at(1), theirs.operands.at(1));
  EXPECT_EQ(record.input, std::nullopt);
  EXPECT_NE(record.line, 0U);
  LogFile log(a());
  EXPECT_TRUE(log.name(record.file).ends_with("sim.hpp")) << log.name(record.file);
  EXPECT_EQ(log.name(found.a.entry.name), "even");
  EXPECT_EQ(found.a.entry.frame, static_cast<std::int64_t>(turns / 5000) - 1);
}

TEST_F(Runs, OneOperandThatChangesNoResult) {
  for (const auto& [path, other] : {std::pair(a(), 5), std::pair(b(), 6)}) {
    const record::log log(path, {.program = "test", .full = {false, 0, 0}});
    recorder_test::real x;
    for (int i = 0; i < 100; ++i) x = x * recorder_test::real(q16_16(i == 50 ? other : 7));
  }
  const Comparison found = compare();
  EXPECT_EQ(found.verdict, Verdict::operands);
  expect_at(found, 50);
}

TEST_F(Runs, OneResult) {
  const Comparison found = find(a(), b(), turns, Plant::arithmetic, turns / 3);
  EXPECT_EQ(found.verdict, Verdict::arithmetic);
  expect_at(found, before + 4 * (turns / 3) + 1);
}

TEST_F(Runs, TwoSwappedAdditions) {
  const Comparison found = find(a(), b(), turns, Plant::order, turns / 2);
  EXPECT_EQ(found.verdict, Verdict::order);
  expect_at(found, before + 4 * (turns / 2) + 1);
}

/// Records sums of products, whose order the compiler may choose. `other` selects the other order.
void sums_of_products(const std::string& path, bool other, int wrong,
                      record::full_range full = {}) {
  const record::log log(path, {.program = "test", .full = full});
  using real = recorder_test::real;
  real x(1);
  for (int i = 0; i < 50000; ++i) {
    const real y = x + real(q16_16::from_raw(i));
    if (i == wrong) x.value_ = x.plain() + q16_16::from_raw(1);
    const real first = other ? y * y : x * x;
    const real second = other ? x * x : y * y;
    // With five records in a turn, some blocks end between the products.
    x = -(other ? second + first : first + second);
  }
}

TEST_F(Runs, OperandsThatAreComputedInAnotherOrderAreNoDifference) {
  sums_of_products(a(), false, -1);
  sums_of_products(b(), true, -1);
  EXPECT_EQ(compare().verdict, Verdict::equal);
}

TEST_F(Runs, ADifferenceAmongOperandsInAnotherOrderIsFound) {
  for (const int wrong : {1, 2, 255, 256, 1023, 20000, 49999}) {
    record::full_range full;
    for (int pass = 0; pass < 2; ++pass) {
      sums_of_products(a(), false, -1, full);
      sums_of_products(b(), true, wrong, full);
      const Comparison found = compare();
      if (pass == 0) {
        ASSERT_EQ(found.verdict, Verdict::block);
        full = {false, static_cast<std::int64_t>(found.a.block),
                static_cast<std::int64_t>(found.a.block) + 1};
        continue;
      }
      ASSERT_TRUE(found.a.index) << wrong;
      const auto operation = found.a.records[*found.a.index].operation;
      // One conversion, then five operations in each turn. The product of the wrong number is the
      // second.
      EXPECT_EQ(operation, 1 + 5 * static_cast<std::uint64_t>(wrong) + 1) << wrong;
    }
  }
}

TEST_F(Runs, OneMoreOperation) {
  const Comparison found = find(a(), b(), turns, Plant::extra, 4321);
  EXPECT_EQ(found.verdict, Verdict::path);
  expect_at(found, before + std::uint64_t{4} * 4321 + 1);
}

/// Records two short runs in full, and returns what compare() finds in either order.
template <class First, class Second>
std::pair<Comparison, Comparison> compare_short(const std::string& a, const std::string& b,
                                                const First& first, const Second& second) {
  {
    const record::log log(a, {.full = {.first = 0, .last = 9}});
    first();
  }
  {
    const record::log log(b, {.full = {.first = 0, .last = 9}});
    second();
  }
  LogFile x(a);
  LogFile y(b);
  return {desync::compare(x, y), desync::compare(y, x)};
}

TEST_F(Runs, ARepeatedOperation) {
  using recorder_test::real;
  const auto run = [](int repeated) {
    for (int i = 0; i < 20; ++i) {
      const real x(q16_16::from_raw(i));
      (void)(x + x);
      if (i == repeated) (void)(x + x);
    }
  };
  const auto [one, other] = compare_short(
      a(), b(), [&] { run(-1); }, [&] { run(12); });
  for (const Comparison& found : {one, other}) {
    EXPECT_EQ(found.verdict, Verdict::operands);
    expect_at(found, 13);
  }
}

/// The operation is soon before the end of a frame, and the next frame does not depend on it.
TEST_F(Runs, OneMoreOperationThatChangesNoOther) {
  using recorder_test::real;
  const auto run = [](bool more, bool soon) {
    record::frame(0);
    real sum;
    for (int i = 1; i < 20; ++i) sum += q16_16(i);
    if (more) (void)real::from_raw(5);
    record::frame(1);
    for (int i = 1; i < (soon ? 4 : 20); ++i) sum *= q16_16(i);
    // Another difference: of another kind than the operation, or far from it.
    (void)(soon ? -real(q16_16(more ? 6 : 7)) : real::from_raw(more ? 6 : 7));
  };
  for (const bool soon : {false, true}) {
    const auto [one, other] = compare_short(
        a(), b(), [&] { run(false, soon); }, [&] { run(true, soon); });
    for (const Comparison& found : {one, other}) {
      EXPECT_EQ(found.verdict, Verdict::path) << soon;
      expect_at(found, 19);
    }
  }
}

TEST_F(Runs, ARepeatedOperationAmongOthersInAnotherOrder) {
  const recorder_test::real x(q16_16(2));
  const auto [one, other] = compare_short(
      a(), b(), [&] { (void)-x, (void)(x + x), (void)sqrt(x); },
      [&] { (void)(x + x), (void)(x + x), (void)-x, (void)floor(x); });
  for (const Comparison& found : {one, other}) {
    EXPECT_EQ(found.verdict, Verdict::path);
    expect_at(found, 1);
  }
}

TEST_F(Runs, AnotherType) {
  const auto [one, other] = compare_short(
      a(), b(), [] { (void)(recorded<q16_16>(q16_16(1)) + recorded<q16_16>(q16_16(2))); },
      [] { (void)(recorded<q8_8>(q8_8(1)) + recorded<q8_8>(q8_8(2))); });
  EXPECT_EQ(one.verdict, Verdict::type);
  EXPECT_EQ(other.verdict, Verdict::type);
  expect_at(one, 0);
}

TEST_F(Runs, ANumberThatEnters) {
  using recorder_test::real;
  const auto is_input = [&](const auto& f) {
    const auto [one, other] = compare_short(
        a(), b(), [&] { f(1); }, [&] { f(2); });
    return one.verdict == Verdict::input && other.verdict == Verdict::input;
  };
  EXPECT_TRUE(is_input([](int x) { (void)real::from_raw(x); }));
  EXPECT_TRUE(is_input([](int x) { (void)real(x); }));
  EXPECT_TRUE(is_input([](int x) { (void)(ratio<real>(x, 3)); }));
  EXPECT_TRUE(is_input([](int x) { (void)(real(x / 4.0)); }));
  EXPECT_FALSE(is_input([](int x) { (void)(real(q16_16(x)) * 3); }));
}

TEST_F(Runs, TheFirstOperationAndTheLast) {
  expect_at(find(a(), b(), turns, Plant::operand, 0), before + 1);
  expect_at(find(a(), b(), turns, Plant::order, turns - 1), before + 4 * (turns - 1) + 1);
}

TEST_F(Runs, ADoubleThatRoundsToTheSameNumberIsNoDifference) {
  for (const auto& [path, x] : {std::pair(a(), 0.1), std::pair(b(), 0.1 + 1e-12)}) {
    const record::log log(path);
    recorder_test::real sum(x);
    sum += sum;
  }
  EXPECT_EQ(compare().verdict, Verdict::equal);
}

TEST_F(Runs, ADoubleThatDiffersIsShown) {
  for (const auto& [path, x] : {std::pair(a(), 0.1), std::pair(b(), 0.1 + 1e-4)}) {
    const record::log log(path, {.program = "test", .full = {false, 0, 0}});
    recorder_test::real sum(x);
    sum += sum;
  }
  const Comparison found = compare();
  EXPECT_EQ(found.verdict, Verdict::input);
  expect_at(found, 0);
  EXPECT_EQ(found.a.records.at(0).input, std::bit_cast<std::uint64_t>(0.1));
  EXPECT_EQ(found.b.records.at(0).input, std::bit_cast<std::uint64_t>(0.1 + 1e-4));
}

TEST_F(Runs, TheLongestNamesAreCutAndFound) {
  const std::string name(300, 'x');
  {
    const record::log log(a(), {.full = {.first = 0, .last = 0}});
    record::mark(name);
    (void)(recorder_test::real(1) + recorder_test::real(2));
  }
  LogFile log(a());
  EXPECT_EQ(log.name(1), name.substr(0, 255));
  EXPECT_EQ(log.name_with_hash(log.records(0).at(1).name), name.substr(0, 255));
}

}  // namespace desync_test

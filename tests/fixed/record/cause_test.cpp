// What desync says of operands that differ. A compiler may compute arguments in any order, so each
// test writes out the two orders.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "judge/desync/compare.hpp"
#include "support/strict_json.hpp"
#include "tests/fixed/record/sim.hpp"
#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cause_test {

using namespace fixproof;
using desync::Comparison;
using desync::LogFile;
using desync::Verdict;
using recorder_test::real;

class Causes : public testing::Test {
 protected:
  [[nodiscard]] std::string a() const { return folder_.path("a.log"); }
  [[nodiscard]] std::string b() const { return folder_.path("b.log"); }

  /// Records two runs in full, expects one cause in both orders of the logs, and returns what
  /// compare() finds.
  template <class First, class Second>
  Comparison compare(const First& first, const Second& second, Verdict expected) {
    record_run(a(), first);
    record_run(b(), second);
    LogFile x(a());
    LogFile y(b());
    EXPECT_EQ(desync::compare(y, x).verdict, expected);
    Comparison found = desync::compare(x, y);
    EXPECT_EQ(found.verdict, expected);
    return found;
  }

  /// What the command says of the runs.
  [[nodiscard]] std::string said() const {
    const command::Run run = command::run({paths::command(), "desync", a(), b()});
    EXPECT_EQ(run.status, 1) << run.err;
    return run.out;
  }

  /// The same as JSON.
  [[nodiscard]] nlohmann::json said_json() const {
    const command::Run run = command::run({paths::command(), "desync", a(), b(), "--json", "-"});
    EXPECT_EQ(run.status, 1) << run.err;
    return fixproof::support::parse_strictly(run.out);
  }

 private:
  template <class Run>
  static void record_run(const std::string& path, const Run& run) {
    const record::log log(path, {.full = {.first = 0, .last = 9}});
    run();
  }

  ScratchFolder folder_;
};

/// A random number: 7, 14, 21.
class Dice {
 public:
  int next() { return last_ += 7; }

 private:
  int last_ = 0;
};

/// Makes its numbers itself, so that the order of its arguments is that of the numbers.
real difference(int a, int b) {
  const real x(a);
  const real y(b);
  return x - y;
}

TEST_F(Causes, ArgumentsThatAreComputedInAnotherOrder) {
  const Comparison found = compare(
      [] {
        Dice dice;
        const int b = dice.next();
        const int a = dice.next();
        (void)difference(a, b);
      },
      [] {
        Dice dice;
        const int a = dice.next();
        const int b = dice.next();
        (void)difference(a, b);
      },
      Verdict::evaluation);
  ASSERT_TRUE(found.a.index && found.b.index && found.origin);
  EXPECT_EQ(found.a.records[*found.a.index].operation, 2U);
  EXPECT_EQ(found.b.records[*found.b.index].operation, 2U);
  EXPECT_EQ(desync::text_of(found.origin->of_a), "14 (000e0000)");
  EXPECT_EQ(desync::text_of(found.origin->of_b), "7 (00070000)");
  EXPECT_EQ(found.origin->of_a_in_a, 0U);
  EXPECT_EQ(found.origin->of_a_in_b, 1U);
  EXPECT_EQ(found.origin->of_b_in_a, 1U);
  EXPECT_EQ(found.origin->of_b_in_b, 0U);
  const std::string text = said();
  command::expect_contains(text,
                           "\nThe two values were computed in another order, as by unspecified "
                           "evaluation of arguments.\n");
  command::expect_contains(
      text, "\n14 (000e0000) is the result of operation 0 of A and of operation 1 of B.\n");
  EXPECT_EQ(text.find("memory"), std::string::npos) << text;
  const auto json = said_json();
  EXPECT_EQ(json["command"], "desync");
  EXPECT_EQ(json["status"], "wrong");
  const auto& difference = json["difference"];
  EXPECT_EQ(difference["kind"], "evaluation");
  const nlohmann::json both{{{"value", "14 (000e0000)"}, {"a", 0}, {"b", 1}},
                            {{"value", "7 (00070000)"}, {"a", 1}, {"b", 0}}};
  EXPECT_EQ(difference["computed_in"], both);
  ASSERT_EQ(difference["a"].size(), 3U);
  EXPECT_EQ(difference["a"][2]["differs"], true);
  EXPECT_EQ(difference["a"][2]["operation"], 2);
  command::expect_contains(text, std::string(difference["a"][2]["text"]));
}

TEST_F(Causes, SwappedOperands) {
  const Comparison found = compare(
      [] {
        Dice dice;
        const real right(dice.next());
        const real left(dice.next());
        (void)(left - right);
      },
      [] {
        Dice dice;
        const real left(dice.next());
        const real right(dice.next());
        (void)(left - right);
      },
      Verdict::swapped);
  ASSERT_TRUE(found.origin);
  EXPECT_EQ(found.origin->of_a_in_a, 1U);
  EXPECT_EQ(found.origin->of_a_in_b, 1U);
  EXPECT_EQ(found.origin->of_b_in_a, 0U);
  EXPECT_EQ(found.origin->of_b_in_b, 0U);
  const std::string text = said();
  command::expect_contains(text, "\nThe operands are swapped: ");
  command::expect_contains(text, "The logs cannot tell.\n");
  EXPECT_EQ(text.find("memory"), std::string::npos) << text;
}

TEST_F(Causes, SwappedOperandsThatWereComputedWithoutALog) {
  const real x(q16_16(3));
  const real y(q16_16(5));
  const Comparison found = compare([&] { (void)(x / y); }, [&] { (void)(y / x); },  //
                                   Verdict::swapped);
  EXPECT_FALSE(found.origin);
}

/// Moves a point by three numbers, which were computed before.
void move(const real& x, const real& y, const real& z) {
  (void)(x * real(q16_16(100)));
  (void)(y * real(q16_16(200)));
  (void)(z * real(q16_16(300)));
}

TEST_F(Causes, TheSameValuesInAnotherOrder) {
  const auto run = [](bool from_the_right) {
    Dice dice;
    const real one(dice.next());
    const real two(dice.next());
    const real three(dice.next());
    from_the_right ? move(three, two, one) : move(one, two, three);
  };
  const Comparison found = compare([&] { run(true); }, [&] { run(false); }, Verdict::moved);
  ASSERT_TRUE(found.origin);
  EXPECT_EQ(desync::text_of(found.origin->of_a), "21 (00150000)");
  EXPECT_EQ(found.origin->of_a_in_a, 2U);
  EXPECT_EQ(found.origin->of_b_in_a, 0U);
  const std::string text = said();
  command::expect_contains(text, "\nThe same values are in another order: ");
  command::expect_contains(text, "The logs cannot tell.\n");
}

TEST_F(Causes, ThreeArgumentsThatAreComputedInAnotherOrder) {
  const auto run = [](int a, int b, int c) {
    const real x(a);
    const real y(b);
    const real z(c);
    move(x, y, z);
  };
  compare([&] { run(21, 14, 7); }, [&] { run(7, 14, 21); }, Verdict::evaluation);
}

/// Two of the three values only.
TEST_F(Causes, ValuesThatAreNotExchangedAreOperands) {
  const auto run = [](bool wrong) {
    Dice dice;
    const real one(dice.next());
    const real two(dice.next());
    const real three(dice.next());
    move(wrong ? two : one, two, three);
  };
  compare([&] { run(false); }, [&] { run(true); }, Verdict::operands);
  const std::string text = said();
  command::expect_contains(text, "\nThe operands differ, although every recorded operation ");
  command::expect_contains(text, "logs cannot tell why.");
}

/// The products are computed in another order, which is no difference. The sum is.
TEST_F(Causes, AHarmlessOrderIsNotTheCause) {
  const auto run = [](bool other, int added) {
    const real x(3);
    const real y(5);
    const real first = other ? y * y : x * x;
    const real second = other ? x * x : y * y;
    real sum = other ? second : first;
    sum.value_ = sum.plain() + q16_16(added);
    (void)(sum + (other ? first : second));
  };
  compare([&] { run(false, 0); }, [&] { run(true, 1); }, Verdict::operands);
}

TEST_F(Causes, ANumberFromMemory) {
  const auto run = [](int planted) {
    real x(1);
    const real y(2);
    x.value_ = q16_16(planted);
    (void)(x + y);
  };
  compare([&] { run(40); }, [&] { run(41); }, Verdict::operands);
}

TEST_F(Causes, AnIntegerOperand) {
  const real x(q16_16(3));
  compare([&] { (void)(x * 7); }, [&] { (void)(x * 8); }, Verdict::integer);
  command::expect_contains(said(), "\nAn operand differs that is an integer. ");
  compare([&] { (void)(x << 2); }, [&] { (void)(x << 3); }, Verdict::integer);
}

TEST_F(Causes, AnAccumulatorThatWasCopied) {
  const auto run = [](bool copied) {
    fixproof::accumulator<real> sum;
    const fixproof::accumulator<real> before = sum;
    sum.add(real(q16_16(5)));
    if (copied) sum = before;
    (void)sum.result();
  };
  compare([&] { run(false); }, [&] { run(true); }, Verdict::accumulator);
  command::expect_contains(said(), "\nThe sums in the accumulators differ, ");
}

}  // namespace cause_test

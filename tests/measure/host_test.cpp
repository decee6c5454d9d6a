// Tests that contenders are checked before timing and timed in turn.
#include "measure/host/host.hpp"

#include <algorithm>
#include <set>
#include <string_view>

#include "measure/accuracy/accuracy_run.hpp"
#include "tests/measure/never.hpp"
#include "tests/support/test.hpp"

struct CutNumber {
  std::int32_t raw = 0;

  friend CutNumber operator*(CutNumber a, CutNumber b) {
    return {static_cast<std::int32_t>((std::int64_t{a.raw} * b.raw) >> 16)};
  }
};

template <>
struct fixproof::measure::MeasuredNumber<CutNumber> {
  static CutNumber of_word(std::uint32_t word) { return {static_cast<std::int32_t>(word)}; }
  static double in_units(CutNumber x) { return x.raw; }
};

namespace {

using namespace fixproof;

// Sorted, 1 2 3 4 5 has the quartiles 2, 3 and 4.
TEST(HostTimes, LeastMedianAndSpread) {
  const measure::Times times = measure::times_of({4, 1, 5, 3, 2});
  EXPECT_EQ(times.min, 1);
  EXPECT_EQ(times.median, 3);
  EXPECT_DOUBLE_EQ(times.spread, 2.0 / 3);
  EXPECT_EQ(measure::times_of({7}).median, 7);
  EXPECT_EQ(measure::times_of({7}).spread, 0);
}

TEST(HostTimes, LoopsAreTimedInTurn) {
  std::string order;
  const auto loop = [&order](char name) {
    return measure::TimedLoop{[&order, name] {
                                if (order.empty() || order.back() != name) order += name;
                              },
                              1};
  };
  std::vector<std::uint64_t> rounds;
  const auto times = measure::time_in_turn(
      {loop('a'), loop('b')}, 3, never, [&rounds](std::uint64_t done) { rounds.push_back(done); });
  EXPECT_EQ(times.size(), 2U);
  EXPECT_EQ(rounds, (std::vector<std::uint64_t>{1, 2, 3}));
  EXPECT_EQ(order, "abababab") << "once for the length of a sample, then three rounds";
}

TEST(HostTimes, NoneWhereItIsStopped) {
  const std::atomic<bool> stopped{true};
  EXPECT_TRUE(
      measure::time_in_turn({{[] {}, 1}}, 3, stopped, [](std::uint64_t) { FAIL(); }).empty());
}

TEST(HostErrors, AreExactForWhatIsNoWord) {
  measure::ErrorStatistics quarter;
  measure::add_error(quarter, 0.25, {1, 3});
  EXPECT_DOUBLE_EQ(quarter.mean(), -1.0 / 12);
  EXPECT_EQ(quarter.correct(), 1);
  measure::ErrorStatistics half;
  measure::add_error(half, 3, {5, 2});
  EXPECT_EQ(half.mean(), 0.5);
  EXPECT_EQ(half.correct(), 1);
  measure::ErrorStatistics more;
  measure::add_error(more, 3 + 0x1p-50, {5, 2});
  EXPECT_EQ(more.correct(), 0);
  measure::ErrorStatistics small;
  measure::add_error(small, -0x1p-70, {0, 1});
  EXPECT_EQ(small.mean(), -0x1p-70);
}

const std::vector<measure::HostOperation>& operations() {
  static const auto made = measure::host_operations(7, 4);
  return made;
}

const measure::HostOperation& operation_of(std::string_view name) {
  for (const measure::HostOperation& o : operations()) {
    if (o.name == name) return o;
  }
  throw std::invalid_argument("no such operation");
}

measure::HostRow row_of(std::string_view operation, std::string_view contender) {
  const measure::HostOperation& o = operation_of(operation);
  for (const measure::HostContender& c : o.contenders) {
    if (c.name == contender) return measure::judge_contender(o, c);
  }
  throw std::invalid_argument("no such contender");
}

/// The error message for a wrong contender; empty for a correct one.
std::string complaint(const measure::HostOperation& operation,
                      const measure::HostContender& contender) {
  try {
    measure::judge_contender(operation, contender);
  } catch (const measure::WrongContender& e) {
    return e.what();
  }
  return "";
}

TEST(HostContenders, OneThatBreaksItsRuleIsNamedWithTheCase) {
  const auto said = measure::product_contender<CutNumber, oracle::Rounding::floor>(
      "cut", "", measure::HostKind::plain);
  EXPECT_EQ(complaint(operation_of("mul"), said), "");
  const auto cut = measure::product_contender<CutNumber, oracle::Rounding::half_up>(
      "cut", "", measure::HostKind::plain);
  const std::string text = complaint(operation_of("mul"), cut);
  EXPECT_EQ(text.substr(0, 12), "mul of cut: ") << text;
  EXPECT_NE(text.find(", which is not rounded to nearest, halves up"), std::string::npos) << text;
  // The two operands and the result have eight digits each.
  EXPECT_EQ(text.substr(20, 1), " ") << text;
  EXPECT_EQ(text.substr(29, 7), " gives ") << text;
}

class BrokenChain final : public measure::HostLoop {
 public:
  void load(measure::CaseWords words) override { loop_.load(words); }
  void apply_all() override { loop_.apply_all(); }
  [[nodiscard]] measure::HostCase result(std::size_t i) const override { return loop_.result(i); }
  void load_chain(std::uint32_t start, measure::CaseWords words) override {
    loop_.load_chain(start, words);
  }
  void apply_in_chain() override { loop_.apply_in_chain(); }
  [[nodiscard]] measure::HostCase chain_result(std::size_t i) const override {
    measure::HostCase c = loop_.chain_result(i);
    if (i == 1000) c.result += 1;
    return c;
  }

 private:
  measure::ArrayLoop<measure::HostProduct, measure::PlainNumber> loop_;
};

TEST(HostContenders, TheResultsOfAChainAreJudgedToo) {
  measure::HostContender contender =
      measure::product_contender<measure::PlainNumber, oracle::Rounding::half_up>(
          "idiom", "", measure::HostKind::plain);
  EXPECT_EQ(complaint(operation_of("mul"), contender), "");
  contender.loop = std::make_shared<BrokenChain>();
  EXPECT_NE(complaint(operation_of("mul"), contender), "");
}

TEST(HostContenders, AllKeepTheirRules) {
  for (const measure::HostOperation& o : operations()) {
    std::set<std::string> names;
    for (const measure::HostContender& c : o.contenders) {
      EXPECT_EQ(complaint(o, c), "") << o.name;
      EXPECT_TRUE(names.insert(c.name).second) << o.name << ' ' << c.name;
    }
    for (const char* name : {"q16_16", "float", "double"}) EXPECT_EQ(names.count(name), 1U);
    EXPECT_EQ(names.count("FreeType"),
              measure::has_freetype() && o.name != "sqrt" && o.name != "cos" ? 1U : 0U);
    EXPECT_EQ(names.count("libfixmath"), measure::has_libfixmath() && o.name != "cos" ? 1U : 0U);
  }
}

TEST(HostContenders, TheirErrorsAreThoseOfTheirRoundings) {
  const measure::HostRow nearest = row_of("mul", "q16_16");
  EXPECT_EQ(nearest.cases, 5U * 1024);
  EXPECT_EQ(nearest.errors.cases(), 4U * 1024) << "the chain is judged, and has no share in errors";
  EXPECT_EQ(nearest.exceptions, 0U);
  EXPECT_EQ(nearest.errors.correct(), 1);
  EXPECT_EQ(row_of("mul", "double").errors.max(), 0) << "48 bits have room";
  // In float, products of 2^29 units and more are multiples of 64.
  const double of_float = row_of("mul", "float").errors.max();
  EXPECT_GT(of_float, 16);
  EXPECT_LE(of_float, 32);
  EXPECT_LE(row_of("div", "idiom").errors.max(), 1);
  EXPECT_GT(row_of("div", "idiom").errors.max(), 0.9);
  EXPECT_LE(row_of("vertex", "q16_16").errors.max(), 1.5);
  EXPECT_LE(row_of("cos", "q16_16").errors.max(), 0.5);
}

TEST(HostContenders, LibfixmathDividesAreExceptionsInOneCaseOfAThousand) {
  if (!measure::has_libfixmath()) GTEST_SKIP() << "libfixmath is not installed";
  measure::HostOperation divide;
  for (measure::HostOperation& o : measure::host_operations(7, 20)) {
    if (o.name == "div") divide = std::move(o);
  }
  for (const measure::HostContender& c : divide.contenders) {
    const std::uint64_t exceptions = measure::judge_contender(divide, c).exceptions;
    if (c.name != "libfixmath") {
      EXPECT_EQ(exceptions, 0U) << c.name;
      continue;
    }
    EXPECT_GE(exceptions, 5U);
    EXPECT_LE(exceptions, 60U);
  }
  EXPECT_EQ(row_of("mul", "libfixmath").exceptions, 0U);
}

std::pair<double, double> range_of_chain(const measure::HostOperation& o,
                                         const measure::HostContender& c) {
  measure::judge_contender(o, c);
  double least = 0x1p40;
  double most = 0;
  for (std::size_t i = 0; i < o.operands.taken.size(); ++i) {
    const double x = std::abs(c.loop->chain_result(i).result) / 65536;
    least = std::min(least, x);
    most = std::max(most, x);
  }
  return {least, most};
}

TEST(HostContenders, ChainsStayInTheRangeThatIsSaid) {
  for (const measure::HostContender& c : operation_of("mul").contenders) {
    const auto [least, most] = range_of_chain(operation_of("mul"), c);
    EXPECT_GT(least, 95) << c.name;
    EXPECT_LT(most, 205) << c.name;
  }
  for (const measure::HostContender& c : operation_of("div").contenders) {
    const auto [least, most] = range_of_chain(operation_of("div"), c);
    EXPECT_GT(least, 80) << c.name;
    EXPECT_LT(most, 250) << c.name;
  }
}

TEST(HostContenders, OperandsComeFromTheSeed) {
  EXPECT_EQ(measure::product_operands(3, 2).words, measure::product_operands(3, 2).words);
  EXPECT_NE(measure::product_operands(3, 2).words, measure::product_operands(4, 2).words);
  EXPECT_NE(measure::vertex_operands(3, 1).words, measure::vertex_operands(4, 1).words);
  const auto quotients = measure::quotient_operands(3, 4).words;
  for (std::size_t i = 1; i < quotients.size(); i += 2) {
    EXPECT_GE(std::abs(static_cast<std::int32_t>(quotients[i])), 65536);
  }
}

}  // namespace

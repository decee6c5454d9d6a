#include "oracle/exact.hpp"
#include "oracle/unbounded.hpp"
#include "tests/oracle/rules.hpp"
#include "tests/support/test.hpp"

namespace oracle {
namespace {

constexpr std::optional<Word> kFault = std::nullopt;

struct QuotientsByRule {
  std::optional<Word> i386_rounded;
  std::optional<Word> i386_unrounded;
  std::optional<Word> i8088_rounded;
  std::optional<Word> i8088_unrounded;
};

void expect_div(Word n, Word d, const QuotientsByRule& expected, int fraction_bits = 16) {
  const std::array results{expected.i386_rounded, expected.i386_unrounded, expected.i8088_rounded,
                           expected.i8088_unrounded};
  for (const DivideRule rule : test::kDivideRules) {
    const auto index = static_cast<std::size_t>(rule);
    EXPECT_EQ(div(n, d, rule, fraction_bits), results.at(index))
        << std::hex << n << " / " << d << ", rule " << index;
  }
}

TEST(OracleDiv, ByZeroAlwaysFaults) {
  for (const Word n : {0U, 1U, 0x10000U, 0x7fffffffU, 0x80000000U}) {
    expect_div(n, 0, {kFault, kFault, kFault, kFault});
  }
}

TEST(OracleDiv, InexactQuotients) {
  expect_div(1, 0x30000, {0, 0, 0, 0});
  expect_div(2, 0x30000, {1, 0, 1, 0});
  expect_div(0xfffffffe, 0x30000, {0xffffffff, 0, 0xffffffff, 0});
}

TEST(OracleDiv, HalvesGoAwayFromZero) {
  expect_div(1, 0x20000, {1, 0, 1, 0});
  expect_div(3, 0x20000, {2, 1, 2, 1});
  expect_div(0xffffffff, 0x20000, {0xffffffff, 0, 0xffffffff, 0});
  expect_div(3, 0xfffe0000, {0xfffffffe, 0xffffffff, 0xfffffffe, 0xffffffff});
}

TEST(OracleDiv, The8088DropsTheFractionOfTheDivisorsMagnitude) {
  // 1 / 1.5 is 43690.67 ulps; with the divisor 1 it is 1.0.
  expect_div(0x10000, 0x18000, {0xaaab, 0xaaaa, 0x10000, 0x10000});
  expect_div(0x10000, 0xfffe8000, {0xffff5555, 0xffff5556, 0xffff0000, 0xffff0000});
}

TEST(OracleDiv, The8088FaultsBelowOne) {
  expect_div(0x10000, 0x8000, {0x20000, 0x20000, kFault, kFault});
  expect_div(0x10000, 0xffff8000, {0xfffe0000, 0xfffe0000, kFault, kFault});
  expect_div(0, 0xffff, {0, 0, kFault, kFault});
  expect_div(0, 0xffff0001, {0, 0, kFault, kFault});
  expect_div(0, 0xffff0000, {0, 0, 0, 0});
}

TEST(OracleDiv, TheRounded386WrapsWhereTheSignBitAloneIsMissing) {
  expect_div(0x8001, 1, {0x80010000, kFault, kFault, kFault});
  expect_div(0x8001, 0xffffffff, {0x7fff0000, kFault, kFault, kFault});
  expect_div(0x8000, 1, {0x80000000, kFault, kFault, kFault});
  expect_div(0x8000, 0xffffffff, {0x80000000, 0x80000000, kFault, kFault});
  expect_div(0x7fff, 1, {0x7fff0000, 0x7fff0000, kFault, kFault});
}

TEST(OracleDiv, TheRounded386FaultsFromTwoToTheThirtyTwo) {
  expect_div(0xffff, 1, {0xffff0000, kFault, kFault, kFault});
  expect_div(0x10000, 1, {kFault, kFault, kFault, kFault});
  expect_div(0xffff0000, 1, {kFault, kFault, kFault, kFault});
  expect_div(0x80000000, 0x8000, {kFault, kFault, kFault, kFault});
  // -2^47 / 32769 is -4294836227.9999, whose magnitude is below 2^32.
  expect_div(0x80000000, 0x8001, {0x0001fffc, kFault, kFault, kFault});
}

TEST(OracleDiv, TheMostNegativeWord) {
  expect_div(0x80000000, 0x10000, {0x80000000, 0x80000000, 0x80000000, 0x80000000});
  expect_div(0x80000000, 0xffff0000, {0x80000000, kFault, 0x80000000, 0x80000000});
  expect_div(0x80000000, 0x80000000, {0x10000, 0x10000, 0x10000, 0x10000});
  expect_div(0x10000, 0x80000000, {0xfffffffe, 0xfffffffe, 0xfffffffe, 0xfffffffe});
}

TEST(OracleDiv, HalfWidth) {
  expect_div(0x81, 1, {0x8100, kFault, kFault, kFault}, 8);
  expect_div(0x81, 0xffff, {0x7f00, kFault, kFault, kFault}, 8);
  expect_div(0x100, 1, {kFault, kFault, kFault, kFault}, 8);
  expect_div(0x8000, 0xff00, {0x8000, kFault, 0x8000, 0x8000}, 8);
  expect_div(0x100, 0x180, {0xab, 0xaa, 0x100, 0x100}, 8);
}

TEST(OracleQuotient, FollowsTheRuleAndFaultsAtZeroAlone) {
  EXPECT_EQ(quotient(0xffffffff, 0x20000, Rounding::half_up, 16), 0U);
  EXPECT_EQ(quotient(0xffffffff, 0x20000, Rounding::half_away, 16), 0xffffffffU);
  EXPECT_EQ(quotient(0xffffffff, 0x20000, Rounding::floor, 16), 0xffffffffU);
  EXPECT_EQ(quotient(0xffffffff, 0x20000, Rounding::truncate, 16), 0U);
  EXPECT_EQ(quotient(0x10000, 1, Rounding::floor, 16), 0U);
  EXPECT_EQ(quotient(0, 0, Rounding::floor, 16), std::nullopt);
}

TEST(OracleQuotient, UnboundedKeepsEveryDigit) {
  EXPECT_EQ(exact_quotient(0x7fffffff, 1, Rounding::floor, 16), Integer("140737488289792"));
  EXPECT_EQ(exact_quotient(0x80000000, 1, Rounding::floor, 16), -(Integer(1) << 47));
  EXPECT_EQ(exact_quotient(1, 0, Rounding::floor, 16), std::nullopt);
}

}  // namespace
}  // namespace oracle

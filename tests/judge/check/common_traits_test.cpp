// Tests what all wrong cases are said to have in common: one planted defect per trait.
#include "judge/check/common_traits.hpp"

#include "judge/check/verdict_text.hpp"
#include "tests/judge/check/judged.hpp"
#include "tests/support/test.hpp"

namespace {

using fixproof::check::CommonTraits;
using fixproof::check::TraitCase;
using namespace subjects;
using fixproof::cases::Operation;
using Lines = std::vector<std::string>;

/// Expects a line that begins with `part`, and no more than three lines.
void expect_common(const Judge& judge, const std::string& part) {
  const Lines lines = judge.common().lines();
  EXPECT_LE(lines.size(), 3U);
  const bool found = std::ranges::any_of(
      lines, [&](const std::string& line) { return line.starts_with(part + ": all "); });
  EXPECT_TRUE(found) << part << '\n' << fixproof::check::verdict_text(judge);
}

/// Judges a half-up multiply with another result where `wrong` holds.
Judge multiply(const std::function<bool(std::int64_t, std::int64_t)>& wrong,
               const std::function<std::int64_t(std::int64_t)>& result) {
  return judged(mul_half_up, [&](auto a, auto b) {
    const std::int64_t right = half_up(a * b);
    return word(wrong(a, b) ? result(right) : right);
  });
}

/// Judges a truncating divide with results 1 ulp too high where `wrong` holds.
Judge divide(const std::function<bool(std::int64_t, std::int64_t)>& wrong) {
  return judged(div_truncated, [&](auto a, auto b) {
    const Said right = truncated_quotient(a, b);
    return right && wrong(a, b) ? word(static_cast<std::int64_t>(*right) + 1) : right;
  });
}

std::int64_t plus_one(std::int64_t right) { return right + 1; }

TEST(CheckCommon, NothingIfNothingIsWrong) {
  EXPECT_EQ(multiply([](auto, auto) { return false; }, plus_one).common().lines(), Lines());
}

TEST(CheckCommon, AnOperand) {
  const Judge judge = multiply([](auto a, auto b) { return a == least || b == least; }, plus_one);
  expect_common(judge, "every wrong case has operand 80000000");
  // Either operand can be the one, so nothing is said of the first alone.
  EXPECT_EQ(fixproof::check::verdict_text(judge).find("every wrong case has first"),
            std::string::npos);
}

TEST(CheckCommon, TheSecondOperand) {
  const Judge judge = multiply([](auto, auto b) { return b == 65536; }, plus_one);
  expect_common(judge, "every wrong case has second operand 00010000");
}

TEST(CheckCommon, ANegativeDivisor) {
  expect_common(divide([](auto, auto b) { return b < 0; }),
                "every wrong case has a negative divisor");
}

TEST(CheckCommon, ANegativeDividend) {
  expect_common(divide([](auto a, auto) { return a < 0; }),
                "every wrong case has a negative dividend");
}

TEST(CheckCommon, ALargeDivisor) {
  const Judge judge = divide([](auto, auto b) { return std::abs(b) >= 0x1000000; });
  expect_common(judge, "every wrong case has a divisor of 01000000 or more in magnitude");
}

TEST(CheckCommon, ASmallDivisor) {
  const Judge judge = divide([](auto, auto b) { return std::abs(b) < 0x100; });
  expect_common(judge, "every wrong case has a divisor from 00000001 to 000000ff in magnitude");
  const Judge with_zero = multiply([](auto, auto b) { return std::abs(b) < 0x100; }, plus_one);
  expect_common(with_zero,
                "every wrong case has a second operand of 000000ff or less in magnitude");
}

TEST(CheckCommon, ADivisorOfAFewMagnitudes) {
  const Judge judge = divide([](auto, auto b) { return std::abs(b) >= 256 && std::abs(b) < 1024; });
  expect_common(judge, "every wrong case has a divisor from 00000100 to 000003ff in magnitude");
}

TEST(CheckCommon, EqualOperands) {
  expect_common(multiply([](auto a, auto b) { return a == b; }, plus_one),
                "every wrong case has equal operands");
}

TEST(CheckCommon, AnExactTie) {
  const Judge judge =
      multiply([](auto a, auto b) { return (a * b & 0xffff) == 0x8000 && a * b >> 47 == 0; },
               [](auto right) { return right - 1; });
  expect_common(judge, "every wrong case is an exact tie");
  expect_common(judge, "every wrong result is 1 ulp too low");
}

TEST(CheckCommon, AnOverflow) {
  const Judge judge = judged(
      mul_half_up, [](auto a, auto b) { return word(std::clamp(half_up(a * b), least, most)); });
  expect_common(judge, "every wrong case overflows");
  expect_common(judge,
                "every wrong result is 7fffffff or 80000000, by the sign of the exact result");
}

TEST(CheckCommon, ADivideByZero) {
  const Judge judge = judged(
      div_truncated, [](auto a, auto b) { return b == 0 ? word(0) : truncated_quotient(a, b); });
  expect_common(judge, "every wrong case has divisor 00000000");
  expect_common(judge, "every wrong case divides by zero");
  expect_common(judge, "every wrong result is a word in place of DE");
}

TEST(CheckCommon, ANegativeResult) {
  const Judge judge =
      judged(mul_half_up, [](auto a, auto b) { return word((a * b + 32768) / 65536); });
  expect_common(judge, "every wrong case has an exact result below 0");
  expect_common(judge, "every wrong result is 1 ulp too high");
}

TEST(CheckCommon, ALostCarry) {
  // Parts of the product are added without the carry from fraction to integer part.
  const Judge judge = judged(mul_half_up, [](auto a, auto b) {
    const std::int64_t right = half_up(a * b);
    const std::int64_t rounding = (a * b & 0xffff) >= 0x8000 ? 1 : 0;
    const bool carries = rounding == 1 && (right & 0xffff) == 0;
    return word(carries ? right - 65536 : right);
  });
  expect_common(judge,
                "every wrong result is 1.0 too low, as if a carry from the fraction were lost");
}

TEST(CheckCommon, ASignLost) {
  const Judge judge = multiply([](auto a, auto b) { return a < 0 && b > 0 && a * b <= -65536; },
                               [](auto right) { return -right; });
  expect_common(judge, "every wrong result is minus the expected one");
}

TraitCase odd_case(std::uint32_t operand, bool right) {
  TraitCase one;
  one.words = {operand, operand};
  one.expected = 5;
  one.said = right ? 5 : 4;
  return one;
}

TEST(CheckCommon, ALineStatesBothCounts) {
  CommonTraits common(fixproof::cases::variant_of(Operation::sqrt, fixproof::cases::q16_16));
  for (std::uint32_t i = 0; i < 10; ++i) common.add(odd_case(0x1001 + 2 * i, false), false);
  for (std::uint32_t i = 0; i < 30; ++i) common.add(odd_case(0x1002 + 2 * i, true), true);
  for (std::uint32_t i = 0; i < 5; ++i) common.add(odd_case(0x2003 + 2 * i, true), true);
  EXPECT_EQ(common.lines(),
            (Lines{"every wrong result is 1 ulp too low: all 10",
                   "every wrong case has an odd operand: all 10, and 5 of 35 right ones"}));
}

TEST(CheckCommon, NothingThatChanceExplains) {
  // Two odd operands prove nothing where a third of the right ones is odd: 1/9 is more than 1 %.
  CommonTraits few(fixproof::cases::variant_of(Operation::sqrt, fixproof::cases::q16_16));
  for (std::uint32_t i = 0; i < 2; ++i) few.add(odd_case(0x1001 + 2 * i, false), false);
  for (std::uint32_t i = 0; i < 30; ++i) few.add(odd_case(0x1001 + i % 3, true), true);
  EXPECT_EQ(few.lines(), Lines{"every wrong result is 1 ulp too low: all 2"});
  // A trait of all right cases tells nothing, however many there are.
  CommonTraits all(fixproof::cases::variant_of(Operation::sqrt, fixproof::cases::q16_16));
  for (std::uint32_t i = 0; i < 50; ++i) all.add(odd_case(0x1001 + 2 * i, i % 2 == 0), i % 2 == 0);
  EXPECT_EQ(all.lines(), Lines{"every wrong result is 1 ulp too low: all 25"});
}

TEST(CheckCommon, ASingleWrongCaseHasNothingInCommon) {
  CommonTraits common(fixproof::cases::variant_of(Operation::sqrt, fixproof::cases::q16_16));
  common.add(odd_case(3, false), false);
  common.add(odd_case(4, true), true);
  EXPECT_EQ(common.lines(), Lines());
}

}  // namespace

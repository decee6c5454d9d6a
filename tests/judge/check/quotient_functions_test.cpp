// Tests the judging of remainders, mul_div and hypot of three numbers. The expected words are
// worked by hand, and each subject has one planted defect.
#include <cmath>

#include "judge/check/cases.hpp"
#include "judge/check/guess_text.hpp"
#include "judge/check/judge.hpp"
#include "judge/check/verdict_text.hpp"
#include "tests/judge/check/judged.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof::check;
using fixproof::cases::format_named;
using fixproof::cases::Operation;
using fixproof::cases::variant_of;
using oracle::Rounding;
using subjects::word;

Rules quotient_rules(Operation operation, Rounding rounding = Rounding::half_up,
                     std::string_view format = "q16_16") {
  return {.variant = variant_of(operation, format_named(format)), .rounding = rounding};
}

Said said_for_line(const Rules& rules, std::string_view line) {
  const ValuedCase operands = parse_valued(line, rules.variant);
  return expected_of(rules, operands).said;
}

Said said_for_words(const Rules& rules, const std::vector<std::uint64_t>& words) {
  return expected_of(rules, words).said;
}

TEST(CheckQuotientFunctions, RemaindersAreExact) {
  for (const char* format : {"q16_16", "q20_12"}) {
    const Rules truncated = quotient_rules(Operation::fmod, Rounding::half_up, format);
    EXPECT_EQ(said_for_words(truncated, {7, 3}), 1U);
    EXPECT_EQ(said_for_words(truncated, {0xfffffff9, 3}), 0xffffffffU);
    EXPECT_EQ(said_for_words(truncated, {7, 0xfffffffd}), 1U);
    EXPECT_EQ(said_for_words(truncated, {0x80000000, 0xffffffff}), 0U);
    EXPECT_EQ(said_for_words(truncated, {7, 0}), Said());
    const Rules nearest = quotient_rules(Operation::remainder, Rounding::half_up, format);
    EXPECT_EQ(said_for_words(nearest, {5, 3}), 0xffffffffU);
    // 2 and 6 are halfway between multiples of 4: the quotient is even, 0 and 2.
    EXPECT_EQ(said_for_words(nearest, {2, 4}), 2U);
    EXPECT_EQ(said_for_words(nearest, {6, 4}), 0xfffffffeU);
    EXPECT_EQ(said_for_words(nearest, {0xfffffffa, 4}), 2U);
    EXPECT_EQ(said_for_words(nearest, {0, 0}), Said());
  }
  Rules rules = quotient_rules(Operation::fmod);
  rules.no_result = NoResult::saturate;
  EXPECT_EQ(said_for_words(rules, {0xffffffff, 0}), 0x80000000U);
  EXPECT_EQ(said_for_words(quotient_rules(Operation::fmod, Rounding::half_up, "q32_32"),
                           {0x8000000000000000U, 0x7fffffffffffffffU}),
            0xffffffffffffffffU);
}

TEST(CheckQuotientFunctions, MulDivRoundsOnceByEveryRule) {
  // 7 * 3 / -6 ulps are -3.5 ulps.
  const auto result = [](Rounding rounding) {
    return said_for_line(quotient_rules(Operation::mul_div, rounding),
                         "00000007 00000003 fffffffa");
  };
  EXPECT_EQ(result(Rounding::half_up), 0xfffffffdU);
  EXPECT_EQ(result(Rounding::half_away), 0xfffffffcU);
  EXPECT_EQ(result(Rounding::half_even), 0xfffffffcU);
  EXPECT_EQ(result(Rounding::floor), 0xfffffffcU);
  EXPECT_EQ(result(Rounding::truncate), 0xfffffffdU);
}

TEST(CheckQuotientFunctions, MulDivOverflowsAndDividesByZeroByEveryRule) {
  // lowest * lowest / 2^31 - 1 ulps is 2^31 + 1 and a bit.
  const auto overflowed = [](Overflow overflow) {
    Rules rules = quotient_rules(Operation::mul_div);
    rules.overflow = overflow;
    return said_for_line(rules, "80000000 80000000 7fffffff");
  };
  EXPECT_EQ(overflowed(Overflow::wrap), 0x80000001U);
  EXPECT_EQ(overflowed(Overflow::saturate), 0x7fffffffU);
  EXPECT_EQ(overflowed(Overflow::minimum), 0x80000000U);
  EXPECT_EQ(overflowed(Overflow::error), Said());
  // The sign is that of the product.
  const auto by_zero = [](NoResult no_result, std::string_view line) {
    Rules rules = quotient_rules(Operation::mul_div);
    rules.no_result = no_result;
    return said_for_line(rules, line);
  };
  EXPECT_EQ(by_zero(NoResult::error, "00000001 00000001 00000000"), Said());
  EXPECT_EQ(by_zero(NoResult::saturate, "ffffffff 00000001 00000000"), 0x80000000U);
  EXPECT_EQ(by_zero(NoResult::saturate, "ffffffff ffffffff 00000000"), 0x7fffffffU);
  EXPECT_EQ(by_zero(NoResult::symmetric, "00000001 ffffffff 00000000"), 0x80000001U);
  EXPECT_EQ(said_for_line(quotient_rules(Operation::mul_div, Rounding::half_up, "u0_64"),
                          "ffffffffffffffff ffffffffffffffff fffffffffffffffe"),
            0U);
}

TEST(CheckQuotientFunctions, LengthsByEveryRounding) {
  const auto result = [](std::string_view line, Rounding rounding) {
    Rules rules = quotient_rules(Operation::hypot3, rounding);
    rules.overflow = Overflow::saturate;
    return said_for_line(rules, line);
  };
  // The root of 1 + 1 + 1 is 1.7, and that of 4 + 9 + 36 is 7.
  EXPECT_EQ(result("00000001 ffffffff 00000001", Rounding::half_up), 2U);
  EXPECT_EQ(result("00000001 ffffffff 00000001", Rounding::floor), 1U);
  EXPECT_EQ(result("00000002 00000003 fffffffa", Rounding::floor), 7U);
  // 2^31 - 1, and a root that is 2^-33 above it: still the highest word.
  EXPECT_EQ(result("7fffffff 00000000 00000001", Rounding::half_up), 0x7fffffffU);
  EXPECT_EQ(result("80000000 00000000 00000000", Rounding::half_up), 0x7fffffffU);
}

using SubjectOfThree = std::function<Said(std::int64_t, std::int64_t, std::int64_t)>;

/// Judges a function of three words of 16.16 by cases of level 1.
Judge judged_of_three(const Rules& rules, const SubjectOfThree& subject) {
  CaseOptions options;
  options.cases = 20'000;
  GeneratedCases cases(rules.variant, options);
  Judge judge(rules, 3);
  JudgedCase one;
  while ((one.valued = cases.next_valued())) {
    const auto operand = [&](std::size_t i) -> std::int64_t {
      return static_cast<std::int32_t>(one.valued->words.at(i));
    };
    ++one.number;
    one.origin = cases.origin();
    one.said = subject(operand(0), operand(1), operand(2));
    judge.add(one);
  }
  return judge;
}

void expect_in(const std::string& text, std::initializer_list<std::string_view> parts) {
  for (const std::string_view part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
  }
}

std::int64_t floored(std::int64_t n, std::int64_t d) {
  const std::int64_t quotient = n / d;
  return n % d != 0 && (n < 0) != (d < 0) ? quotient - 1 : quotient;
}

TEST(CheckQuotientFunctions, AFlooredRemainderHasTheSignOfTheDivisor) {
  const Judge judge = subjects::judged(quotient_rules(Operation::fmod), [](auto a, auto b) {
    return b == 0 ? Said() : word(a - b * floored(a, b));
  });
  EXPECT_GT(judge.wrong(), 0U);
  EXPECT_EQ(judge.tally(CaseKind::no_result, false).wrong, 0U);
  expect_in(verdict_text(judge), {"divide by zero", "in range         exact, but for ",
                                  "divide by zero   says DE on all "});
}

TEST(CheckQuotientFunctions, TheWrongRemaindersHaveWhatInCommon) {
  const Judge judge = subjects::judged(quotient_rules(Operation::fmod), [](auto a, auto b) {
    return b == 0 ? Said() : word(a < 0 && b < 0 ? 1 : a % b);
  });
  expect_in(verdict_text(judge), {"every wrong case has two negative operands"});
  const Judge divisors = subjects::judged(quotient_rules(Operation::fmod), [](auto a, auto b) {
    return b == 0 ? Said() : word(b < 0 ? 0x1234567 : a % b);
  });
  expect_in(verdict_text(divisors), {"every wrong case has a negative divisor"});
}

TEST(CheckQuotientFunctions, ARemainderWhoseTiesGoAway) {
  const Judge judge = subjects::judged(quotient_rules(Operation::remainder), [](auto a, auto b) {
    if (b == 0) return Said();
    const std::int64_t away = (2 * std::abs(a) + std::abs(b)) / (2 * std::abs(b));
    return word(a - b * ((a < 0) != (b < 0) ? -away : away));
  });
  EXPECT_GT(judge.wrong(), 0U);
  EXPECT_LT(judge.wrong(), judge.cases() / 4);
}

TEST(CheckQuotientFunctions, ASoundMulDiv) {
  const Rules rules = quotient_rules(Operation::mul_div, Rounding::floor);
  const Judge judge = judged_of_three(
      rules, [](auto a, auto b, auto c) { return c == 0 ? Said() : word(floored(a * b, c)); });
  EXPECT_EQ(judge.wrong(), 0U);
  for (const CaseKind kind : {CaseKind::exact, CaseKind::tie, CaseKind::near_tie, CaseKind::between,
                              CaseKind::overflow, CaseKind::no_result}) {
    EXPECT_GT(judge.tally(kind, false).cases, judge.tally(kind, true).cases);
    EXPECT_GT(judge.tally(kind, true).cases, 0U);
  }
  expect_in(verdict_text(judge),
            {"rounding         floor on all ", "overflow         wraps on all ",
             "divide by zero   says DE on all "});
}

TEST(CheckQuotientFunctions, AMulDivThatRoundsTwice) {
  const Rules rules = quotient_rules(Operation::mul_div, Rounding::floor);
  const Judge judge = judged_of_three(rules, [](auto a, auto b, auto c) {
    return c == 0 ? Said() : word(floored((a * b >> 16) * 65536, c));
  });
  EXPECT_GT(judge.tally(CaseKind::between, false).wrong, 0U);
  EXPECT_GT(judge.tally(CaseKind::exact, false).wrong, 0U);
  expect_in(verdict_text(judge), {"but for "});
}

TEST(CheckQuotientFunctions, AMulDivThatSaturatesByTheSignOfTheProduct) {
  Rules rules = quotient_rules(Operation::mul_div, Rounding::truncate);
  rules.overflow = Overflow::saturate;
  rules.no_result = NoResult::saturate;
  const Judge judge = judged_of_three(rules, [](auto a, auto b, auto c) {
    const std::int64_t product = a * b;
    if (c == 0)
      return product == 0 ? Said(0) : word(product < 0 ? subjects::least : subjects::most);
    return word(std::clamp(product / c, subjects::least, subjects::most));
  });
  EXPECT_EQ(judge.wrong(), 0U) << verdict_text(judge);
  expect_in(verdict_text(judge),
            {"overflow         saturates to 7fffffff and 80000000 on all ",
             "divide by zero   gives 7fffffff or 80000000, by the sign of the product on all "});
}

TEST(CheckQuotientFunctions, ALengthInSinglePrecision) {
  Rules rules = quotient_rules(Operation::hypot3);
  rules.overflow = Overflow::saturate;
  const auto length = [](auto a, auto b, auto c) {
    const auto square = [](std::int64_t x) { return static_cast<long double>(x) * x; };
    return std::sqrt(square(a) + square(b) + square(c));
  };
  const auto saturated = [](long double ulps) {
    return word(std::min<std::int64_t>(std::llrint(ulps), subjects::most));
  };
  const Judge sound =
      judged_of_three(rules, [&](auto a, auto b, auto c) { return saturated(length(a, b, c)); });
  EXPECT_EQ(sound.wrong(), 0U) << verdict_text(sound);
  const Judge single = judged_of_three(rules, [&](auto a, auto b, auto c) {
    return saturated(static_cast<long double>(static_cast<float>(length(a, b, c))));
  });
  EXPECT_GT(single.tally(CaseKind::near_tie, false).wrong, 0U);
  EXPECT_GT(single.tally(CaseKind::exact, false).wrong, 0U);
  expect_in(verdict_text(single), {"mean error "});
}

}  // namespace

// Tests the judging of functions. The expected words are worked by hand.
#include <fmt/format.h>

#include "judge/check/cases.hpp"
#include "judge/check/guess_text.hpp"
#include "judge/check/judge.hpp"
#include "judge/check/verdict_text.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof::check;
using fixproof::cases::Format;
using fixproof::cases::format_named;
using fixproof::cases::Operation;
using fixproof::cases::variant_of;
using oracle::Rounding;

Rules rules_for(Operation operation, Rounding rounding = Rounding::half_up,
                std::string_view format = "q16_16") {
  return {.variant = variant_of(operation, format_named(format)),
          .rounding = rounding,
          .overflow = Overflow::saturate};
}

ValuedCase operands_of(const Rules& rules, std::string_view line) {
  return parse_valued(line, rules.variant);
}

Said expected_for(const Rules& rules, std::string_view line) {
  const ValuedCase operands = operands_of(rules, line);
  return expected_of(rules, operands).said;
}

TEST(CheckFunctions, EveryRounding) {
  // e is 178145.3 ulps, and 2^-17 half an ulp.
  EXPECT_EQ(expected_for(rules_for(Operation::exp), "00010000"), 178145U);
  EXPECT_EQ(expected_for(rules_for(Operation::exp2, Rounding::half_up), "ffef0000"), 1U);
  EXPECT_EQ(expected_for(rules_for(Operation::exp2, Rounding::half_even), "ffef0000"), 0U);
  EXPECT_EQ(expected_for(rules_for(Operation::exp2, Rounding::truncate), "ffef0000"), 0U);
  // 3/4 pi is 154415.7 ulps.
  EXPECT_EQ(expected_for(rules_for(Operation::atan2), "00010000 ffff0000"), 154416U);
  EXPECT_EQ(expected_for(rules_for(Operation::atan2, Rounding::floor), "00010000 ffff0000"),
            154415U);
  // 2^1.5 is 2.83, and 9^0.5 is 3.
  EXPECT_EQ(expected_for(rules_for(Operation::pow, Rounding::floor, "q4_4"), "20 18"), 0x2dU);
  EXPECT_EQ(expected_for(rules_for(Operation::pow, Rounding::floor), "00090000 00008000"),
            0x30000U);
}

TEST(CheckFunctions, OutOfRangeAndOutsideTheDomain) {
  Rules rules = rules_for(Operation::exp);
  EXPECT_EQ(expected_for(rules, "7fffffff"), 0x7fffffffU);
  rules.overflow = Overflow::minimum;
  EXPECT_EQ(expected_for(rules, "000c0000"), 0x80000000U);
  rules = rules_for(Operation::log);
  EXPECT_EQ(expected_for(rules, "00000000"), Said());
  rules.no_result = NoResult::minimum;
  EXPECT_EQ(expected_for(rules, "ffffffff"), 0x80000000U);
  rules = rules_for(Operation::tan_of_degrees);
  EXPECT_EQ(expected_for(rules, "005a0000"), Said());
  EXPECT_EQ(expected_for(rules, "002d0000"), 0x10000U);
}

TEST(CheckFunctions, TheVerdictNamesOperandsAndKind) {
  const Rules rules = rules_for(Operation::log);
  Judge judge(rules, 10);
  const auto add = [&](std::string_view line, Said said) {
    JudgedCase one;
    one.number = judge.cases() + 1;
    one.origin = "lattice";
    one.valued = operands_of(rules, line);
    one.said = said;
    judge.add(one);
  };
  add("00000000", 0x80000000U);
  add("00020000", 0xb173U);  // log 2 is 45426.1 ulps, b172
  const std::string text = verdict_text(judge);
  for (const char* part : {"(lattice): 00000000 (0): DE expected, 80000000 said; outside domain",
                           "00020000 (2): 0000b172 expected, 0000b173 said; exact 45426 + 0.09",
                           "gives 80000000 on"}) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}

/// Judges results of tanh in 16.16 for every operand from -2 to 2 that is a multiple of 1/64.
std::string verdict_of(std::int64_t (*subject)(std::int64_t operand, std::int64_t right)) {
  const Rules rules = rules_for(Operation::tanh);
  Judge judge(rules, 0);
  for (std::int64_t operand = -131072; operand <= 131072; operand += 1024) {
    JudgedCase one;
    one.valued = operands_of(rules, fmt::format("{:08x}", static_cast<std::uint32_t>(operand)));
    const Said right = expected_of(rules, *one.valued).said;
    const auto ulps = static_cast<std::int32_t>(right.value());
    one.said = static_cast<std::uint32_t>(subject(operand, ulps));
    judge.add(one);
  }
  return guess_text(judge);
}

TEST(CheckFunctions, RightResultsHaveOrderAndSymmetry) {
  const std::string text = verdict_of([](std::int64_t, std::int64_t right) { return right; });
  EXPECT_NE(text.find("mean error       0.2"), std::string::npos) << text;
  EXPECT_EQ(text.find("  order"), std::string::npos) << text;
  EXPECT_EQ(text.find("  symmetry"), std::string::npos) << text;
}

TEST(CheckFunctions, AStepDownIsNamed) {
  // At 1.0 the function rises by 430 ulps.
  const std::string text = verdict_of([](std::int64_t operand, std::int64_t right) {
    return operand < 65536 ? right : right - 700;
  });
  EXPECT_NE(text.find("order            1 of 256 neighbours are in the wrong order; first 0000fc00 "
                      "and 00010000"),
            std::string::npos)
      << text;
}

TEST(CheckFunctions, ABrokenSymmetryIsNamed) {
  const std::string text = verdict_of([](std::int64_t operand, std::int64_t right) {
    return operand == -1024 ? right - 1 : right;
  });
  EXPECT_NE(text.find("symmetry         broken by 1 of 128 pairs of x and -x; first x 00000400"),
            std::string::npos)
      << text;
}

}  // namespace

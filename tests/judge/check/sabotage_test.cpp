// Tests that subjects with one planted defect each are recognised: by the kinds of their wrong
// cases, and by the guessed rule.
#include "judge/check/guess_text.hpp"
#include "judge/check/verdict_text.hpp"
#include "tests/judge/check/judged.hpp"
#include "tests/support/test.hpp"

namespace {

using fixproof::cases::Operation;
using fixproof::check::CaseKind;
using fixproof::check::Judge;
using fixproof::check::NoResult;
using fixproof::check::Overflow;
using fixproof::check::Rules;
using fixproof::check::Said;
using oracle::Rounding;
using namespace subjects;
/// Expects wrong cases of only these kinds; with `negative_alone`, only for results below 0.
void expect_wrong(const Judge& judge, std::initializer_list<CaseKind> kinds,
                  bool negative_alone = false) {
  std::uint64_t sum = 0;
  for (const CaseKind kind : kinds) {
    const auto all = judge.tally(kind, false);
    EXPECT_GT(all.wrong, 0U) << fixproof::check::name_of(kind, judge.rules().variant.operation);
    if (negative_alone) {
      EXPECT_EQ(all.wrong, judge.tally(kind, true).wrong);
    }
    sum += all.wrong;
  }
  EXPECT_EQ(judge.wrong(), sum) << fixproof::check::verdict_text(judge);
}

void expect_guess(const Judge& judge, std::string_view part) {
  const std::string text = fixproof::check::guess_text(judge);
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(CheckSabotage, ASoundMultiplyHasNothingWrong) {
  const Judge judge = judged(mul_half_up, [](auto a, auto b) { return word(half_up(a * b)); });
  expect_wrong(judge, {});
  for (const CaseKind kind : {CaseKind::exact, CaseKind::tie, CaseKind::near_tie, CaseKind::between,
                              CaseKind::overflow}) {
    EXPECT_GT(judge.tally(kind, false).cases, judge.tally(kind, true).cases);
    EXPECT_GT(judge.tally(kind, true).cases, 0U);
  }
  expect_guess(judge, "rounding         half-up on all ");
  expect_guess(judge, "overflow         wraps on all ");
}

TEST(CheckSabotage, ATieThatGoesDown) {
  const Judge judge =
      judged(mul_half_up, [](auto a, auto b) { return word((a * b + 32767) >> 16); });
  expect_wrong(judge, {CaseKind::tie, CaseKind::overflow});
  expect_guess(judge, ", but for ");
  expect_guess(judge, "overflow         wraps, but for ");
}

TEST(CheckSabotage, Truncation) {
  const Judge judge = judged(mul_half_up, [](auto a, auto b) { return word(a * b / 65536); });
  expect_wrong(judge, {CaseKind::tie, CaseKind::near_tie, CaseKind::between, CaseKind::overflow});
  expect_guess(judge, "rounding         toward-zero on all ");
}

TEST(CheckSabotage, Floor) {
  const Judge judge = judged(mul_half_up, [](auto a, auto b) { return word(a * b >> 16); });
  expect_wrong(judge, {CaseKind::tie, CaseKind::near_tie, CaseKind::between, CaseKind::overflow});
  expect_guess(judge, "rounding         floor on all ");
}

TEST(CheckSabotage, NegativesRoundedByMagnitude) {
  const auto away = [](std::int64_t a, std::int64_t b) {
    return a * b < 0 ? word(-half_up(-(a * b))) : word(half_up(a * b));
  };
  const Judge judge = judged(mul_half_up, away);
  expect_wrong(judge, {CaseKind::tie, CaseKind::overflow}, true);
  expect_guess(judge, "rounding         half-away on all ");
  expect_guess(judge, "overflow         wraps on all ");
}

TEST(CheckSabotage, NegativesHalfAUnitTooHigh) {
  // Adds a half and truncates, as often done with doubles.
  const auto cut = [](std::int64_t a, std::int64_t b) { return word((a * b + 32768) / 65536); };
  const Judge judge = judged(mul_half_up, cut);
  // -1.0 becomes -1.0 plus a unit, so exact results are wrong too.
  expect_wrong(judge, {CaseKind::exact, CaseKind::near_tie, CaseKind::between, CaseKind::overflow},
               true);
  expect_guess(judge, "rounding         half-up, but for ");
  expect_guess(judge, " %, all of them negative):");
}

TEST(CheckSabotage, SaturationInsteadOfWrapping) {
  const auto clamped = [](std::int64_t a, std::int64_t b) {
    return word(std::clamp(half_up(a * b), least, most));
  };
  const Judge judge = judged(mul_half_up, clamped);
  expect_wrong(judge, {CaseKind::overflow});
  expect_guess(judge, "overflow         saturates to 7fffffff and 80000000 on all ");
  Rules saturating = mul_half_up;
  saturating.overflow = Overflow::saturate;
  expect_wrong(judged(saturating, clamped), {});
}

TEST(CheckSabotage, AnyOverflowIsNotJudgedAndSaysSo) {
  Rules any = mul_half_up;
  any.overflow = Overflow::any;
  const Judge judge = judged(any, [](auto a, auto b) {
    const std::int64_t ulps = half_up(a * b);
    return ulps > most || ulps < least ? word(4711) : word(ulps);
  });
  expect_wrong(judge, {});
  EXPECT_EQ(judge.not_judged(), judge.tally(CaseKind::overflow, false).cases);
  EXPECT_NE(fixproof::check::verdict_text(judge).find("are not judged"), std::string::npos);
}

TEST(CheckSabotage, AQuotientOfZero) {
  const Judge judge = judged(
      div_truncated, [](auto a, auto b) { return b == 0 ? word(0) : truncated_quotient(a, b); });
  expect_wrong(judge, {CaseKind::no_result});
  expect_guess(judge, "divide by zero   gives 0 on all ");
  expect_guess(judge, "rounding         toward-zero on all ");
}

TEST(CheckSabotage, ADivideThatFaultsTooOften) {
  const Judge judge = judged(div_truncated, [](auto a, auto b) {
    const Said quotient = truncated_quotient(a, b);
    return b == 0 || a * 65536 / b > most || a * 65536 / b < least ? Said() : quotient;
  });
  expect_wrong(judge, {CaseKind::overflow});
  expect_guess(judge, "overflow         says DE on all ");
}

TEST(CheckSabotage, ADivisorThatLosesItsLastBit) {
  const Judge judge = judged(div_truncated, [](auto a, auto b) {
    return truncated_quotient(a, b > 65536 && b % 1024 == 1023 ? b - 1 : b);
  });
  EXPECT_GT(judge.wrong(), 0U);
  expect_guess(judge, "rounding         toward-zero, but for ");
  expect_guess(judge, "largest error    ");
}

TEST(CheckSabotage, ARootThatGoesDown) {
  const Rules nearest{.variant = {.operation = Operation::sqrt}, .no_result = NoResult::zero};
  const Judge judge = judged(nearest, [](std::int64_t x, auto) {
    std::int64_t root = 0;
    for (std::int64_t bit = 1 << 23; x > 0 && bit != 0; bit /= 2) {
      if ((root + bit) * (root + bit) <= x * 65536) root += bit;
    }
    return word(root);
  });
  expect_wrong(judge, {CaseKind::near_tie, CaseKind::between});
  expect_guess(judge, "rounding         down on all ");
  expect_guess(judge, "negative operand gives 0 on all ");
}

TEST(CheckSabotage, NoiseIsNoRule) {
  const Judge judge = judged(mul_half_up, [](auto a, auto b) { return word(a ^ (b << 3)); });
  expect_guess(judge, "rounding         no known rule; nearest: ");
}

TEST(CheckGuess, SaysWhatCannotBeTold) {
  Judge judge(mul_half_up, 3);
  // 1.5 ulps and just below half an ulp: no negative tie, and none that separates even from up.
  judge.add({1, "here", {3, 0x8000}, 2U});
  judge.add({2, "here", {1, 0x7fff}, 0U});
  expect_guess(judge, "half-up, half-away or half-even on all 2 cases in range");
  expect_guess(judge, "no case distinguishes these");
  expect_guess(judge, "overflow         unknown: there are no cases that overflow");
}

TEST(CheckGuess, TheLargestErrorIsOfTheExactResult) {
  Judge judge(mul_half_up, 3);
  judge.add({1, "here", {3, 0x8000}, 2U});
  judge.add({2, "here", {0x10000, 0x70000}, 0x70002U});
  ASSERT_TRUE(judge.largest_error());
  EXPECT_EQ(judge.largest_error()->ulps, 2);
  EXPECT_EQ(judge.largest_error()->at.number, 2U);
}

TEST(CheckVerdict, NamesTheFirstWrongCases) {
  Judge judge(mul_half_up, 1);
  judge.add({1, "product_ties", {0xffffffff, 0x8000}, 0xffffffffU});
  judge.add({2, "product_ties", {0xffffffff, 0x8000}, Said()});
  const std::string text = fixproof::check::verdict_text(judge);
  EXPECT_NE(text.find("case 1 (product_ties): ffffffff 00008000 (-0.00002 0.5): 00000000 expected, "
                      "ffffffff said; exact -1 + 1/2 ulp, tie\n"
                      "Shown: 1 of 2 wrong results; --show N shows more.\n"),
            std::string::npos)
      << text;
}

}  // namespace

// Tests the rules for subjects, worked by hand.
#include "judge/check/rules.hpp"

#include "tests/support/test.hpp"

namespace {

using fixproof::cases::Operation;
using fixproof::check::NoResult;
using fixproof::check::Overflow;
using fixproof::check::Rules;
using fixproof::check::Said;
using oracle::Rounding;
using Operands = std::vector<std::uint64_t>;

constexpr std::uint32_t minus_one_ulp = 0xffffffff;
constexpr std::uint32_t half = 0x8000;

Said expected_word(const Rules& rules, const Operands& words) {
  const auto expected = fixproof::check::expected_of(rules, words);
  EXPECT_TRUE(expected.judged);
  return expected.said;
}

TEST(CheckRules, ProductsByEveryRounding) {
  // -1.5 ulps: -3 ulps * 0.5.
  const Operands words{0xfffffffd, half};
  const auto product = [&](Rounding rounding) {
    return expected_word({.variant = {.operation = Operation::mul}, .rounding = rounding}, words);
  };
  EXPECT_EQ(product(Rounding::half_up), 0xffffffff);
  EXPECT_EQ(product(Rounding::half_away), 0xfffffffe);
  EXPECT_EQ(product(Rounding::half_even), 0xfffffffe);
  EXPECT_EQ(product(Rounding::floor), 0xfffffffe);
  EXPECT_EQ(product(Rounding::truncate), 0xffffffff);
}

TEST(CheckRules, QuotientsByEveryRounding) {
  // -1 / 131072 is -0.5 ulp.
  const Operands words{minus_one_ulp, 0x20000};
  const auto quotient = [&](Rounding rounding) {
    return expected_word({.variant = {.operation = Operation::div}, .rounding = rounding}, words);
  };
  EXPECT_EQ(quotient(Rounding::half_up), 0U);
  EXPECT_EQ(quotient(Rounding::half_away), 0xffffffff);
  EXPECT_EQ(quotient(Rounding::half_even), 0U);
  EXPECT_EQ(quotient(Rounding::floor), 0xffffffff);
  EXPECT_EQ(quotient(Rounding::truncate), 0U);
}

TEST(CheckRules, SumsAndDifferences) {
  const Operands ends{0x7fffffff, minus_one_ulp};
  const auto result = [&](Operation operation, Overflow overflow, const Operands& words) {
    return expected_word({.variant = {.operation = operation}, .overflow = overflow}, words);
  };
  EXPECT_EQ(result(Operation::add, Overflow::saturate, ends), 0x7ffffffeU);
  EXPECT_EQ(result(Operation::sub, Overflow::saturate, ends), 0x7fffffffU);
  EXPECT_EQ(result(Operation::sub, Overflow::wrap, ends), 0x80000000U);
  EXPECT_EQ(result(Operation::sub, Overflow::error, ends), Said());
  const Operands lowest_twice{0x80000000, 0x80000000};
  EXPECT_EQ(result(Operation::add, Overflow::wrap, lowest_twice), 0U);
  EXPECT_EQ(result(Operation::add, Overflow::symmetric, lowest_twice), 0x80000001U);
  EXPECT_EQ(result(Operation::sub, Overflow::symmetric, lowest_twice), 0U);
}

TEST(CheckRules, RootsToNearestAndDown) {
  // The square root of 2 is 92681.90 ulps.
  for (const Rounding nearest : {Rounding::half_up, Rounding::half_away, Rounding::half_even}) {
    EXPECT_EQ(
        expected_word({.variant = {.operation = Operation::sqrt}, .rounding = nearest}, {0x20000}),
        92682U);
  }
  for (const Rounding down : {Rounding::floor, Rounding::truncate}) {
    EXPECT_EQ(
        expected_word({.variant = {.operation = Operation::sqrt}, .rounding = down}, {0x20000}),
        92681U);
  }
}

TEST(CheckRules, OverflowByEveryRule) {
  // 256 * 128 is 2^31 ulps, the smallest overflow. -256 * 128.5 is just below the other end.
  const Operands above{0x1000000, 0x800000};
  const Operands below{0xff000000, 0x808000};
  const auto said = [](Overflow overflow, const Operands& words) {
    return expected_word({.variant = {.operation = Operation::mul}, .overflow = overflow}, words);
  };
  EXPECT_EQ(said(Overflow::wrap, above), 0x80000000);
  EXPECT_EQ(said(Overflow::wrap, below), 0x7f800000U);
  EXPECT_EQ(said(Overflow::saturate, above), 0x7fffffffU);
  EXPECT_EQ(said(Overflow::saturate, below), 0x80000000);
  EXPECT_EQ(said(Overflow::symmetric, above), 0x7fffffffU);
  EXPECT_EQ(said(Overflow::symmetric, below), 0x80000001);
  EXPECT_EQ(said(Overflow::maximum, below), 0x7fffffffU);
  EXPECT_EQ(said(Overflow::minimum, above), 0x80000000);
  EXPECT_EQ(said(Overflow::error, above), std::nullopt);
  EXPECT_FALSE(fixproof::check::expected_of({.overflow = Overflow::any}, above).judged);
}

TEST(CheckRules, TheLastResultThatFits) {
  const Rules rules{.variant = {.operation = Operation::mul}, .overflow = Overflow::error};
  // 256 * -128 is -2^31 ulps.
  EXPECT_EQ(expected_word(rules, {0x1000000, 0xff800000}), 0x80000000);
  EXPECT_EQ(expected_word(rules, {0x7fffffff, 0x10000}), 0x7fffffffU);
}

TEST(CheckRules, ZeroDivisorsByEveryRule) {
  const Operands positive{0x10000, 0};
  const Operands negative{0xffff0000, 0};
  const auto said = [](NoResult rule, const Operands& words) {
    return expected_word({.variant = {.operation = Operation::div}, .no_result = rule}, words);
  };
  EXPECT_EQ(said(NoResult::error, positive), std::nullopt);
  EXPECT_EQ(said(NoResult::saturate, positive), 0x7fffffffU);
  EXPECT_EQ(said(NoResult::saturate, negative), 0x80000000);
  EXPECT_EQ(said(NoResult::symmetric, negative), 0x80000001);
  EXPECT_EQ(said(NoResult::maximum, negative), 0x7fffffffU);
  EXPECT_EQ(said(NoResult::minimum, positive), 0x80000000);
  EXPECT_EQ(said(NoResult::zero, negative), 0U);
}

TEST(CheckRules, ZeroByZeroMayBeZeroWhereTheSignDecides) {
  const Operands words{0, 0};
  const auto keeps = [&](NoResult rule, Said said) {
    return fixproof::check::keeps(
        Rules{.variant = {.operation = Operation::div}, .no_result = rule}, words, said);
  };
  EXPECT_TRUE(keeps(NoResult::saturate, 0U));
  EXPECT_TRUE(keeps(NoResult::saturate, 0x7fffffffU));
  EXPECT_FALSE(keeps(NoResult::saturate, 0x80000000));
  EXPECT_TRUE(keeps(NoResult::symmetric, 0U));
  EXPECT_FALSE(keeps(NoResult::maximum, 0U));
  EXPECT_FALSE(keeps(NoResult::error, 0U));
}

TEST(CheckRules, RootsOfNegativeNumbers) {
  const auto said = [](NoResult rule, Rounding rounding, std::uint32_t word) {
    return expected_word(
        {.variant = {.operation = Operation::sqrt}, .rounding = rounding, .no_result = rule},
        {word});
  };
  EXPECT_EQ(said(NoResult::zero, Rounding::half_up, minus_one_ulp), 0U);
  EXPECT_EQ(said(NoResult::error, Rounding::half_up, minus_one_ulp), std::nullopt);
  EXPECT_EQ(said(NoResult::mirror, Rounding::half_up, 0xfffe0000), 0x100000000 - 92682U);
  EXPECT_EQ(said(NoResult::mirror, Rounding::truncate, 0xfffe0000), 0x100000000 - 92681U);
  EXPECT_EQ(said(NoResult::mirror, Rounding::floor, 0xfffe0000), 0x100000000 - 92682U);
  // -4.0 has an exact root.
  EXPECT_EQ(said(NoResult::mirror, Rounding::floor, 0xfffc0000), 0xfffe0000);
  // 2^23.5 is 11863283.20.
  EXPECT_EQ(said(NoResult::mirror, Rounding::half_up, 0x80000000), 0x100000000 - 11863283U);
}

TEST(CheckRules, AnythingIsAcceptedWhereAskedFor) {
  const Rules rules{.variant = {.operation = Operation::div},
                    .overflow = Overflow::any,
                    .no_result = NoResult::any};
  for (const Said said : {Said(), Said(7U), Said(0x80000000)}) {
    EXPECT_TRUE(fixproof::check::keeps(rules, Operands{0x10000, 0}, said));
    EXPECT_TRUE(fixproof::check::keeps(rules, Operands{0x7fffffff, 1}, said));
    EXPECT_FALSE(fixproof::check::keeps(rules, Operands{0x10000, 0x10000}, said));
  }
}

TEST(CheckRules, NamesAreDifferent) {
  std::vector<std::string_view> names;
  for (const auto rule : fixproof::check::roundings())
    names.push_back(fixproof::check::name_of(rule));
  EXPECT_EQ(names, (std::vector<std::string_view>{"half-up", "half-away", "half-even", "floor",
                                                  "toward-zero", "ceiling"}));
  names.clear();
  for (const auto rule : fixproof::check::overflow_rules())
    names.push_back(fixproof::check::name_of(rule));
  EXPECT_EQ(names, (std::vector<std::string_view>{"wrap", "saturate", "symmetric", "maximum",
                                                  "minimum", "de"}));
  EXPECT_EQ(fixproof::check::no_result_rules(Operation::mul).size(), 0U);
}

}  // namespace

// Tests the rules, the places of exact results and the verdicts in formats other than 16.16. The
// expected words are worked by hand or by 128-bit arithmetic.
#include "judge/check/exact_place.hpp"
#include "judge/check/guess_text.hpp"
#include "judge/check/verdict_text.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof::check;
using fixproof::cases::Format;
using fixproof::cases::format_named;
using fixproof::cases::Operation;
using fixproof::cases::variant_of;
using oracle::Rounding;
using Pair = std::array<std::uint64_t, 2>;

Said expected(const std::string& format, Rules rules, const Pair& words) {
  rules.variant.format = format_named(format);
  return expected_of(rules, words).said;
}

TEST(CheckFormats, LimitsOfWords) {
  const Format q1_15 = format_named("q1_15");
  EXPECT_EQ(highest(q1_15), 0x7fffU);
  EXPECT_EQ(lowest(q1_15), 0x8000U);
  EXPECT_EQ(minus_highest(q1_15), 0x8001U);
  EXPECT_EQ(whole_one(q1_15), std::nullopt);
  const Format u8_8 = format_named("u8_8");
  EXPECT_EQ(highest(u8_8), 0xffffU);
  EXPECT_EQ(lowest(u8_8), 0U);
  EXPECT_EQ(whole_one(u8_8), 0x100U);
  EXPECT_FALSE(is_negative(0xffff, u8_8));
  const Format q32_32 = format_named("q32_32");
  EXPECT_EQ(lowest(q32_32), 0x8000000000000000U);
  EXPECT_EQ(magnitude(lowest(q32_32), q32_32), 0x8000000000000000U);
  EXPECT_EQ(highest(format_named("u0_64")), ~std::uint64_t{0});
  EXPECT_EQ(whole_one(format_named("u0_64")), std::nullopt);
}

TEST(CheckFormats, WordsAsText) {
  EXPECT_EQ(hex_text(0x1f, format_named("u8_8")), "001f");
  EXPECT_EQ(hex_text(1, format_named("q32_32")), "0000000000000001");
  EXPECT_EQ(decimal_text(0xffff, format_named("q8_8")), "-0.00390625");
  EXPECT_EQ(decimal_text(0xffff, format_named("u8_8")), "255.99609375");
  EXPECT_EQ(decimal_text(0x8000, format_named("q1_15")), "-1");
  EXPECT_EQ(decimal_text(0x80000001, format_named("q16_16")), "-32767.99998");
  EXPECT_EQ(decimal_text(0xfffffff6, format_named("q32_0")), "-10");
  EXPECT_EQ(decimal_text(~std::uint64_t{0}, format_named("u64_0")), "18446744073709551615");
}

TEST(CheckFormats, ProductsOf16Bits) {
  const Rules rules{.variant = {.operation = Operation::mul}, .overflow = Overflow::saturate};
  // -1 * -1 in q1_15 is 1.0, which does not fit.
  EXPECT_EQ(expected("q1_15", rules, {0x8000, 0x8000}), 0x7fffU);
  EXPECT_EQ(expected("q1_15", {.variant = {.operation = Operation::mul}}, {0x8000, 0x8000}),
            0x8000U);
  // 3 * 2^14 / 2^15 is 1.5 ulps, and -3 * 2^14 / 2^15 is -1.5.
  EXPECT_EQ(expected("q1_15", rules, {3, 0x4000}), 2U);
  EXPECT_EQ(expected("q1_15", rules, {0xfffd, 0x4000}), 0xffffU);
  // 255.99609375^2 is 65534.00, far above the range; the low 16 bits of 65535^2 / 256 =
  // 16776704.004.
  EXPECT_EQ(expected("u8_8", rules, {0xffff, 0xffff}), 0xffffU);
  EXPECT_EQ(expected("u8_8", {.variant = {.operation = Operation::mul}}, {0xffff, 0xffff}),
            0xfe00U);
}

TEST(CheckFormats, ProductsOf64Bits) {
  const Rules wrap{.variant = {.operation = Operation::mul}, .rounding = Rounding::floor};
  // 2^63 * 2^63 / 2^32 is 2^94: a multiple of 2^64.
  EXPECT_EQ(expected("q32_32", wrap, {lowest(format_named("q32_32")), 0x8000000000000000U}), 0U);
  // 1.5 * 2.25 is 3.375.
  EXPECT_EQ(expected("q32_32", wrap, {0x180000000, 0x240000000}), 0x360000000U);
  // (2^64 - 1)^2 in u64_0 is 1 modulo 2^64, and in u0_64 it is 2^64 - 2 + 2^-64 ulps.
  const Pair ends{~std::uint64_t{0}, ~std::uint64_t{0}};
  EXPECT_EQ(expected("u64_0", wrap, ends), 1U);
  EXPECT_EQ(expected("u0_64", wrap, ends), ~std::uint64_t{0} - 1);
  EXPECT_EQ(exact_text(variant_of(Operation::mul, format_named("u0_64")), ends),
            "18446744073709551614 + 1/18446744073709551616");
}

TEST(CheckFormats, AnUnsignedDifferenceBelowZeroOverflows) {
  const Rules sub{.variant = {.operation = Operation::sub}};
  EXPECT_EQ(expected("u8_8", sub, {1, 2}), 0xffffU);
  const auto with = [](Overflow overflow) {
    return Rules{.variant = {.operation = Operation::sub}, .overflow = overflow};
  };
  EXPECT_EQ(expected("u8_8", with(Overflow::saturate), {1, 2}), 0U);
  EXPECT_EQ(expected("u8_8", with(Overflow::maximum), {1, 2}), 0xffffU);
  EXPECT_EQ(expected("u8_8", with(Overflow::error), {1, 2}), Said());
  EXPECT_EQ(expected("q8_8", with(Overflow::saturate), {1, 2}), 0xffffU);
}

TEST(CheckFormats, QuotientsAndZeroDivisors) {
  const Rules down{.variant = {.operation = Operation::div},
                   .rounding = Rounding::floor,
                   .no_result = NoResult::saturate};
  // 1 / 3 in q2_30 is 2^30 / 3 = 357913941.33 ulps.
  EXPECT_EQ(expected("q2_30", down, {0x10000000, 0x30000000}), 357913941U);
  EXPECT_EQ(expected("u8_8", down, {0x100, 0}), 0xffffU);
  EXPECT_EQ(expected("q2_30", down, {0x80000000, 0}), 0x80000000U);
  EXPECT_EQ(no_result_rules(variant_of(Operation::sqrt, format_named("u8_8"))).size(), 0U);
}

TEST(CheckFormats, Roots) {
  const Rules nearest{.variant = {.operation = Operation::sqrt}, .no_result = NoResult::mirror};
  // sqrt(2) in q32_32 is 6074000999.95 ulps.
  EXPECT_EQ(expected("q32_32", nearest, {0x200000000, 0}), 6074001000U);
  EXPECT_EQ(expected("q32_32", nearest, {0 - std::uint64_t{0x200000000}, 0}),
            0 - std::uint64_t{6074001000});
  // The root of 0.484375 in q0_8 is 0.696 = 178.2 ulps, and 127 is the highest word.
  Rules down{.variant = {.operation = Operation::sqrt}, .overflow = Overflow::saturate};
  EXPECT_EQ(expected("q0_8", down, {124, 0}), 0x7fU);
  EXPECT_TRUE(can_overflow(variant_of(Operation::sqrt, format_named("q0_8"))));
  EXPECT_TRUE(can_overflow(variant_of(Operation::sqrt, format_named("q1_7"))));
  EXPECT_FALSE(can_overflow(variant_of(Operation::sqrt, format_named("q4_4"))));
}

TEST(CheckFormats, ATieIsToldFromItsNeighboursIn64Bits) {
  const Format q1_63 = format_named("q1_63");
  const auto place = [&](std::uint64_t a, std::uint64_t b) {
    return exact_place(variant_of(Operation::mul, q1_63), Pair{a, b});
  };
  constexpr std::uint64_t half = std::uint64_t{1} << 62U;
  EXPECT_EQ(place(1, half).kind(false), CaseKind::tie);
  // 2^-63 below and above a tie: the fraction is a half in double precision.
  EXPECT_EQ(place(1, half - 1).kind(false), CaseKind::near_tie);
  EXPECT_LT(place(1, half - 1).fraction, 0.5);
  EXPECT_EQ(place(1, half + 1).kind(false), CaseKind::near_tie);
  EXPECT_GE(place(1, half + 1).fraction, 0.5);
  EXPECT_EQ(place(2, half).kind(false), CaseKind::exact);
}

/// Judges a function on random words of the format.
template <class Raw>
Judge judged_in(Rules rules, const std::string& format,
                const std::function<Said(Raw, Raw)>& subject, std::uint64_t cases = 20'000) {
  rules.variant.format = format_named(format);
  Judge judge(rules, 3);
  std::mt19937_64 random(1994);
  JudgedCase one{.number = 0, .origin = "random", .words = {}, .said = {}};
  for (; one.number < cases;) {
    ++one.number;
    for (std::uint64_t& word : one.words) {
      word = random() & fixproof::cases::all_ones(rules.variant.format);
      word >>= random() % static_cast<std::uint64_t>(rules.variant.format.word_bits);
    }
    one.said = subject(static_cast<Raw>(one.words[0]), static_cast<Raw>(one.words[1]));
    judge.add(one);
  }
  return judge;
}

void expect_text(const Judge& judge, const std::string& part) {
  const std::string text = verdict_text(judge);
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

std::uint32_t word_of(std::int64_t ulps) { return static_cast<std::uint32_t>(ulps); }

const Rules mul_half_up{.variant = {.operation = Operation::mul}};

TEST(CheckFormats, AShiftThatDoesNotRound) {
  const Judge judge = judged_in<std::int32_t>(mul_half_up, "q2_30", [](auto a, auto b) {
    return Said(word_of(std::int64_t{a} * b >> 30));
  });
  expect_text(judge, "every wrong result is 1 ulp too low: all ");
  expect_text(judge, "rounding         floor on all ");
  expect_text(judge, "looks like       (int64_t)a * b >> 30, on all ");
}

TEST(CheckFormats, ASoundUnsignedMultiply) {
  const Judge judge = judged_in<std::uint16_t>(mul_half_up, "u8_8", [](auto a, auto b) {
    return Said(((std::uint32_t{a} * b + 128) >> 8U) & 0xffffU);
  });
  EXPECT_EQ(judge.wrong(), 0U) << verdict_text(judge);
  expect_text(judge, "rounding         half-up or half-away on all ");
  expect_text(judge, "overflow         wraps on all ");
}

TEST(CheckFormats, ADifferenceThatSaturates) {
  const Judge judge = judged_in<std::uint16_t>(
      {.variant = {.operation = Operation::sub}}, "u8_8",
      [](auto a, auto b) { return Said(a < b ? 0U : static_cast<std::uint32_t>(a - b)); });
  EXPECT_EQ(judge.tally(CaseKind::overflow, true).wrong, judge.wrong());
  expect_text(judge, "saturates to ffff and 0000 or gives 0000 whatever the sign on all ");
  expect_text(judge, "every wrong result is 0000: all ");
}

TEST(CheckFormats, AMultiplyThatLosesTheHighHalf) {
  const Judge judge = judged_in<std::int64_t>(mul_half_up, "q32_32", [](auto a, auto b) {
    const std::uint64_t low = static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b);
    return Said(static_cast<std::uint64_t>(static_cast<std::int64_t>(low) >> 32));
  });
  EXPECT_GT(judge.wrong(), 0U);
  expect_text(judge, "a * b >> 32 in 64 bits, which drops the high half of the product, on all ");
}

TEST(CheckFormats, TraitsNameWordsOfTheFormat) {
  const Judge judge = judged_in<std::int16_t>(
      {.variant = {.operation = Operation::mul}, .overflow = Overflow::saturate}, "q1_15",
      [](auto a, auto b) -> Said {
        const int product = (int{a} * b + 0x4000) >> 15;
        return static_cast<std::uint16_t>(product);
      },
      400'000);
  // The only product of two words that overflows in q1_15 is -1 * -1.
  EXPECT_EQ(judge.wrong(), judge.tally(CaseKind::overflow, false).cases);
  Judge ends(judge.rules(), 3);
  for (std::uint64_t i = 1; i <= 100; ++i) {
    ends.add({i, "lattice", {0x8000, i}, Said(7U)});
    ends.add({i, "lattice", {i, i}, expected_of(ends.rules(), Pair{i, i}).said});
  }
  expect_text(ends, "every wrong case has first operand 8000: all 100");
}

TEST(CheckFormats, TheLargestErrorOf64Bits) {
  Judge judge({.variant = variant_of(Operation::add, format_named("q32_32"))}, 3);
  judge.add({1, "here", {lowest(format_named("q32_32")), 1}, 0x7fffffffffffffffU});
  ASSERT_TRUE(judge.largest_error());
  EXPECT_EQ(judge.largest_error()->ulps, std::ldexp(1.0, 64));
}

}  // namespace

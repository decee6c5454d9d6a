// Tests the judging of conversions. The expected words are worked by hand.
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <functional>

#include "judge/check/cases.hpp"
#include "judge/check/guess_text.hpp"
#include "judge/check/judge.hpp"
#include "judge/check/verdict_text.hpp"
#include "support/hex.hpp"
#include "support/usage_error.hpp"
#include "tests/support/command.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"
#include "verify/cases/streams.hpp"
#include "verify/cases/words.hpp"

namespace {

using namespace fixproof::check;
using fixproof::cases::Format;
using fixproof::cases::format_named;
using fixproof::cases::Operation;
using fixproof::cases::Stream;
using fixproof::cases::Variant;
using fixproof::cases::variant_of;
using fixproof::support::UsageError;
using oracle::Rounding;

Variant variant(Operation operation, std::string_view format = "q16_16",
                std::string_view from = "q16_16") {
  const Format results = format_named(format);
  return variant_of(operation, operation == Operation::convert ? format_named(from) : results,
                    results);
}

Rules rules_for(const Variant& of, Rounding rounding) {
  return {.variant = of, .rounding = rounding};
}

Said expected(const Rules& rules, std::string_view line) {
  const ValuedCase operand = parse_valued(line, rules.variant);
  return expected_of(rules, operand).said;
}

/// The words of half-up, half-away, half-even, floor, toward-zero and ceiling.
std::vector<Said> by_every_rule(const Variant& of, std::string_view line) {
  std::vector<Said> words;
  for (const Rounding rule : roundings()) words.push_back(expected(rules_for(of, rule), line));
  return words;
}

TEST(CheckConversions, TiesOfDoubles) {
  const Variant v = variant(Operation::from_binary64);
  EXPECT_EQ(by_every_rule(v, "3ff8000000000000"), std::vector<Said>(6, 0x18000));          // 1.5
  EXPECT_EQ(by_every_rule(v, "3ee0000000000000"), (std::vector<Said>{1, 1, 0, 0, 0, 1}));  // 2^-17
  EXPECT_EQ(by_every_rule(v, "bee0000000000000"),
            (std::vector<Said>{0, 0xffffffff, 0, 0xffffffff, 0, 0}));
  EXPECT_EQ(by_every_rule(v, "3ee0000000000001"), (std::vector<Said>{1, 1, 1, 0, 0, 1}));
  EXPECT_EQ(by_every_rule(v, "8000000000000000"), std::vector<Said>(6, 0));  // -0
  EXPECT_EQ(by_every_rule(v, "0000000000000001"),
            (std::vector<Said>{0, 0, 0, 0, 0, 1}));  // 2^-1074
  EXPECT_EQ(by_every_rule(v, "8000000000000001"), (std::vector<Said>{0, 0, 0, 0xffffffff, 0, 0}));
}

TEST(CheckConversions, DoublesOutOfRange) {
  Rules rules = rules_for(variant(Operation::from_binary64, "q1_63"), Rounding::half_even);
  EXPECT_EQ(expected(rules, "3ff0000000000000"), 0x8000000000000000U);  // 1.0 wraps
  EXPECT_EQ(expected(rules, "bff0000000000000"), 0x8000000000000000U);  // -1.0 fits
  rules.overflow = Overflow::saturate;
  EXPECT_EQ(expected(rules, "3ff0000000000000"), 0x7fffffffffffffffU);
  EXPECT_EQ(expected(rules, "ffefffffffffffff"), 0x8000000000000000U);  // the lowest double
}

TEST(CheckConversions, DoublesThatAreNotFinite) {
  Rules rules = rules_for(variant(Operation::from_binary64, "u8_8"), Rounding::floor);
  const std::string_view infinity = "7ff0000000000000";
  const std::string_view minus_infinity = "fff0000000000000";
  const std::string_view nan = "7ff8000000000000";
  EXPECT_EQ(expected(rules, infinity), Said());
  EXPECT_EQ(expected(rules, nan), Said());
  rules.no_result = NoResult::saturate;
  EXPECT_EQ(expected(rules, infinity), 0xffffU);
  EXPECT_EQ(expected(rules, minus_infinity), 0U);
  const Variant& v = rules.variant;
  EXPECT_TRUE(keeps(rules, parse_valued(nan, v), 0));
  EXPECT_FALSE(keeps(rules, parse_valued(infinity, v), 0));
}

TEST(CheckConversions, WordsOfOtherFormats) {
  const Variant narrow = variant(Operation::convert, "q8_8", "q16_16");
  EXPECT_EQ(by_every_rule(narrow, "00000080"), (std::vector<Said>{1, 1, 0, 0, 0, 1}));
  EXPECT_EQ(by_every_rule(narrow, "ffffff80"), (std::vector<Said>{0, 0xffff, 0, 0xffff, 0, 0}));
  Rules rules = rules_for(narrow, Rounding::half_up);
  EXPECT_EQ(expected(rules, "00800000"), 0x8000U);  // 128.0 wraps
  EXPECT_EQ(expected(rules, "007fffff"), 0x8000U);  // and so does what rounds to it
  rules.overflow = Overflow::saturate;
  EXPECT_EQ(expected(rules, "007fffff"), 0x7fffU);
  rules = rules_for(variant(Operation::convert, "u32_32", "q8_8"), Rounding::floor);
  EXPECT_EQ(expected(rules, "0180"), 0x180000000U);
  EXPECT_EQ(expected(rules, "ff00"), 0xffffffff00000000U);  // -1.0 wraps
  rules.overflow = Overflow::saturate;
  EXPECT_EQ(expected(rules, "ff00"), 0U);
}

TEST(CheckConversions, DecimalTexts) {
  const Variant v = variant(Operation::from_decimal);
  EXPECT_EQ(by_every_rule(v, "-1.5"), std::vector<Said>(6, 0xfffe8000));
  EXPECT_EQ(by_every_rule(v, "0.00000762939453125"), (std::vector<Said>{1, 1, 0, 0, 0, 1}));
  EXPECT_EQ(by_every_rule(v, "0.00000762939453125000000000000000000001"),
            (std::vector<Said>{1, 1, 1, 0, 0, 1}));
  EXPECT_EQ(by_every_rule(v, "0.0000076293945312499999999999999999999999"),
            (std::vector<Said>{0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(by_every_rule(v, "1e-5"), (std::vector<Said>{1, 1, 1, 0, 0, 1}));  // 0.65536 ulp
  EXPECT_EQ(by_every_rule(v, "15E+1"), std::vector<Said>(6, 0x960000));
  EXPECT_EQ(by_every_rule(v, "-.5"), std::vector<Said>(6, 0xffff8000));
}

TEST(CheckConversions, LinesThatAreNoOperands) {
  const auto refused = [](const Variant& v, std::string_view line) {
    EXPECT_THROW(static_cast<void>(parse_valued(line, v)), UsageError) << line;
  };
  for (const char* line : {"3ff800000000000", "3FF8000000000000", "1.5", ""}) {
    refused(variant(Operation::from_binary64), line);
  }
  refused(variant(Operation::convert, "q16_16", "q8_8"), "00010000");
  for (const char* line :
       {"", "e5", "1e", "1e+-5", "1e1001", "1e5000000000", "1,5", "0x1", "nan"}) {
    refused(variant(Operation::from_decimal), line);
  }
  refused(variant(Operation::from_decimal), std::string(1001, '1'));
}

// 1 ulp is 0.0000152587890625.
TEST(CheckConversions, TextsOfAWord) {
  const Format q16_16 = format_named("q16_16");
  EXPECT_EQ(parse_decimal_result("0.00002", q16_16), 1U);
  EXPECT_EQ(parse_decimal_result("0.00003", q16_16), 2U);
  EXPECT_EQ(parse_decimal_result("0.000022888183593750", q16_16), 2U);  // 1.5 ulp: to even
  EXPECT_EQ(parse_decimal_result("-3.2768e4", q16_16), 0x80000000U);
  EXPECT_EQ(parse_decimal_result("32768", q16_16), Said());
  EXPECT_EQ(parse_decimal_result("65535.99998", q16_16), Said());  // not the word of -0.00002
  EXPECT_THROW(static_cast<void>(parse_decimal_result("DE", q16_16)), UsageError);
}

/// Calls `look` with the place of every case of a stream.
void each_place(const Variant& v, Stream stream,
                const std::function<void(const ExactPlace&, const ValuedCase&)>& look) {
  constexpr std::size_t count = 2000;
  const std::size_t each = fixproof::cases::words_in(v);
  std::vector<std::uint32_t> words(count * each);
  fixproof::cases::make_cases(stream, v, 1994, 0, words);
  for (std::size_t i = 0; i < count; ++i) {
    std::string line;
    fixproof::cases::append_operands(line, v, std::span(words).subspan(i * each, each));
    const ValuedCase operand = parse_valued(line, v);
    look(exact_place(v, operand), operand);
  }
}

TEST(CheckConversions, StreamsOfTiesHaveNothingElse) {
  for (const Variant& v :
       {variant(Operation::from_binary64), variant(Operation::from_binary64, "q1_7"),
        variant(Operation::from_binary64, "u0_64"), variant(Operation::convert, "q8_8"),
        variant(Operation::convert, "u0_8", "q1_63"), variant(Operation::from_decimal),
        variant(Operation::from_decimal, "u0_64"), variant(Operation::from_decimal, "q8_0")}) {
    each_place(v, Stream::value_ties, [](const ExactPlace& place, const ValuedCase& operand) {
      EXPECT_TRUE(place.tie) << operand.text;
    });
    std::size_t above = 0;
    each_place(v, Stream::near_value_ties, [&](const ExactPlace& place, const ValuedCase& operand) {
      EXPECT_FALSE(place.tie || place.exact) << operand.text;
      if (place.fraction >= 0.5) ++above;
    });
    EXPECT_GT(above, 800U);
    EXPECT_LT(above, 1200U);
  }
}

TEST(CheckConversions, AChangeOfFormatThatDropsNothingHasNoTies) {
  CaseOptions options;
  GeneratedCases cases(variant(Operation::convert, "q16_16", "q8_8"), options);
  EXPECT_EQ(cases.count_of("value_ties"), 0U);
  EXPECT_GT(cases.count_of("lattice"), 0U);
  while (const auto operand = cases.next_valued()) {
    ASSERT_TRUE(exact_place(variant(Operation::convert, "q16_16", "q8_8"), *operand).exact);
  }
}

TEST(CheckConversions, EachExponentOfADoubleIsInTheLattice) {
  CaseOptions options;
  GeneratedCases cases(variant(Operation::from_binary64), options);
  std::vector<int> of_exponent(2048);
  for (std::uint64_t i = 0; i < cases.count_of("lattice"); ++i) {
    const auto operand = cases.next_valued();
    ASSERT_TRUE(operand);
    const std::uint64_t bits = fixproof::support::parse_long_hex(operand->text, 16);
    ++of_exponent.at(bits >> 52U & 2047U);
  }
  EXPECT_EQ(of_exponent, std::vector<int>(2048, 12));
}

TEST(CheckConversions, DecimalsEndWithTheirLastDigit) {
  using fixproof::cases::decimal_of;
  EXPECT_EQ(decimal_of(3, {.fraction_bits = 1}), "1.5");
  EXPECT_EQ(decimal_of(3, {.fraction_bits = 0}), "3");
  EXPECT_EQ(decimal_of(3, {.fraction_bits = 0}, true), "3.5");
  EXPECT_EQ(decimal_of(1, {.fraction_bits = 16}), "0.0000152587890625");
  EXPECT_EQ(decimal_of(0, {.fraction_bits = 16}, true), "0.00000762939453125");
  EXPECT_EQ(decimal_of(~std::uint64_t{0}, {.fraction_bits = 0}), "18446744073709551615");
  // 2^-65
  EXPECT_EQ(decimal_of(0, {.fraction_bits = 64}, true),
            "0.00000000000000000002710505431213761085018632002174854278564453125");
}

/// Judges a conversion of doubles to 16.16, which saturates and gives 0 for NaN.
Judge judged_doubles(const std::function<double(double)>& ulps_of) {
  Rules rules = rules_for(variant(Operation::from_binary64), Rounding::half_up);
  rules.overflow = Overflow::saturate;
  rules.no_result = NoResult::saturate;
  GeneratedCases cases(variant(Operation::from_binary64), CaseOptions{});
  Judge judge(rules, 3);
  JudgedCase one;
  one.origin = "stream";
  while ((one.valued = cases.next_valued())) {
    ++one.number;
    const auto x = std::bit_cast<double>(fixproof::support::parse_long_hex(one.valued->text, 16));
    const double ulps = std::isnan(x) ? 0 : std::fmin(std::fmax(ulps_of(x), -0x1p31), 0x1p31 - 1);
    one.said = static_cast<std::uint32_t>(static_cast<std::int32_t>(ulps));
    judge.add(one);
  }
  return judge;
}

TEST(CheckConversions, AWrongResultIsShownWithItsSource) {
  struct Case {
    const char* from;
    const char* line;
    const char* shown;
  };
  for (const Case& c : {Case{"q6_2", "f3", "f3 (-3.25)"},
                        {"q30_2", "fffffff3", "fffffff3 (-3.25)"},
                        {"q1_7", "81", "81 (-0.9921875)"},
                        {"q16_16", "00018000", "00018000 (1.5)"},
                        {"q32_32", "fffffffffffffff0", "fffffffffffffff0 (-0.0000000037)"}}) {
    const Variant v = variant(Operation::convert, "q8_0", c.from);
    Judge judge(rules_for(v, Rounding::half_even), 3);
    JudgedCase one;
    one.origin = "here";
    one.valued = parse_valued(c.line, v);
    one.said = 0x3c;
    judge.add(one);
    EXPECT_NE(verdict_text(judge).find(c.shown), std::string::npos) << verdict_text(judge);
    const std::string guess = guess_text(judge);
    EXPECT_NE(guess.find("no known rule: 1 of 1 cases in range differ from each"),
              std::string::npos)
        << guess;
    EXPECT_NE(guess.find(c.shown), std::string::npos) << guess;
  }
}

TEST(CheckConversions, ASoundOneHasNothingWrong) {
  const Judge judge = judged_doubles([](double x) { return std::floor(x * 65536 + 0.5); });
  // The sum rounds, so doubles next to half a unit go wrong.
  EXPECT_GT(judge.wrong(), 0U);
  const Judge sound = judged_doubles([](double x) {
    const double ulps = x * 65536;
    return ulps - std::floor(ulps) < 0.5 ? std::floor(ulps) : std::ceil(ulps);
  });
  EXPECT_EQ(sound.wrong(), 0U) << verdict_text(sound);
}

TEST(CheckConversions, IdiomsOfDoubles) {
  const auto expect_guess = [](const Judge& judge, std::string_view part) {
    const std::string text = verdict_text(judge);
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  const Judge half = judged_doubles([](double x) { return std::trunc(x * 65536 + 0.5); });
  expect_guess(half, "looks like       (int)(x * 65536 + 0.5), which cuts negative results");
  const Judge single = judged_doubles(
      [](double x) { return std::trunc(static_cast<double>(static_cast<float>(x)) * 65536); });
  expect_guess(single, "looks like       (int)((float)x * 65536), which has 24 bits");
  const Judge cut = judged_doubles([](double x) { return std::trunc(x * 65536); });
  expect_guess(cut, "rounding         toward-zero on all ");
  expect_guess(cut, "overflow         saturates to 7fffffff and 80000000 on all ");
  expect_guess(cut,
               "not finite       gives 7fffffff or 80000000, by the sign of the infinity on all ");
}

TEST(CheckConversions, AsAUserRunsThem) {
  const ScratchFolder folder;
  const auto check = [&](std::string_view options, std::string_view cases,
                         std::string_view results) {
    return command::fixproof(
        fmt::format("check {} --from {}", options, folder.write("cases", cases)), results);
  };
  auto run = check("from_binary64 --rounding floor", "# pi\n400921fb54442d18\n", "00032440\n");
  EXPECT_EQ(run.status, 1) << run.err;
  command::expect_contains(
      run.out, "400921fb54442d18 (3.141592653589793): 0003243f expected, 00032440 said");
  run = check("convert --to q8_8 --rounding half-even", "00000180\n", "0002\n");
  EXPECT_EQ(run.status, 0) << run.out;
  command::expect_contains(run.out, "convert q16_16 to q8_8: half-even, overflow wrap");
  run = check("from_decimal --format q2_30 --rounding half-up", "0.1\n", "06666666\n");
  EXPECT_EQ(run.status, 0) << run.out;
  run = check("to_decimal --format q8_8", "0180\nff00\n", "1.5\n-1.01\n");
  EXPECT_EQ(run.status, 1) << run.err;
  command::expect_contains(run.out, "ff00 (-1): -1 expected, -1.01 said");
  run = check("to_decimal", "00010000\n", "one\n");
  EXPECT_EQ(run.status, 2);
  command::expect_contains(run.err, "standard input, line 1: 'one' is not a decimal number");
}

TEST(CheckConversions, GenIsWhatCheckMakesAgain) {
  const std::string options = "from_decimal --format q8_8 --cases 500";
  const std::string cases = command::output_of("gen " + options);
  const auto lines = command::split(cases, '\n');
  std::string results;
  const Variant v = variant(Operation::from_decimal, "q8_8");
  for (const std::string_view line : lines) {
    if (line.empty()) continue;
    results += hex_text(*expected(rules_for(v, Rounding::half_up), line), v.format) + "\n";
  }
  const auto run = command::fixproof("check " + options + " --rounding half-up", results);
  EXPECT_EQ(run.status, 0) << run.out << run.err;
}

TEST(CheckConversions, OptionsThatDoNotApply) {
  command::expect_refused("gen convert", "convert: --to is required");
  command::expect_refused("gen to_decimal --to q8_8", "--to: to_decimal has one format");
  command::expect_refused("check to_decimal --rounding floor", "--rounding applies only to");
  command::expect_refused("check to_decimal --overflow wrap", "--overflow applies only to");
  command::expect_refused("check convert --to q8_8 --rounding floor --not-finite zero",
                          "--not-finite applies only to from_binary64");
  command::expect_refused("eval convert", "convert is a conversion, which only gen and check take");
  command::expect_refused("verify from_decimal", "which only gen and check take");
}

}  // namespace

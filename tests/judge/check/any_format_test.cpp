// Tests words of any width and scale, results of another format, sums, and promised errors. The
// expected words are worked by hand.
#include <fmt/format.h>

#include <functional>
#include <random>
#include <string>

#include "judge/check/cases.hpp"
#include "judge/check/judge.hpp"
#include "judge/check/verdict_text.hpp"
#include "support/usage_error.hpp"
#include "tests/support/command.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"
#include "verify/cases/words.hpp"

namespace {

using namespace fixproof::check;
using fixproof::cases::format_named;
using fixproof::cases::judged_format_named;
using fixproof::cases::Operation;
using fixproof::cases::variant_of;
using fixproof::support::UsageError;

/// What `eval` answers to one line.
std::string evaluated(const std::string& arguments, const std::string& line) {
  const auto run = command::fixproof("eval " + arguments, line + "\n");
  EXPECT_EQ(run.status, 0) << arguments << ": " << run.err;
  return run.out.substr(0, run.out.find('\n'));
}

/// What `check` says of one result for one case.
command::Run checked(const std::string& arguments, const std::string& line,
                     const std::string& result) {
  const ScratchFolder folder;
  return command::fixproof("check " + arguments + " --from " + folder.write("c", line + "\n"),
                           result + "\n");
}

TEST(CheckAnyFormat, NamesOfFormats) {
  for (const char* name : {"q2_16", "q30_10", "u6_0", "q20_-2", "q-4_20", "d64_8", "ud32_2", "q1_1",
                           "u0_64", "q-60_124"}) {
    EXPECT_EQ(name_of(judged_format_named(name)), name);
    EXPECT_EQ(fixproof::cases::is_of_type(judged_format_named(name)), name == std::string("u0_64"))
        << name;
  }
  for (const char* name : {"q1_0", "q33_32", "q-0_16", "q016_16", "q16", "d64", "d65_8", "d64_-8",
                           "d64_39", "x16_16", "q", "_", "q-65_129", "dq8_8"}) {
    EXPECT_THROW(static_cast<void>(judged_format_named(name)), UsageError) << name;
  }
  EXPECT_THROW(static_cast<void>(format_named("q2_16")), UsageError);
}

TEST(CheckAnyFormat, AWordIsStoredInTheNextLargerInteger) {
  const auto q2_16 = judged_format_named("q2_16");
  EXPECT_EQ(hex_text(0x3ffff, q2_16), "ffffffff");
  EXPECT_EQ(parse_result("ffffffff", q2_16), 0x3ffffU);
  EXPECT_EQ(parse_result("0001ffff", q2_16), 0x1ffffU);
  EXPECT_FALSE(is_word(*parse_result("0003ffff", q2_16), q2_16));
  EXPECT_FALSE(is_word(*parse_result("fffdffff", q2_16), q2_16));
  EXPECT_EQ(hex_text(*parse_result("fffdffff", q2_16), q2_16), "fffdffff");
  const auto u6_0 = judged_format_named("u6_0");
  EXPECT_EQ(parse_result("3f", u6_0), 0x3fU);
  EXPECT_FALSE(is_word(*parse_result("7f", u6_0), u6_0));
  EXPECT_EQ(decimal_text(0x3ffff, q2_16), "-0.00002");
  EXPECT_EQ(decimal_text(3, judged_format_named("q20_-2")), "12");
  EXPECT_EQ(decimal_text(123456789, judged_format_named("d64_8")), "1.23456789");
}

TEST(CheckAnyFormat, ResultsThatAreNoWordAreWrong) {
  // 1.5 * 0.5 in 18 bits is 0.75, 0xc000. The integer that holds it may have no other bits.
  const std::string arguments = "mul --format q2_16 --rounding half-up";
  EXPECT_EQ(checked(arguments, "00018000 00008000", "0000c000").status, 0);
  const auto wrong = checked(arguments, "00018000 00008000", "0004c000");
  EXPECT_EQ(wrong.status, 1) << wrong.out;
  command::expect_contains(wrong.out, "0000c000 expected, 0004c000 said");
  command::expect_usage_error(checked(arguments, "0003ffff 00008000", "0000c000"),
                              "'0003ffff' is not a word of q2_16: the bits above its 18");
}

TEST(CheckAnyFormat, ResultsOfAnotherFormat) {
  // (-1)^2 is 1.0, which only the wide result has.
  EXPECT_EQ(evaluated("mul --format q1_15 --to q2_30", "8000 8000"), "40000000");
  EXPECT_EQ(evaluated("mul --format q1_15 --to q1_31", "8000 8000"), "80000000");
  EXPECT_EQ(evaluated("div --format q1_15 --to q16_16", "4000 2000"), "00020000");
  EXPECT_EQ(evaluated("hypot --format q1_31 --to q2_30", "80000000 80000000"), "5a82799a");
  // The sine of an eighth of a turn is 0.70710678, 23170.475 of 2^15.
  EXPECT_EQ(evaluated("sin_of_turns --format u0_16 --to q1_15", "2000"), "5a82");
  EXPECT_EQ(evaluated("add --format q8_8 --to q16_0", "0180 0100"), "0003");  // 2.5 half up
  EXPECT_EQ(evaluated("sqrt --format q8_8 --to u4_4", "0200"), "17");  // 1.41421 is 22.63 of 1/16
  EXPECT_EQ(evaluated("sqrt --format u0_2 --to u8_0", "01"), "01");    // 1/2, a tie
}

TEST(CheckAnyFormat, RootsOfNegativeNumbersMirrorInEveryFormat) {
  const auto v = variant_of(Operation::sqrt, format_named("q8_8"), format_named("q4_4"));
  Rules rules{.variant = v, .rounding = oracle::Rounding::floor, .no_result = NoResult::mirror};
  // The root of 2 is 22.63 of 1/16.
  const ValuedCase minus_2 = parse_valued("fe00", v);
  EXPECT_EQ(expected_of(rules, minus_2).said, 0x100 - 23U);
  rules.rounding = oracle::Rounding::ceiling;
  EXPECT_EQ(expected_of(rules, minus_2).said, 0x100 - 22U);
}

TEST(CheckAnyFormat, DecimalScales) {
  // 0.1 * 0.1 = 0.01, and 1.00000001 / 3 = 0.333333336666...
  EXPECT_EQ(evaluated("mul --format d64_8", "0000000000989680 0000000000989680"),
            "00000000000f4240");
  EXPECT_EQ(evaluated("div --format d64_8", "0000000005f5e101 0000000011e1a300"),
            "0000000001fca056");
  // 0.00000001 * 0.5 is half a unit.
  EXPECT_EQ(evaluated("mul --format d64_8", "0000000000000001 0000000002faf080"),
            "0000000000000001");
  const auto wrong = checked("mul --format d64_8 --rounding half-even",
                             "0000000000000001 0000000002faf080", "0000000000000001");
  EXPECT_EQ(wrong.status, 1);
  command::expect_contains(wrong.out, "(0.00000001 0.5): 0000000000000000 expected");
  EXPECT_EQ(evaluated("sqrt --format d64_8", "000000000bebc200"), "00000000086deb2c");  // 2
  command::expect_refused("eval sin --format d32_4", "a unit from 2^-64 to 1, which d32_4 is not");
}

TEST(CheckAnyFormat, SumsAreRoundedOnce) {
  // (-1)(-1) + (-1)(-1) is 2.0, which q1_15 lacks and q3_29 has.
  EXPECT_EQ(evaluated("dot --format q1_15 --to q3_29", "8000 8000 8000 8000"), "40000000");
  const auto wrapped = checked("dot --format q1_15 --overflow saturate --rounding half-up",
                               "8000 8000 8000 8000", "8000");
  EXPECT_EQ(wrapped.status, 1);
  command::expect_contains(wrapped.out, "7fff expected, 8000 said");
  // 0.5 ulp + 0.5 ulp is 1 ulp if it is rounded once, 2 if each product is rounded up.
  EXPECT_EQ(evaluated("dot", "00000001 00000001 00008000 00008000"), "00000001");
  EXPECT_EQ(evaluated("dot --terms 1 --format q8_8", "0180 0280"), "03c0");
  EXPECT_EQ(evaluated("mul_add", "00018000 00028000 00010000"), "0004c000");
  EXPECT_EQ(evaluated("lerp", "00010000 00030000 00004000"), "00018000");
  EXPECT_EQ(evaluated("lerp --format q1_31", "80000000 7fffffff 40000000"), "00000000");
  command::expect_refused("verify dot", "dot is a sum, which only gen, eval and check take");
  command::expect_refused("gen mul --terms 3", "--terms applies only to dot");
  EXPECT_EQ(evaluated("mul --to q16_16", "1.5 2"), "00030000");
  command::expect_refused("eval decimal --format q2_16", "which q2_16 is not");
}

TEST(CheckAnyFormat, TheCasesOfADotProductFindTheSmallestDefect) {
  const auto gen = command::output_of("gen dot --format q1_15");
  EXPECT_NE(gen.find("8000 8000 8000 8000\n"), std::string::npos);
}

TEST(CheckAnyFormat, RootsThatRoundUpCanOverflow) {
  EXPECT_EQ(
      checked("sqrt --format q1_15 --rounding ceiling --overflow saturate", "7fff", "7fff").status,
      0);
}

TEST(CheckAnyFormat, CentsHaveTies) {
  // Half-even results fail as half-up, because ties are among the cases.
  for (const char* operation : {"convert", "add", "sub"}) {
    const auto v = variant_of(fixproof::cases::operation_named(operation),
                              judged_format_named("d64_8"), judged_format_named("d64_2"));
    GeneratedCases cases(v, {.cases = 3000});
    Rules even{.variant = v, .rounding = oracle::Rounding::half_even};
    Judge judge({.variant = v}, 1);
    while (const auto one = cases.next_valued()) {
      JudgedCase judged;
      judged.valued = one;
      judged.said = expected_of(even, *one).said;
      judge.add(judged);
    }
    EXPECT_GT(judge.tally(CaseKind::tie, false).cases, 100U) << operation;
    EXPECT_GT(judge.wrong(), 0U) << operation;
  }
}

TEST(CheckAnyFormat, SumsOfCoarserResultsHaveTies) {
  for (const char* operation : {"mul_add", "lerp", "dot"}) {
    const auto v = variant_of(fixproof::cases::operation_named(operation), format_named("q8_8"),
                              judged_format_named("q12_4"));
    GeneratedCases cases(v, {});
    std::uint64_t ties = 0;
    while (const auto one = cases.next_valued()) {
      if (cases.origin() == "product_ties" && exact_place(v, *one).tie) ++ties;
    }
    EXPECT_GT(ties, cases.count_of("product_ties") * 9 / 10) << operation;
  }
}

TEST(CheckAnyFormat, WrongQuotientsOfProductsInUnitsAbove1) {
  // 8 * 12 / 16 is 6, halfway between 4 and 8.
  const auto wrong = checked("mul_div --format q20_-2 --rounding half-up",
                             "00000002 00000003 00000004", "00000001");
  EXPECT_EQ(wrong.status, 1) << wrong.err;
  command::expect_contains(wrong.out, "(8 12 16): 00000002 expected, 00000001 said");
}

TEST(CheckAnyFormat, UnsignedResultsOfSignedOperandsAreToldApart) {
  const ScratchFolder folder;
  const std::string cases = folder.write("c", "ffff0000 00000000\n00010000 00000000\n");
  const auto run =
      command::fixproof("check div --to u8_8 --rounding floor --from " + cases, "0000\nffff\n");
  command::expect_contains(run.out, "gives ffff or 0000, by the sign of the dividend");
  command::expect_contains(run.out, "--divide-by-zero saturate accepts them");
  // What the hint names is taken.
  const auto roots = command::fixproof(
      "check rsqrt --format u8_8 --rounding half-up --from " + folder.write("z", "0000\n"),
      "ffff\n");
  command::expect_contains(roots.out, "--outside-domain maximum accepts them");
}

TEST(CheckPromises, WithinABound) {
  // The exact product is 0.5 ulp.
  const std::string half = "00000001 00008000";
  EXPECT_EQ(checked("mul --within 1.5", half, "00000002").status, 0);
  EXPECT_EQ(checked("mul --within 1.4999", half, "00000002").status, 1);
  EXPECT_EQ(checked("mul --within 1.5", half, "ffffffff").status, 0);
  // 200 * 1 is off by 1, which is 0.5 %.
  EXPECT_EQ(checked("mul --within 0.5%", "00c80000 00010000", "00c90000").status, 0);
  EXPECT_EQ(checked("mul --within 0.49%", "00c80000 00010000", "00c90000").status, 1);
  EXPECT_EQ(checked("mul --within 1%", "00000000 00010000", "00000001").status, 1);
  for (const char* bound : {"-1", "x", "%", "1 %"}) {
    command::expect_refused(fmt::format("check mul --within '{}'", bound), "--within: write a");
  }
}

TEST(CheckPromises, AWrongOrderIsADefectWhereTheErrorIsBounded) {
  const ScratchFolder folder;
  const std::string cases = folder.write("c", "00000000\n00000100\n00000200\n");
  // exp2 of these is 1 + 177.4 and 1 + 354.9 ulps: the second result exceeds the third.
  const std::string results = "00010000\n00010190\n00010150\n";
  const auto run = command::fixproof("check exp2 --within 300 --from " + cases, results);
  EXPECT_EQ(run.status, 1) << run.out;
  command::expect_contains(run.out, "1 of 2 neighbours are in the wrong order");
  EXPECT_EQ(
      command::fixproof("check exp2 --within 300 --from " + cases, "00010000\n000100b1\n00010162\n")
          .status,
      0);
}

TEST(CheckPromises, EitherNeighbour) {
  const std::string tie = "00000001 00008000";
  EXPECT_EQ(checked("mul --rounding faithful", tie, "00000001").status, 0);
  EXPECT_EQ(checked("mul --rounding faithful", tie, "00000000").status, 0);
  EXPECT_EQ(checked("mul --rounding faithful", tie, "00000002").status, 1);
  EXPECT_EQ(checked("mul --rounding faithful", "00010000 00000003", "00000004").status, 1);
}

TEST(CheckPromises, CeilingIsARounding) {
  EXPECT_EQ(checked("mul --rounding ceiling", "00000001 00000001", "00000001").status, 0);
  EXPECT_EQ(checked("mul --rounding ceiling", "ffffffff 00000001", "00000000").status, 0);
  EXPECT_EQ(checked("div --rounding ceiling", "00000001 00030000", "00000001").status, 0);
  EXPECT_EQ(checked("sqrt --rounding ceiling", "00020000", "00016a0a").status, 0);
}

/// Judges products of 16.16 whose results `subject` makes of the exact 64-bit product.
std::string verdict_of(const std::function<std::int64_t(std::int64_t)>& subject) {
  CaseOptions options;
  options.cases = 5000;
  const auto variant = variant_of(Operation::mul, format_named("q16_16"));
  GeneratedCases cases(variant, options);
  Judge judge({.variant = variant}, 3);
  JudgedCase one;
  std::array<std::uint32_t, 2> words{};
  while (cases.next(words)) {
    one.words = {words[0], words[1]};
    ++one.number;
    one.said = static_cast<std::uint32_t>(subject(
        std::int64_t{static_cast<std::int32_t>(words[0])} * static_cast<std::int32_t>(words[1])));
    judge.add(one);
  }
  return verdict_text(judge);
}

TEST(CheckVerdicts, ARandomRounderHasNoRule) {
  std::mt19937_64 random(1);
  const std::string text = verdict_of([&](std::int64_t product) {
    return (product + static_cast<std::int64_t>(random() & 0xffff)) >> 16;
  });
  command::expect_contains(text, "rounding         either neighbour, no rule, on all ");
  command::expect_contains(text, "; the upper one in ");
}

TEST(CheckVerdicts, LowBitsThatAreAlwaysZeroAreNamed) {
  const std::string text = verdict_of([](std::int64_t product) { return product >> 18 << 2; });
  command::expect_contains(
      text, "every result in range is a multiple of 4 units: its lowest 2 bits are always 0");
  EXPECT_EQ(verdict_of([](std::int64_t product) { return product >> 16; }).find("a multiple of"),
            std::string::npos);
}

TEST(CheckVerdicts, KindsOfWrongCasesAreShownInTurn) {
  const ScratchFolder folder;
  std::string cases;
  std::string results;
  for (int i = 1; i <= 20; ++i) {
    cases += fmt::format("{:08x} 00000000\n", i);  // divide errors, answered with 0
    results += "00000000\n";
  }
  cases += "00010000 00030000\n";  // 21845.33 ulps
  results += "00005557\n";
  const auto run = command::fixproof(
      "check div --rounding half-up --show 3 --from " + folder.write("c", cases), results);
  EXPECT_EQ(run.status, 1);
  command::expect_contains(run.out, "00010000 00030000 (1 3): 00005555 expected, 00005557 said");
  command::expect_contains(run.out, "Shown: 3 of 21 wrong results");
}

TEST(CheckVerdicts, ShiftsInPlaceOfDividesByOneLessThanAPowerOfTwo) {
  const ScratchFolder folder;
  std::string cases;
  std::string results;
  for (unsigned i = 0; i < 64; ++i) {
    const unsigned a = 4 * i + 3;
    cases += fmt::format("{:02x} ff ff\n{:02x} {:02x} ff\n", a, a, 255 - i);
    results += fmt::format("{:02x}\n{:02x}\n", a * 255 >> 8, a * (255 - i) >> 8);
  }
  const auto run = command::fixproof(
      "check mul_div --format u8_0 --rounding toward-zero --from " + folder.write("c", cases),
      results);
  EXPECT_EQ(run.status, 1);
  command::expect_contains(run.out, "looks like       a * b >> k, which divides by 2^k");
}

TEST(CheckOptions, WordsAndNumbersStandForRules) {
  EXPECT_EQ(
      checked("div --rounding floor --divide-by-zero 0", "00010000 00000000", "00000000").status,
      0);
  EXPECT_EQ(
      checked("div --rounding floor --divide-by-zero 1.5", "00010000 00000000", "00018000").status,
      0);
  EXPECT_EQ(
      checked("div --rounding floor --divide-by-zero 7fff0000", "00010000 00000000", "7fff0001")
          .status,
      1);
  const auto run = checked("mul --rounding floor --overflow -1", "7fffffff 7fffffff", "ffff0000");
  EXPECT_EQ(run.status, 0) << run.err;
  command::expect_contains(run.out, "overflow ffff0000");
  command::expect_refused("check div --rounding floor --divide-by-zero 40000",
                          "--divide-by-zero 40000: q16_16 has no such number");
  command::expect_refused("check div --rounding floor --divide-by-zero zeros", "choose one of de");
  EXPECT_EQ(checked("div --format q4_4 --rounding floor --divide-by-zero DE", "01 00", "DE").status,
            0);
}

TEST(CheckOptions, NoRoundingIsRequiredWhereNothingIsRounded) {
  const auto run = checked("mul --format q16_0", "0003 0004", "000c");
  EXPECT_EQ(run.status, 0) << run.err;
  command::expect_contains(run.out, "mul q16_0: exact");
  EXPECT_EQ(checked("convert --format q8_8 --to q16_16", "0180", "00018000").status, 0);
  command::expect_refused("check add --format q8_8 --to q16_0", "--rounding, --within or --rule");
}

}  // namespace

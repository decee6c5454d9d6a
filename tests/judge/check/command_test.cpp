// Tests `fixproof gen` and `fixproof check` as a user runs them.
#include "tests/support/command.hpp"

#include <fmt/format.h>

#include "tests/support/paths.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

using command::expect_contains;
using command::expect_refused;
using command::expect_usage_error;

/// 1.5 * 2.5 and -1 ulp * 0.5.
constexpr std::string_view two_cases = "# two\n00018000 00028000\n\nffffffff 00008000\n";

command::Run check_two(std::string_view options, std::string_view results) {
  const ScratchFolder folder;
  return command::fixproof(
      fmt::format("check mul --from {} {}", folder.write("cases", two_cases), options), results);
}

TEST(CheckCommand, RightResults) {
  const auto run = check_two("--rounding half-up", "0003c000\n00000000\n");
  EXPECT_EQ(run.status, 0) << run.err;
  expect_contains(run.out, "half-up, half-even, toward-zero or ceiling on all 2 cases in range");
}

TEST(CheckCommand, ResultsByTheRuleOfAProgram) {
  const auto run = check_two("--rule doom", "0003c000\nffffffff\n");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with("mul: the rule doom (FixedMul); cases of ")) << run.out;
  expect_contains(run.out,
                  "  follows the rule doom, chocolate-doom, build, descent, allegro-i386, "
                  "allegro-c or allegro-double on all 2 cases\n");
  const auto other = check_two("--rule rott", "0003c000\nffffffff\n");
  EXPECT_EQ(other.status, 1) << other.err;
  expect_contains(other.out,
                  "ffffffff 00008000 (-0.00002 0.5): 00000000 expected, ffffffff said; ");
}

// The words are shown as they are, the numbers as the rule reads them.
TEST(CheckCommand, ARuleThatReadsASignAndAMagnitude) {
  const ScratchFolder folder;
  const auto cases = folder.write("cases", "00020000 80008000\n00010000 00010000\n");
  const auto run =
      command::fixproof("check mul --rule wolf3d --from " + cases, "ffff0001\n00000000\n");
  EXPECT_EQ(run.status, 1) << run.err;
  expect_contains(run.out,
                  "00020000 80008000 (2 -0.5): ffff0000 expected, ffff0001 said; exact -65536 ulp, "
                  "exact");
}

TEST(CheckCommand, WrongResults) {
  const auto run = check_two("--rounding half-away", "0003c000\r\n# a comment\n00000000");
  EXPECT_EQ(run.status, 1) << run.err;
  expect_contains(run.out,
                  "ffffffff 00008000 (-0.00002 0.5): ffffffff expected, 00000000 said; "
                  "exact -1 + 1/2 ulp, tie");
}

// The answers of an unrounded divide, with the sign of the dividend 80000000 lost.
TEST(CheckCommand, WhatWrongCasesHaveInCommon) {
  const std::string gen = "div --cases 20000";
  const std::string rules = " --rounding toward-zero --overflow de";
  const auto cases = command::split(command::output_of("gen " + gen), '\n');
  const auto answers = command::split(
      command::output_of("eval div --target i386 --round off", command::output_of("gen " + gen)),
      '\n');
  std::string planted;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i + 1 < cases.size(); ++i) {
    const bool lost = cases[i].starts_with("80000000 ") && answers[i] != "DE";
    if (lost) ++wrong;
    planted += (lost ? "00000000" : answers[i]) + "\n";
  }
  const auto run = command::fixproof("check " + gen + rules, planted);
  EXPECT_EQ(run.status, 1) << run.err;
  expect_contains(run.out, fmt::format("What the wrong cases have in common:\n"
                                       "  every wrong result is 00000000: all {0}\n"
                                       "  every wrong case has dividend 80000000: all {0}, and ",
                                       wrong));
}

// The type's standard rules wrap sums and differences.
TEST(CheckCommand, SumsAndDifferences) {
  for (const std::string operation : {"add", "sub"}) {
    const std::string cases = command::output_of("gen " + operation + " --cases 5000");
    const std::string answers = command::output_of("eval " + operation, cases);
    const auto wraps = command::fixproof("check " + operation + " --cases 5000", answers);
    EXPECT_EQ(wraps.status, 0) << wraps.out << wraps.err;
    expect_contains(wraps.out, operation + ": exact, overflow wrap; cases of fixproof gen");
    expect_contains(wraps.out, "  in range         exact on all ");
    expect_contains(wraps.out, "  overflow         wraps on all ");
    const auto clamps =
        command::fixproof("check " + operation + " --cases 5000 --overflow saturate", answers);
    EXPECT_EQ(clamps.status, 1) << clamps.err;
    expect_contains(clamps.out, "every wrong case overflows: all ");
  }
}

// The type wraps quotients of products; a zero divisor is DE.
TEST(CheckCommand, RemaindersAndQuotientsOfProducts) {
  for (const std::string operation : {"fmod", "remainder"}) {
    const std::string cases = command::output_of("gen " + operation + " --cases 5000");
    const std::string answers = command::output_of("eval " + operation, cases);
    const auto run = command::fixproof("check " + operation + " --cases 5000", answers);
    EXPECT_EQ(run.status, 0) << run.out << run.err;
    expect_contains(run.out, operation + ": exact, divide by zero de; cases of fixproof gen");
    expect_contains(run.out, "  in range         exact on all ");
    expect_contains(run.out, "  divide by zero   says DE on all ");
    expect_refused("check " + operation + " --overflow wrap",
                   "--overflow applies only to results that can overflow");
  }
  for (const std::string format : {"q16_16", "u0_64"}) {
    const std::string options = " --cases 5000 --format " + format;
    const std::string cases = command::output_of("gen mul_div" + options);
    const std::string answers = command::output_of("eval mul_div --format " + format, cases);
    const auto run = command::fixproof("check mul_div --rounding half-up" + options, answers);
    EXPECT_EQ(run.status, 0) << run.out << run.err;
    expect_contains(run.out, "half-up, overflow wrap, divide by zero de; cases of fixproof gen");
    // Of numbers without a sign, up is away from zero.
    expect_contains(run.out, format == "u0_64" ? "  rounding         half-up or half-away on all "
                                               : "  rounding         half-up on all ");
    EXPECT_EQ(command::fixproof("check mul_div --rounding half-even" + options, answers).status, 1);
  }
  const std::string cases = command::output_of("gen hypot3 --cases 5000");
  const std::string answers = command::output_of("eval hypot3", cases);
  const auto run = command::fixproof("check hypot3 --cases 5000 --rounding half-up", answers);
  EXPECT_EQ(run.status, 0) << run.out << run.err;
  expect_contains(run.out, "  overflow         saturates to 7fffffff and 80000000");
}

TEST(CheckCommand, ShowsNoMoreThanAskedFor) {
  const auto run = check_two("--rounding floor --show 1", "DE\nDE\n");
  EXPECT_EQ(run.status, 1);
  expect_contains(run.out, "Shown: 1 of 2 wrong results");
}

TEST(CheckCommand, ResultsInAFile) {
  const ScratchFolder folder;
  const auto results = folder.write("results", "0003c000\n00000000\n");
  const auto run = check_two("--rounding half-up " + results, "nothing is read here");
  EXPECT_EQ(run.status, 0) << run.err;
}

TEST(CheckCommand, TooFewResults) {
  const auto run = check_two("--rounding half-up", "0003c000\n");
  expect_usage_error(run, "standard input ends after 1 result");
  expect_contains(run.out, "half-up");
  const auto generated =
      command::fixproof("check div --rounding half-up --cases 5 --seed 3", "00000000\n");
  expect_usage_error(generated, "ends after 1 result, but there are 5 cases");
}

TEST(CheckCommand, TooManyResults) {
  expect_usage_error(check_two("--rounding half-up", "0003c000\n00000000\n# end\n00000000\n"),
                     "standard input, line 4: one result too many for 2 cases");
}

TEST(CheckCommand, NoResultsAtAll) {
  expect_usage_error(check_two("--rounding half-up", ""), "ends after 0 results");
}

TEST(CheckCommand, LinesThatAreNoResults) {
  for (const std::string_view bad : {"0x03c000", "245760", "3.75", "0003C000", "de", "DE ", "-1",
                                     "0003c000 00000000", "0003c0000"}) {
    expect_usage_error(check_two("--rounding half-up", fmt::format("0003c000\n{}\n", bad)),
                       "standard input, line 2: ");
  }
  const auto run = check_two("--rounding half-up", "245760\n");
  expect_usage_error(run,
                     "line 1: '245760' has 6 hex digits instead of 8; a result is 8 "
                     "lower-case hex digits, or DE for a divide error");
}

TEST(CheckCommand, ResultsOfOtherFormats) {
  const ScratchFolder folder;
  const auto judge = [&folder](std::string_view format, std::string_view one_case,
                               std::string_view result) {
    return command::fixproof(fmt::format("check mul --format {} --rounding half-up --from {}",
                                         format, folder.write("cases", one_case)),
                             result);
  };
  // 1.5 * 2.25 is 3.375.
  const auto right = judge("q32_32", "0000000180000000 0000000240000000\n", "0000000360000000\n");
  EXPECT_EQ(right.status, 0) << right.err;
  expect_contains(right.out, "mul q32_32: half-up, overflow wrap");
  EXPECT_EQ(judge("u8_8", "0180 0240\n", "0361\n").status, 1);
  expect_usage_error(
      judge("u8_8", "0180 0240\n", "00000360\n"),
      "line 1: '00000360' has 8 hex digits instead of 4; a result is 4 lower-case hex "
      "digits, or DE for a divide error");
  expect_usage_error(judge("q57_8", "0180 0240\n", "0360\n"), "q57_8 is not a format");
  expect_refused("check sqrt --format u8_8 --rounding floor --negative-root zero",
                 "--negative-root applies only to sqrt of a signed format");
}

// A user's Q15 multiply, which saturates but does not round.
TEST(CheckCommand, AFractionalMultiplyOfAnotherProgram) {
  const auto cases = command::fixproof("gen mul --format q1_15 --cases 20000");
  std::string results;
  std::istringstream lines(cases.out);
  for (std::string line; std::getline(lines, line);) {
    const auto word = [&line](std::size_t at) {
      const long bits = std::stol(line.substr(at, 4), nullptr, 16);
      return bits < 0x8000 ? bits : bits - 0x10000;
    };
    const long shifted = std::min(word(0) * word(5) >> 15, 0x7fffL);
    results += fmt::format("{:04x}\n", shifted & 0xffff);
  }
  const auto run = command::fixproof(
      "check mul --format q1_15 --cases 20000 --rounding half-up --overflow saturate", results);
  EXPECT_EQ(run.status, 1) << run.err;
  expect_contains(run.out, "every wrong result is 1 ulp too low: all ");
  expect_contains(run.out, "rounding         floor on all ");
  expect_contains(run.out, "looks like       (int32_t)a * b >> 15, on all ");
}

// The type gives words where check expects DE, unless told otherwise.
TEST(CheckCommand, NamesTheOptionForOperandsWithoutAResult) {
  const auto hint_for = [](const std::string& operation) {
    const auto cases = command::fixproof("gen " + operation + " --cases 500");
    const auto results = command::fixproof("eval " + operation, cases.out);
    const auto run =
        command::fixproof("check " + operation + " --cases 500 --rounding half-up", results.out);
    EXPECT_EQ(run.status, 1) << run.err;
    return run.out;
  };
  expect_contains(hint_for("log2"),
                  "\nAll wrong results are in the row 'outside domain'; "
                  "--outside-domain minimum accepts them.\n");
  expect_contains(hint_for("sqrt"), "'negative operand'; --negative-root zero accepts them.\n");
  // Powers of 0 are the highest number, and those of negative numbers are 0.
  expect_contains(hint_for("pow"), "'outside domain'; --outside-domain any accepts them.\n");
  const auto other = command::fixproof("check mul --cases 1 --rounding half-up", "00000001\n");
  EXPECT_EQ(other.out.find("accepts"), std::string::npos) << other.out;
}

TEST(CheckCommand, LinesThatAreNoCases) {
  const ScratchFolder folder;
  const auto cases = folder.write("cases", "# comment\n00018000\n");
  const auto run =
      command::fixproof("check mul --rounding floor --from " + cases, "00000000\n00000000\n");
  expect_usage_error(run, "cases, line 2: mul takes 2 words, separated by single spaces");
  const auto none = folder.write("none", "# nothing\n");
  expect_usage_error(command::fixproof("check mul --rounding floor --from " + none),
                     "there are no cases");
}

// A missing answer would assign all later answers to the wrong cases.
TEST(CheckCommand, BlankLineBetweenResults) {
  const std::string command = "check mul --cases 3 --rounding floor";
  expect_usage_error(command::fixproof(command, "00000000\n\n00000000\n00000000\n"),
                     "standard input, line 2: a blank line is not a result; a result is");
  const auto at_the_end =
      command::fixproof(command + " --overflow any", "#\nDE\nDE\nDE\n\n \n# end\n");
  EXPECT_EQ(at_the_end.status, 1) << at_the_end.err;
}

// An endless line must not fill the memory.
TEST(CheckCommand, LineWithoutAnEnd) {
  const std::string long_line(1 << 20, '0');
  expect_usage_error(
      command::fixproof("check mul --cases 3 --rounding floor", "00000000\n" + long_line),
      "standard input, line 2: the line is longer than 4096 characters");
  expect_usage_error(command::fixproof("eval mul", long_line),
                     "line 1: the line is longer than 4096 characters");
  EXPECT_EQ(
      command::run({"sh", "-c",
                    "head -c 100000000 /dev/zero | \"$0\" check mul --cases 3 --rounding floor",
                    paths::command()})
          .status,
      2);
}

// The square root of 2 is 92681.9 ulps, so the mirrored root lies between -92682 and -92681. Rules
// that agree on roots differ on mirrored roots.
TEST(CheckCommand, MirroredRootsAreTwoRules) {
  const ScratchFolder folder;
  const std::string command = "check sqrt --negative-root mirror --from " +
                              folder.write("roots", "00020000\nfffe0000\n") + " --rounding ";
  const auto cut = command::fixproof(command + "toward-zero", "00016a09\nfffe95f7\n");
  EXPECT_EQ(cut.status, 0) << cut.out << cut.err;
  expect_contains(cut.out, "rounded toward zero on all 1 negative operands");
  const auto down = command::fixproof(command + "floor", "00016a09\nfffe95f6\n");
  EXPECT_EQ(down.status, 0) << down.out << down.err;
  expect_contains(down.out, "rounded down, away from zero on all 1 negative operands");
}

TEST(CheckCommand, OptionsThatAreNone) {
  expect_refused("check", "operation");
  expect_refused("check mul", "--rounding");
  expect_refused("check mul --rule floom",
                 "--rule 'floom': for mul in q16_16 choose one of doom, chocolate-doom, build, ");
  expect_refused("check sqrt --rule doom", "no program has a rule for sqrt in q16_16");
  expect_refused("check mul --format q8_8 --rule build", "no program has a rule for mul in q8_8");
  expect_refused("check mul --rule doom --rounding floor", "excludes");
  expect_refused("check concat --rounding floor",
                 "choose mul, div, sqrt, add, sub, mul_add, lerp, dot, from_binary64, ");
  expect_refused("check abs --rounding floor", "unknown operation");
  expect_refused("check add --rounding floor",
                 "--rounding applies only to results that are rounded");
  expect_refused("check mul --rounding up",
                 "half-up, half-away, half-even, floor, toward-zero, ceiling, faithful");
  expect_refused("check mul --rounding floor --overflow clamp",
                 "wrap, saturate, symmetric, maximum, minimum, de, any");
  expect_refused("check div --rounding floor --divide-by-zero wrap",
                 "de, saturate, symmetric, maximum, minimum, zero, any");
  expect_refused("check sqrt --rounding floor --negative-root saturate",
                 "de, maximum, minimum, zero, mirror, any");
  expect_refused("check mul --rounding floor --from a --seed 3", "excludes");
  expect_refused("check mul --rounding floor --from no_such_file", "cannot read no_such_file");
  expect_refused("check mul --rounding floor no_such_file", "cannot read no_such_file");
  expect_refused("check mul --rounding floor /tmp", "/tmp, line 1: cannot be read: ");
  expect_refused("check mul --rounding floor --from /tmp", "/tmp, line 1: cannot be read: ");
  expect_refused("check mul --rounding floor --show -1", "whole number");
  expect_refused("check mul --rounding floor --divide-by-zero zero",
                 "--divide-by-zero applies only to div");
  expect_refused("check div --rounding floor --negative-root zero",
                 "--negative-root applies only to sqrt");
  expect_refused("check sqrt --rounding floor --overflow wrap",
                 "--overflow applies only to results that can overflow");
  expect_refused("gen", "operation");
  expect_refused("gen abs", "unknown operation");
  expect_refused("gen mul --level 3", "whole number from 1 to 2");
  expect_refused("gen mul --shard 3/2", "--shard 3/2");
  expect_refused("gen mul --cases 0", "whole number");
  expect_refused("gen mul -o no/such/file", "no/such/file");
}

TEST(GenCommand, WritesTheCasesThatEvalReads) {
  const std::string cases = command::output_of("gen div --cases 2000");
  const std::string answers = command::output_of("eval div --target i386 --round off", cases);
  const auto verdict =
      command::fixproof("check div --cases 2000 --rounding toward-zero --overflow de", answers);
  EXPECT_EQ(verdict.status, 0) << verdict.out << verdict.err;
}

// A program may split each line into operands without a thought of comments.
TEST(GenCommand, WritesOnlyCases) {
  const std::string cases = command::output_of("gen div --cases 2000");
  auto lines = command::split(cases, '\n');
  EXPECT_EQ(lines.size(), 2001U);
  lines.pop_back();  // behind the last newline
  for (const std::string& line : lines) {
    EXPECT_EQ(line.size(), 17U) << line;
    EXPECT_EQ(line.find_first_not_of("0123456789abcdef"), 8U) << line;
  }
}

TEST(GenCommand, NamesTheStreamsIfAsked) {
  const std::string commented = command::output_of("gen div --cases 2000 --comments");
  EXPECT_TRUE(
      commented.starts_with("# fixproof gen div --level 1 --cases 2000: 2000 cases\n# lattice: "));
  std::string cases;
  for (const std::string& line : command::split(commented, '\n')) {
    if (!line.empty() && !line.starts_with('#')) cases += line + '\n';
  }
  EXPECT_EQ(cases, command::output_of("gen div --cases 2000"));
  // Both forms are cases for check --from, and both have the answers of eval.
  const ScratchFolder folder;
  const std::string answers = command::output_of("eval div --target i386 --round off", commented);
  for (const std::string& text : {commented, cases}) {
    const auto verdict = command::fixproof(
        "check div --rounding toward-zero --overflow de --from " + folder.write("cases", text),
        answers);
    EXPECT_EQ(verdict.status, 0) << verdict.out << verdict.err;
  }
}

TEST(GenCommand, OfEveryOperationOfEval) {
  for (const std::string operation : {"mul", "div", "cossin", "xformvec", "concat"}) {
    const std::string cases = command::output_of("gen " + operation + " --cases 50");
    EXPECT_EQ(command::split(command::output_of("eval " + operation, cases), '\n').size(), 51U);
  }
}

TEST(GenCommand, IntoAFile) {
  const ScratchFolder folder;
  EXPECT_EQ(command::output_of("gen sqrt --cases 100 -o " + folder.path("cases")), "");
  EXPECT_EQ(folder.read("cases"), command::output_of("gen sqrt --cases 100"));
}

TEST(GenCommand, AReaderThatHasGoneIsNoError) {
  const auto run = command::fixproof("gen mul", "", command::Output::reader_gone);
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");
}

TEST(GenCommand, AFullDiskIsAnError) {
  expect_usage_error(command::fixproof("gen mul", "", command::Output::full_device),
                     "fixproof: cannot write standard output\n");
}

}  // namespace

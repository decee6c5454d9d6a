// Tests the output of `fixproof eval` against words worked out by hand.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "tests/cli/command.hpp"

namespace {

/// Expects the same answer from every party and nothing on stderr.
void expect_from_all(std::string_view arguments, std::string_view line, std::string_view answer,
                     const std::vector<std::string>& parties = {"model", "interpreter", "oracle",
                                                                "fast", "type"}) {
  for (const std::string& party : parties) {
    const auto run = command::fixproof(fmt::format("eval {} --by {}", arguments, party),
                                       std::string(line) + '\n');
    EXPECT_EQ(run.out, std::string(answer) + '\n') << arguments << " by " << party << ": " << line;
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(run.status, 0);
  }
}

struct Case {
  std::string_view line;
  std::string_view i386_on;
  std::string_view i386_off;
  std::string_view i8088_on;
  std::string_view i8088_off;
};

void expect_in_all_forms(std::string_view operation, const Case& c) {
  const auto form = [&](std::string_view options) {
    return fmt::format("{} {}", operation, options);
  };
  expect_from_all(form("--target i386 --round on"), c.line, c.i386_on);
  expect_from_all(form("--target i386 --round off"), c.line, c.i386_off);
  expect_from_all(form("--target i8088 --round on"), c.line, c.i8088_on);
  expect_from_all(form("--target i8088 --round off"), c.line, c.i8088_off);
}

TEST(EvalMul, ExactProductsAreTheSameEverywhere) {
  expect_in_all_forms("mul", {"00018000 00028000", "0003c000", "0003c000", "0003c000", "0003c000"});
  expect_in_all_forms("mul", {"fffe8000 00028000", "fffc4000", "fffc4000", "fffc4000", "fffc4000"});
}

TEST(EvalMul, HalfAUnit) {
  expect_in_all_forms("mul", {"00000001 00008000", "00000001", "00000000", "00000001", "00000000"});
}

TEST(EvalMul, MinusHalfAUnit) {
  expect_in_all_forms("mul", {"ffffffff 00008000", "00000000", "ffffffff", "ffffffff", "00000000"});
}

TEST(EvalMul, MinusOneAndAHalfUnits) {
  expect_in_all_forms("mul", {"ffffffff 00018000", "ffffffff", "fffffffe", "fffffffe", "ffffffff"});
}

TEST(EvalMul, WrapsModulo2To32) {
  // (2^31 - 1)^2 = 2^62 - 2^32 + 1. Above the unit it is 2^46 - 2^16, which is -2^16 modulo 2^32.
  expect_in_all_forms("mul", {"7fffffff 7fffffff", "ffff0000", "ffff0000", "ffff0000", "ffff0000"});
  expect_in_all_forms("mul", {"80000000 80000000", "00000000", "00000000", "00000000", "00000000"});
  expect_in_all_forms("mul", {"80000000 ffff0000", "80000000", "80000000", "80000000", "80000000"});
}

TEST(EvalDiv, TheDivisorsFraction) {
  expect_in_all_forms("div", {"00078000 00028000", "00030000", "00030000", "0003c000", "0003c000"});
}

TEST(EvalDiv, TwoThirds) {
  expect_in_all_forms("div", {"00020000 00030000", "0000aaab", "0000aaaa", "0000aaab", "0000aaaa"});
  expect_in_all_forms("div", {"fffe0000 00030000", "ffff5555", "ffff5556", "ffff5555", "ffff5556"});
}

TEST(EvalDiv, HalvesGoAwayFromZero) {
  expect_in_all_forms("div", {"00000001 00020000", "00000001", "00000000", "00000001", "00000000"});
  expect_in_all_forms("div", {"ffffffff 00020000", "ffffffff", "00000000", "ffffffff", "00000000"});
}

TEST(EvalDiv, QuotientsThatOnlyTheSignBitCannotHold) {
  expect_in_all_forms("div", {"00008001 00000001", "80010000", "DE", "DE", "DE"});
  expect_in_all_forms("div", {"00008001 ffffffff", "7fff0000", "DE", "DE", "DE"});
  expect_in_all_forms("div", {"00008000 00000001", "80000000", "DE", "DE", "DE"});
  expect_in_all_forms("div", {"00008000 ffffffff", "80000000", "80000000", "DE", "DE"});
  expect_in_all_forms("div", {"80000000 ffff0000", "80000000", "DE", "80000000", "80000000"});
}

TEST(EvalDiv, QuotientsThatNoWordHolds) {
  expect_in_all_forms("div", {"00010000 00000001", "DE", "DE", "DE", "DE"});
  expect_in_all_forms("div", {"00010000 00000000", "DE", "DE", "DE", "DE"});
  expect_in_all_forms("div", {"00000000 00000000", "DE", "DE", "DE", "DE"});
}

TEST(EvalDiv, DivisorsBelowOne) {
  expect_in_all_forms("div", {"00010000 0000ffff", "00010001", "00010001", "DE", "DE"});
  expect_in_all_forms("div", {"00010000 ffff0001", "fffeffff", "fffeffff", "DE", "DE"});
}

TEST(EvalDiv, TheSmallestNumber) {
  expect_in_all_forms("div", {"80000000 80000000", "00010000", "00010000", "00010000", "00010000"});
}

TEST(EvalCosSin, AxesAndFamiliarAngles) {
  const std::vector<std::string> parties{"model", "interpreter", "oracle", "type"};
  for (const std::string_view target : {"i386", "i8088"}) {
    const auto arguments = fmt::format("cossin --target {}", target);
    for (const auto& [angle, answer] :
         std::array<std::pair<std::string_view, std::string_view>, 9>{
             {{"0000", "00010000 00000000"},
              {"0384", "00000000 00010000"},
              {"0708", "ffff0000 00000000"},
              {"0a8c", "00000000 ffff0000"},
              {"0e10", "00010000 00000000"},
              {"fc7c", "00000000 ffff0000"},    // -90.0
              {"01c2", "0000b505 0000b505"},    // 45.0: 46340.95
              {"012c", "0000ddb4 00008000"},    // 30.0: 56755.84
              {"fe3e", "0000b505 ffff4afb"}}})  // -45.0
    {
      expect_from_all(arguments, angle, answer, parties);
    }
  }
}

TEST(EvalXformVec, RotatesScalesAndMoves) {
  // Rows 0 -1 0 | 1,  1 0 0 | 2,  0 0 2 | -3 and the point (4, 5, 6).
  const std::string_view line =
      "00000000 ffff0000 00000000 00010000 00010000 00000000 00000000 00020000 "
      "00000000 00000000 00020000 fffd0000 00040000 00050000 00060000";
  for (const std::string_view target : {"i386", "i8088"}) {
    for (const std::string_view round : {"on", "off"}) {
      expect_from_all(fmt::format("xformvec --target {} --round {}", target, round), line,
                      "fffc0000 00060000 00090000");
    }
  }
}

TEST(EvalXformVec, RoundsEveryProductOnItsOwn) {
  // Three times minus half a unit in the first row, plus half a unit in the others.
  const std::string_view line =
      "00008000 00008000 00008000 00000000 ffff8000 ffff8000 ffff8000 00000000 "
      "ffff8000 00000000 00000000 00000000 ffffffff ffffffff ffffffff";
  expect_from_all("xformvec --target i386", line, "00000000 00000003 00000001");
  expect_from_all("xformvec --target i386 --round off", line, "fffffffd 00000000 00000000");
  expect_from_all("xformvec --target i8088", line, "fffffffd 00000003 00000001");
  expect_from_all("xformvec --target i8088 --round off", line, "00000000 00000000 00000000");
}

// The identity with a translation, twice: by (1, 2, 3), then by (4, 5, 6).
constexpr std::string_view two_moves =
    "00010000 00000000 00000000 00010000 00000000 00010000 00000000 00020000 "
    "00000000 00000000 00010000 00030000 00010000 00000000 00000000 00040000 "
    "00000000 00010000 00000000 00050000 00000000 00000000 00010000 00060000";

TEST(EvalConcat, AddsTheTranslationInTheFourthColumn) {
  for (const std::string_view target : {"i386", "i8088"}) {
    expect_from_all(fmt::format("concat --target {}", target), two_moves,
                    "00010000 00000000 00000000 00050000 00000000 00010000 00000000 00070000 "
                    "00000000 00000000 00010000 00090000");
  }
}

// A translation along z by 0.5 after one by `second`.
TEST(EvalConcat, The8088LosesTheCarryOfTheTranslation) {
  const auto moves = [](std::string_view second) {
    return fmt::format(
        "00010000 00000000 00000000 00000000 00000000 00010000 00000000 00000000 "
        "00000000 00000000 00010000 00008000 00010000 00000000 00000000 00000000 "
        "00000000 00010000 00000000 00000000 00000000 00000000 00010000 {}",
        second);
  };
  const auto moved = [](std::string_view by) {
    return fmt::format(
        "00010000 00000000 00000000 00000000 00000000 00010000 00000000 00000000 "
        "00000000 00000000 00010000 {}",
        by);
  };
  for (const std::string_view round : {"on", "off"}) {
    const auto with = [&](std::string_view options) {
      return fmt::format("concat --round {} --target {}", round, options);
    };
    expect_from_all(with("i8088"), moves("00008000"), moved("00000000"));
    expect_from_all(with("i8088 --repaired"), moves("00008000"), moved("00010000"));
    expect_from_all(with("i386"), moves("00008000"), moved("00010000"));
    expect_from_all(with("i8088"), moves("00018000"), moved("00010000"));
    expect_from_all(with("i8088 --repaired"), moves("00018000"), moved("00020000"));
    expect_from_all(with("i8088"), moves("00007fff"), moved("0000ffff"));
  }
}

TEST(EvalConcat, Chapter52AddsItInEveryColumn) {
  expect_from_all("concat --chapter 52", two_moves,
                  "00020000 00010000 00010000 00050000 00020000 00030000 00020000 00070000 "
                  "00030000 00030000 00040000 00090000");
}

TEST(EvalChapter52, HasOnlyRounded386Routines) {
  expect_from_all("div --chapter 52", "00020000 00030000", "0000aaab");
  expect_from_all("mul --chapter 52", "ffffffff 00008000", "00000000");
  for (const std::string_view other : {"--target i8088", "--round off", "--div-round off"}) {
    const auto run = command::fixproof(fmt::format("eval div --chapter 52 {}", other), "");
    EXPECT_EQ(run.err,
              "fixproof: --chapter 52 has only mul, div and concat, for i386, rounded; use "
              "--chapter 54\n")
        << other;
    EXPECT_EQ(run.status, 2) << other;
  }
}

TEST(EvalType, WhatIsNoRoutine) {
  const auto expect = [](std::string_view operation, std::string_view word,
                         std::string_view answer) {
    for (const std::string_view by : {"", " --by oracle", " --by fast", " --by type"}) {
      const auto run =
          command::fixproof(fmt::format("eval {}{}", operation, by), std::string(word) + '\n');
      EXPECT_EQ(run.out, std::string(answer) + '\n') << operation << by << ' ' << word;
    }
  };
  expect("sqrt", "00020000", "00016a0a");  // 92681.90
  expect("sin", "00010000", "0000d76b");   // 55146.64
  expect("cos", "00010000", "00008a51");   // 35409.25
  expect("sin", "80000000", "ffff1278");   // -60807.99
  expect("cos", "00000000", "00010000");
  expect("decimal", "80000001", "80000001");
  expect("binary64", "7fffffff", "7fffffff");
}

TEST(EvalOptions, EachRoundingAppliesToItsOwnRoutine) {
  expect_from_all("mul --mul-round off --div-round on", "ffffffff 00008000", "ffffffff");
  expect_from_all("mul --mul-round on --div-round off", "ffffffff 00008000", "00000000");
  expect_from_all("div --mul-round off --div-round on", "00020000 00030000", "0000aaab");
  expect_from_all("div --mul-round on --div-round off", "00020000 00030000", "0000aaaa");
  // The products inside XformVec are multiplies.
  expect_from_all("concat --mul-round on --div-round off", two_moves,
                  "00010000 00000000 00000000 00050000 00000000 00010000 00000000 00070000 "
                  "00000000 00000000 00010000 00090000");
}

TEST(EvalOptions, WithoutOptionsTheModelOfThe386Rounds) {
  EXPECT_EQ(command::fixproof("eval mul", "ffffffff 00008000\n").out, "00000000\n");
  EXPECT_EQ(command::fixproof("eval div", "00020000 00030000\n").out, "0000aaab\n");
}

TEST(EvalAsPrinted, The8088DivideInvertsItsSwitch) {
  const std::string_view two_thirds = "00020000 00030000";
  expect_from_all("div --as-printed --target i8088 --round on", two_thirds, "0000aaaa");
  expect_from_all("div --as-printed --target i8088 --div-round off", two_thirds, "0000aaab");
  expect_from_all("div --as-printed --target i386 --round on", two_thirds, "0000aaab");
  expect_from_all("div --as-printed --target i386 --round off", two_thirds, "0000aaaa");
  expect_from_all("mul --as-printed --target i8088 --round on", "00000001 00008000", "00000001");
  expect_from_all("mul --as-printed --target i8088 --round off", "00000001 00008000", "00000000");
}

TEST(EvalAsPrinted, DefaultsAreThePrintedOnes) {
  expect_from_all("mul --as-printed --target i386", "00000001 00008000", "00000001");
  expect_from_all("mul --as-printed --target i8088", "00000001 00008000", "00000001");
  expect_from_all("div --as-printed --target i386", "00020000 00030000", "0000aaaa");
  expect_from_all("div --as-printed --target i8088", "00020000 00030000", "0000aaab");
}

}  // namespace

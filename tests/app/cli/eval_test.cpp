// Tests the output of `fixproof eval` against words worked out by hand.
#include <fmt/format.h>

#include "tests/support/command.hpp"
#include "tests/support/test.hpp"
#include "tests/support/worked.hpp"

namespace {

/// Lines of input, each with its answer.
using Rows = std::vector<std::pair<std::string_view, std::string_view>>;

/// Expects the answers from every party and nothing on stderr.
void expect_from_all(std::string_view arguments, const Rows& rows,
                     const std::vector<std::string_view>& parties = {"model", "interpreter",
                                                                     "oracle", "fast", "type"}) {
  std::string lines;
  std::string answers;
  for (const auto& [line, answer] : rows) {
    lines += fmt::format("{}\n", line);
    answers += fmt::format("{}\n", answer);
  }
  for (const std::string_view party : parties) {
    EXPECT_EQ(command::output_of(fmt::format("eval {} --by {}", arguments, party), lines), answers)
        << arguments << " by " << party << ":\n"
        << lines;
  }
}

void expect_as_worked(std::string_view operation, std::span<const worked::Row> rows) {
  const auto expect = [&](std::string_view options, worked::Answer worked::Row::*answer) {
    std::vector<std::string> texts;
    texts.reserve(2 * rows.size());  // the views below stay valid
    Rows all;
    for (const worked::Row& row : rows) {
      const std::string& line = texts.emplace_back(fmt::format("{:08x} {:08x}", row.a, row.b));
      const auto& word = row.*answer;
      all.emplace_back(line, texts.emplace_back(word ? fmt::format("{:08x}", *word) : "DE"));
    }
    expect_from_all(fmt::format("{} {}", operation, options), all);
  };
  expect("--target i386 --round on", &worked::Row::i386_on);
  expect("--target i386 --round off", &worked::Row::i386_off);
  expect("--target i8088 --round on", &worked::Row::i8088_on);
  expect("--target i8088 --round off", &worked::Row::i8088_off);
}

TEST(EvalMul, AsWorkedByHand) { expect_as_worked("mul", worked::products); }
TEST(EvalDiv, AsWorkedByHand) { expect_as_worked("div", worked::quotients); }

TEST(EvalCosSin, AxesAndFamiliarAngles) {
  for (const std::string_view target : {"i386", "i8088"}) {
    expect_from_all(fmt::format("cossin --target {}", target),
                    {{"0000", "00010000 00000000"},
                     {"0384", "00000000 00010000"},
                     {"0708", "ffff0000 00000000"},
                     {"0a8c", "00000000 ffff0000"},
                     {"0e10", "00010000 00000000"},
                     {"fc7c", "00000000 ffff0000"},   // -90.0
                     {"01c2", "0000b505 0000b505"},   // 45.0: 46340.95
                     {"012c", "0000ddb4 00008000"},   // 30.0: 56755.84
                     {"fe3e", "0000b505 ffff4afb"}},  // -45.0
                    {"model", "interpreter", "oracle", "type"});
  }
}

TEST(EvalXformVec, RotatesScalesAndMoves) {
  // Rows 0 -1 0 | 1,  1 0 0 | 2,  0 0 2 | -3 and the point (4, 5, 6).
  const std::string_view line =
      "00000000 ffff0000 00000000 00010000 00010000 00000000 00000000 00020000 "
      "00000000 00000000 00020000 fffd0000 00040000 00050000 00060000";
  for (const std::string_view options :
       {"i386 --round on", "i386 --round off", "i8088 --round on", "i8088 --round off"}) {
    expect_from_all(fmt::format("xformvec --target {}", options),
                    {{line, "fffc0000 00060000 00090000"}});
  }
}

TEST(EvalXformVec, RoundsEveryProductOnItsOwn) {
  // Three times minus half a unit in the first row, plus half a unit in the others.
  const std::string_view line =
      "00008000 00008000 00008000 00000000 ffff8000 ffff8000 ffff8000 00000000 "
      "ffff8000 00000000 00000000 00000000 ffffffff ffffffff ffffffff";
  expect_from_all("xformvec --target i386", {{line, "00000000 00000003 00000001"}});
  expect_from_all("xformvec --target i386 --round off", {{line, "fffffffd 00000000 00000000"}});
  expect_from_all("xformvec --target i8088", {{line, "fffffffd 00000003 00000001"}});
  expect_from_all("xformvec --target i8088 --round off", {{line, "00000000 00000000 00000000"}});
}

// The identity with a translation, twice: by (1, 2, 3), then by (4, 5, 6).
constexpr std::string_view two_moves =
    "00010000 00000000 00000000 00010000 00000000 00010000 00000000 00020000 "
    "00000000 00000000 00010000 00030000 00010000 00000000 00000000 00040000 "
    "00000000 00010000 00000000 00050000 00000000 00000000 00010000 00060000";
constexpr std::string_view both_moves =
    "00010000 00000000 00000000 00050000 00000000 00010000 00000000 00070000 "
    "00000000 00000000 00010000 00090000";

TEST(EvalConcat, AddsTheTranslationInTheFourthColumn) {
  for (const std::string_view target : {"i386", "i8088"}) {
    expect_from_all(fmt::format("concat --target {}", target), {{two_moves, both_moves}});
  }
}

// A translation along z by 0.5 after one by `second`.
TEST(EvalConcat, The8088LosesTheCarryOfTheTranslation) {
  const auto moved = [](std::string_view by) {
    return fmt::format(
        "00010000 00000000 00000000 00000000 00000000 00010000 00000000 00000000 "
        "00000000 00000000 00010000 {}",
        by);
  };
  for (const std::string_view round : {"on", "off"}) {
    const auto expect = [&](std::string_view options, std::string_view second,
                            std::string_view by) {
      expect_from_all(fmt::format("concat --round {} --target {}", round, options),
                      {{moved("00008000 ") + moved(second), moved(by)}});
    };
    expect("i8088", "00008000", "00000000");
    expect("i8088 --repaired", "00008000", "00010000");
    expect("i386", "00008000", "00010000");
    expect("i8088", "00018000", "00010000");
    expect("i8088 --repaired", "00018000", "00020000");
    expect("i8088", "00007fff", "0000ffff");
  }
}

TEST(EvalChapter52, AddsTheTranslationInEveryColumn) {
  expect_from_all("concat --chapter 52",
                  {{two_moves,
                    "00020000 00010000 00010000 00050000 00020000 00030000 00020000 00070000 "
                    "00030000 00030000 00040000 00090000"}});
}

TEST(EvalChapter52, HasOnlyRounded386Routines) {
  expect_from_all("div --chapter 52", {{"00020000 00030000", "0000aaab"}});
  expect_from_all("mul --chapter 52", {{"ffffffff 00008000", "00000000"}});
  for (const std::string_view other : {"--target i8088", "--round off", "--div-round off"}) {
    command::expect_refused(fmt::format("eval div --chapter 52 {}", other),
                            "--chapter 52 has only mul, div and concat, for i386, rounded; use "
                            "--chapter 54\n");
  }
}

TEST(EvalType, WhatIsNoRoutine) {
  const auto expect = [](std::string_view operation, const Rows& rows) {
    for (const auto& [word, answer] : rows) {
      for (const std::string_view by : {"", " --by oracle", " --by fast", " --by type"}) {
        EXPECT_EQ(command::output_of(fmt::format("eval {}{}", operation, by), word),
                  fmt::format("{}\n", answer))
            << operation << by << ' ' << word;
      }
    }
  };
  expect("sqrt", {{"00020000", "00016a0a"}});                           // 92681.90
  expect("sin", {{"00010000", "0000d76b"}, {"80000000", "ffff1278"}});  // 55146.64, -60807.99
  expect("cos", {{"00010000", "00008a51"}, {"00000000", "00010000"}});  // 35409.25
  expect("add", {{"00018000 0000c000", "00024000"}, {"7fffffff 00000001", "80000000"}});
  expect("sub", {{"00018000 0001c000", "ffffc000"}, {"80000000 00000001", "7fffffff"}});
  expect("decimal", {{"80000001", "80000001"}});
  expect("binary64", {{"7fffffff", "7fffffff"}});
  expect("exp", {{"00010000", "0002b7e1"}, {"7fffffff", "7fffffff"}});   // 178145.3
  expect("exp2", {{"fffd0000", "00002000"}, {"ffef0000", "00000001"}});  // a tie
  expect("log", {{"000a0000", "00024d76"}, {"00000000", "80000000"}});   // 150902.2
  expect("log2", {{"00002000", "fffd0000"}});
  expect("log10", {{"03e80000", "00030000"}});
}

TEST(EvalType, RemaindersQuotientsOfProductsAndLengths) {
  const auto expect = [](std::string_view operation, const Rows& rows) {
    expect_from_all(operation, rows, {"oracle", "fast", "type"});
  };
  expect("fmod", {{"00058000 00020000", "00018000"},  // 5.5 and -5.5, by 2
                  {"fffa8000 00020000", "fffe8000"},
                  {"80000000 ffffffff", "00000000"},
                  {"00010000 00000000", "DE"}});
  // Of 4.75 and 1.25 quotients, 5 is nearest; 1.5 and 2.5 go to 2.
  expect("remainder", {{"00098000 00020000", "ffff8000"},
                       {"00030000 00020000", "ffff0000"},
                       {"00050000 00020000", "00010000"},
                       {"00000000 00000000", "DE"}});
  // 3 * 5 / 4, 30000 * 20000 / 25000, -3.5 ulps, an overflow, and 1 / 0
  expect("mul_div", {{"00030000 00050000 00040000", "0003c000"},
                     {"75300000 4e200000 61a80000", "5dc00000"},
                     {"00000007 00000003 fffffffa", "fffffffd"},
                     {"80000000 00000001 ffffffff", "80000000"},
                     {"00010000 00010000 00000000", "DE"}});
  expect("hypot3",
         {{"00020000 fffd0000 00060000", "00070000"}, {"80000000 80000000 80000000", "7fffffff"}});
  expect("fmod --format u8_8", {{"ffff 8001", "7ffe"}});
  expect("mul_div --format q4_4", {{"80 80 81", "7f"}});
  command::expect_refused("eval remainder --format u8_8",
                          "remainder has signed formats, which u8_8 is not");
}

TEST(EvalOptions, EachRoundingAppliesToItsOwnRoutine) {
  expect_from_all("mul --mul-round off --div-round on", {{"ffffffff 00008000", "ffffffff"}});
  expect_from_all("mul --mul-round on --div-round off", {{"ffffffff 00008000", "00000000"}});
  expect_from_all("div --mul-round off --div-round on", {{"00020000 00030000", "0000aaab"}});
  expect_from_all("div --mul-round on --div-round off", {{"00020000 00030000", "0000aaaa"}});
  // The products inside XformVec are multiplies.
  expect_from_all("concat --mul-round on --div-round off", {{two_moves, both_moves}});
}

TEST(EvalOptions, WithoutOptionsTheModelOfThe386Rounds) {
  EXPECT_EQ(command::output_of("eval mul", "ffffffff 00008000\n"), "00000000\n");
  EXPECT_EQ(command::output_of("eval div", "00020000 00030000\n"), "0000aaab\n");
}

// The 8088 divide inverts its switch; without a switch, the printed one applies.
TEST(EvalAsPrinted, TakesTheSwitchesOfTheListing) {
  const auto expect = [](std::string_view form, std::string_view line, std::string_view answer) {
    expect_from_all(fmt::format("{} --as-printed", form), {{line, answer}});
  };
  const std::string_view two_thirds = "00020000 00030000";
  expect("div --target i8088 --round on", two_thirds, "0000aaaa");
  expect("div --target i8088 --div-round off", two_thirds, "0000aaab");
  expect("div --target i8088", two_thirds, "0000aaab");
  expect("div --target i386 --round on", two_thirds, "0000aaab");
  expect("div --target i386 --round off", two_thirds, "0000aaaa");
  expect("div --target i386", two_thirds, "0000aaaa");
  const std::string_view half_a_unit = "00000001 00008000";
  expect("mul --target i8088 --round on", half_a_unit, "00000001");
  expect("mul --target i8088 --round off", half_a_unit, "00000000");
  expect("mul --target i8088", half_a_unit, "00000001");
  expect("mul --target i386", half_a_unit, "00000001");
}

}  // namespace

// Tests `fixproof check --json` and `--rounding best` as a program uses them.
#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "support/strict_json.hpp"
#include "tests/support/command.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

/// 1.5 * 2.5, -1 ulp * 0.5 and 256.0 * 128.0, which overflows.
constexpr std::string_view three_cases =
    "00018000 00028000\nffffffff 00008000\n01000000 00800000\n";

command::Run check_three(std::string_view options, std::string_view results) {
  const ScratchFolder folder;
  return command::fixproof(
      fmt::format("check mul --from {} {}", folder.write("cases", three_cases), options), results);
}

TEST(CheckJson, HasTheFiguresOfTheText) {
  const std::string results = "0003c000\nffffffff\nDE\n";
  const auto run = check_three("--rounding half-up --overflow any --json -", results);
  EXPECT_EQ(run.status, 1) << run.err;
  const auto json = fixproof::support::parse_strictly(run.out);
  EXPECT_EQ(json["operation"], "mul");
  EXPECT_EQ(json["format"], "q16_16");
  EXPECT_EQ(json["to"], "q16_16");
  EXPECT_EQ(json["right"], false);
  EXPECT_EQ(json["complete"], true);
  EXPECT_EQ(json["cases"], 3);
  EXPECT_EQ(json["wrong"], 1);
  EXPECT_EQ(json["not_judged"], 1);
  EXPECT_EQ(json["rounding"]["best"], "half-away");
  EXPECT_EQ(json["rounding"]["cases"], 2);
  EXPECT_EQ(json["rounding"]["exceptions"], 0);
  ASSERT_EQ(json["examples"].size(), 1U);
  const auto& example = json["examples"][0];
  EXPECT_EQ(example["case"], 2);
  EXPECT_EQ(example["operands"], "ffffffff 00008000");
  EXPECT_EQ(example["expected"], "00000000");
  EXPECT_EQ(example["said"], "ffffffff");
  EXPECT_EQ(example["kind"], "tie");
  const std::string text = json["text"];
  EXPECT_NE(text.find(std::string(example["text"])), std::string::npos) << text;
}

TEST(CheckJson, AFileComesBesidesTheText) {
  const ScratchFolder folder;
  const std::string cases = folder.write("cases", three_cases);
  const std::string file = folder.path("verdict.json");
  const std::string results = "0003c000\nffffffff\n80000000\n";
  const auto run = command::fixproof(
      fmt::format("check mul --from {} --rounding floor --json {}", cases, file), results);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(fixproof::support::parse_strictly(folder.read("verdict.json"))["text"], run.out);
  command::expect_refused(fmt::format("check mul --from {0} --rounding floor --json {0}", cases),
                          "this is also a file that check reads; name another file");
}

TEST(CheckJson, ThereIsNoneOfResultsThatAreNone) {
  const auto run = check_three("--rounding floor --json -", "0003c000\nx\n");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, "");
  command::expect_contains(run.err, "line 2");
}

// Half of 1, 3, -1 and -3 ulps, and a quarter of 1 and -1.
TEST(CheckBest, JudgesByTheRoundingThatFits) {
  const std::string one = "00000001\n";
  const std::string two = "00000002\n";
  const std::string zero = "00000000\n";
  const std::string minus_one = "ffffffff\n";
  const std::string minus_two = "fffffffe\n";
  const std::vector<std::pair<std::string, std::string>> said = {
      {"half-up", one + two + zero + minus_one + zero + zero},
      {"half-away", one + two + minus_one + minus_two + zero + zero},
      {"half-even", zero + two + zero + minus_two + zero + zero},
      {"floor", zero + one + minus_one + minus_two + zero + minus_one},
      {"ceiling", one + two + zero + minus_one + one + zero},
      {"toward-zero", zero + one + zero + minus_one + zero + zero}};
  const ScratchFolder folder;
  const std::string cases = folder.write("cases",
                                         "00000001 00008000\n00000003 00008000\n"
                                         "ffffffff 00008000\nfffffffd 00008000\n"
                                         "00000001 00004000\nffffffff 00004000\n");
  for (const auto& [rounding, results] : said) {
    const auto piped = command::fixproof("check mul --rounding best --from " + cases, results);
    EXPECT_EQ(piped.status, 0) << piped.out << piped.err;
    EXPECT_TRUE(piped.out.starts_with(fmt::format("mul: {}, overflow wrap", rounding)))
        << piped.out;
    const auto from_file = command::fixproof(fmt::format("check mul {} --rounding best --from {}",
                                                         folder.write("results", results), cases));
    EXPECT_EQ(from_file.out, piped.out) << from_file.err;
  }
}

TEST(CheckBest, IsTakenWhereNothingIsRounded) {
  const std::string answers =
      command::output_of("eval add", command::output_of("gen add --cases 500"));
  const auto run = command::fixproof("check add --cases 500 --rounding best --json -", answers);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(fixproof::support::parse_strictly(run.out)["rounding"].is_null()) << run.out;
}

TEST(CheckBest, ReadsTheCasesTwice) {
  command::expect_refused("check mul --rounding best --from /dev/null",
                          "--rounding best reads the cases twice; name a regular file");
}

}  // namespace

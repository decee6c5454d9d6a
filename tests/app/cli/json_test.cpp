// Tests --json: the figures are those of cases worked out by hand, or of the text of the same run.
#include <fmt/format.h>

#include <regex>
#include <string>
#include <vector>

#include "support/strict_json.hpp"
#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

/// A run with `--json -`: the JSON alone is on standard output, the text on standard error.
struct JsonRun {
  nlohmann::json json;
  std::string text;
};

JsonRun run_json(std::vector<std::string> words, int status) {
  words.insert(words.begin(), paths::command());
  words.insert(words.end(), {"--json", "-"});
  const auto run = command::run(words);
  EXPECT_EQ(run.status, status) << run.err;
  EXPECT_NE(run.err, "");
  return {fixproof::support::parse_strictly(run.out), run.err};
}

/// The number before some words of a text, as in `1,039 cases`.
std::uint64_t number_before(const std::string& words, const std::string& text) {
  std::smatch found;
  EXPECT_TRUE(std::regex_search(text, found, std::regex("([0-9,]+) " + words))) << text;
  std::string digits = found[1];
  std::erase(digits, ',');
  return std::stoull(digits);
}

TEST(Json, BeginsWithVersionCommandAndStatus) {
  const std::string version = command::output_of("--version");
  const auto run = run_json({"verify", "mul", "--case", "00018000 00028000"}, 0);
  EXPECT_EQ(run.json["fixproof"].get<std::string>() + '\n', version);
  EXPECT_EQ(run.json["command"], "verify");
  EXPECT_EQ(run.json["status"], "ok");
}

// 1.5 * 2.5 = 3.75, and nothing divides by zero.
TEST(Json, VerifyHasTheAnswerOfEachParty) {
  const auto product = run_json({"verify", "mul", "--case", "1.5 2.5"}, 0).json["asked"];
  ASSERT_FALSE(product.empty());
  for (const auto& row : product) {
    EXPECT_EQ(row["operands"], "00018000 00028000");
    EXPECT_EQ(row["values"], "1.5 2.5");
    EXPECT_EQ(row["equal"], true);
    EXPECT_GE(row["answers"].size(), 2U);
    for (const auto& answer : row["answers"]) EXPECT_EQ(answer, "0003c000");
  }
  const auto quotient = run_json({"verify", "div", "--case", "1.0 0.0"}, 0).json["asked"];
  ASSERT_FALSE(quotient.empty());
  for (const auto& row : quotient) {
    for (const auto& answer : row["answers"]) EXPECT_EQ(answer, "DE");
  }
}

TEST(Json, MergeAddsUpWhatShardsOfVerifyHave) {
  const ScratchFolder folder;
  std::uint64_t cases = 0;
  for (const char* shard : {"1", "2"}) {
    const auto run = run_json(
        {"verify", "sqrt", "--shard", fmt::format("{}/2", shard), "--report", folder.path(shard)},
        0);
    EXPECT_EQ(run.json["shard"]["count"], 2);
    EXPECT_EQ(run.json["cases"], number_before("cases compared", run.text));
    EXPECT_EQ(run.json["mismatches"], 0);
    EXPECT_EQ(run.json["complete"], true);
    cases += run.json["cases"].get<std::uint64_t>();
  }
  const auto sum = run_json({"merge", folder.path("1"), folder.path("2")}, 0);
  EXPECT_EQ(sum.json["command"], "merge");
  EXPECT_EQ(sum.json["cases"], cases);
  const auto half = run_json({"merge", folder.path("1")}, 2);
  EXPECT_EQ(half.json["status"], "undecided");
  EXPECT_EQ(half.json["complete"], false);
}

TEST(Json, ProveHasTheCounterexampleOfTheText) {
  const auto run =
      run_json({"prove", "div", "--target", "i8088", "--round", "on", "--mutant", "3"}, 1);
  EXPECT_EQ(run.json["command"], "prove");
  EXPECT_EQ(run.json["status"], "wrong");
  const auto& counts = run.json["counts"];
  EXPECT_EQ(counts["proven"], number_before("proven", run.text));
  EXPECT_EQ(counts["disproven"], 1);
  const auto& goal = run.json["goals"].back();
  EXPECT_EQ(goal["standing"], "disproven");
  const auto& example = goal["counterexample"];
  command::expect_contains(
      run.text,
      fmt::format("  {}: the program {}, the oracle {}\n  replay: {}\n",
                  example["operands"].get<std::string>(), example["program"].get<std::string>(),
                  example["oracle"].get<std::string>(), example["replay"].get<std::string>()));
}

// A program that says 0 to everything.
TEST(Json, JudgeHasTheJudgementOfAProgram) {
  const auto run = run_json({"judge", "--run", "sed s/.*/00000000/", "--as", "mul", "--rounding",
                             "floor", "--cases", "50"},
                            1);
  EXPECT_EQ(run.json["status"], "wrong");
  EXPECT_EQ(run.json["subject"], "program");
  EXPECT_EQ(run.json["cases"], 50);
  EXPECT_EQ(run.json["defects"], nlohmann::json::array());
  const auto& judgement = run.json["judgement"];
  EXPECT_EQ(judgement["cases"], 50);
  EXPECT_EQ(judgement["wrong"], number_before("of 50 cases", run.text));
  EXPECT_EQ(run.json["smallest"]["said"], "00000000");
  command::expect_contains(
      run.text, fmt::format("smallest: {} (", std::string(run.json["smallest"]["operands"])));
}

TEST(Json, JudgeNamesWhatBreaks) {
  const auto run = run_json({"judge", "--run", "exit 3", "--as", "mul"}, 1);
  EXPECT_EQ(run.json["complete"], false);
  EXPECT_TRUE(run.json["judgement"].is_null());
  ASSERT_EQ(run.json["defects"].size(), 1U);
  EXPECT_EQ(run.json["defects"][0]["kind"], "broken");
  command::expect_contains(std::string(run.json["defects"][0]["text"]), "status 3");
}

TEST(Json, StepCountsTheCapturedCases) {
  const std::string file = paths::source("tests/verify/vectors/8088.json");
  const auto run = run_json({"step", "--cpu", "8088", "--singlestep", file}, 0);
  EXPECT_EQ(run.json["run"], number_before("run", run.text));
  EXPECT_EQ(run.json["equal"], run.json["run"]);
  std::uint64_t skipped = 0;
  for (const auto& count : run.json["skipped"]) skipped += count.get<std::uint64_t>();
  EXPECT_EQ(skipped, number_before("skipped", run.text));
}

TEST(Json, StepNamesAFileThatIsNone) {
  const auto run = run_json({"step", "--singlestep", "no_such_file"}, 2);
  EXPECT_EQ(run.json["status"], "undecided");
  command::expect_contains(std::string(run.json["files"][0]["error"]), "no_such_file");
}

TEST(Json, MutateCountsWhatTheTextCounts) {
  const auto run =
      run_json({"mutate", "mul", "--target", "i386", "--round", "on", "--chapter", "52"}, 0);
  EXPECT_EQ(run.json["killed"], number_before("of [0-9]+ mutants that are not", run.text));
  EXPECT_EQ(run.json["gaps"], 0);
  EXPECT_EQ(run.json["mutants"], run.json["programs"][0]["mutants"]);
}

TEST(Json, RenderAndMeasurementsBeginAlike) {
  const std::string scene = paths::scene("solid.json");
  const auto render = run_json({"render", scene, "--frames", "2"}, 0);
  EXPECT_EQ(render.json["frames"], 2);
  EXPECT_EQ(render.json["status"], "ok");
  const auto profile = run_json({"profile", scene, "--frames", "1"}, 0);
  EXPECT_EQ(profile.json["command"], "profile");
  EXPECT_EQ(profile.json["made"]["command"], "profile");
}

TEST(Json, AFileComesBesidesTheText) {
  const ScratchFolder folder;
  const std::string file = folder.path("out.json");
  const auto run = command::fixproof("verify sqrt --json " + file);
  command::expect_contains(run.out, "All parties agree on every case.");
  const auto json = fixproof::support::parse_strictly(folder.read("out.json"));
  EXPECT_EQ(json["cases"], number_before("cases compared", run.out));
}

TEST(Json, AnErrorWritesNothing) {
  for (const std::string_view words :
       {"verify mull", "prove mul --solver none", "judge no_such_file --as mul",
        "desync no_such_file other", "mutate mul --solver none", "merge no_such_file",
        "drift no_such_file"}) {
    const auto run = command::fixproof(fmt::format("{} --json -", words));
    EXPECT_EQ(run.status, 2) << words;
    EXPECT_EQ(run.out, "") << words;
  }
}

TEST(Json, IsNoFileOfAnotherOption) {
  const ScratchFolder folder;
  const std::string file = folder.write("file", "");
  const std::string scene = folder.write("scene.json", "{}");
  for (const std::string& words : {fmt::format("verify mul --report {0} --json {0}", file),
                                   fmt::format("judge {0}:mul --as mul --json {0}", file),
                                   fmt::format("desync {0} other --json {0}", file),
                                   fmt::format("merge {0} --json {0}", file)}) {
    command::expect_refused(words, "name another");
  }
  EXPECT_EQ(folder.read("file"), "");
  command::expect_refused("step --json -", "--json requires --singlestep");
  command::expect_refused("prove mul --write w --json -", "--write excludes --json");
}

}  // namespace

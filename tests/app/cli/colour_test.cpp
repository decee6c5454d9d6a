// Tests the colours of verdicts, where they are wanted.
#include <cstdlib>
#include <initializer_list>
#include <string>
#include <vector>

#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"

namespace {

/// Runs the command with these variables set.
command::Run run_with(std::initializer_list<std::string> variables,
                      std::vector<std::string> words) {
  std::vector<std::string> all{"env", "-u", "NO_COLOR", "-u", "CLICOLOR_FORCE"};
  all.insert(all.end(), variables);
  all.push_back(paths::command());
  all.insert(all.end(), words.begin(), words.end());
  return command::run(all);
}

const std::vector<std::string> judge_zeros{
    "judge", "--run", "sed s/.*/00000000/", "--as", "mul", "--rounding", "floor", "--cases", "50"};

TEST(Colour, IsForcedOutsideOfATerminal) {
  const auto run = run_with({"CLICOLOR_FORCE=1"}, judge_zeros);
  EXPECT_EQ(run.status, 1);
  command::expect_contains(run.out, "\n\x1b[31mWRONG\x1b[0m in ");
  command::expect_contains(run_with({"CLICOLOR_FORCE=1"}, {"verify", "sqrt"}).out,
                           "  \x1b[32mequal\x1b[0m\n");
}

TEST(Colour, IsInNoPipe) {
  for (const auto& run :
       {run_with({}, judge_zeros), run_with({"NO_COLOR=1", "CLICOLOR_FORCE=1"}, judge_zeros),
        run_with({"CLICOLOR_FORCE=0"}, judge_zeros)}) {
    EXPECT_EQ(run.out.find('\x1b'), std::string::npos) << run.out;
    command::expect_contains(run.out, "\nWRONG in ");
  }
}

// Help explains the verdicts, and JSON is for programs.
TEST(Colour, IsNotInHelpOrJson) {
  EXPECT_EQ(run_with({"CLICOLOR_FORCE=1"}, {"judge", "--help"}).out.find('\x1b'),
            std::string::npos);
  auto words = judge_zeros;
  words.insert(words.end(), {"--json", "-"});
  EXPECT_EQ(run_with({"CLICOLOR_FORCE=1"}, words).out.find('\x1b'), std::string::npos);
}

TEST(Help, FitsTheWidthOfTheTerminal) {
  const std::string wide = command::output_of("eval --help");
  const auto narrow = run_with({"COLUMNS=80"}, {"eval", "--help"});
  std::size_t continued = 0;
  for (const std::string& line : command::split(narrow.out, '\n')) {
    if (!line.starts_with(std::string(30, ' '))) continue;
    ++continued;
    EXPECT_LE(line.size(), 80U) << line;
  }
  EXPECT_GT(continued, 0U);
  EXPECT_NE(narrow.out, wide);
  // No word is lost.
  const auto words = [](std::string text) {
    std::erase(text, ' ');
    std::erase(text, '\n');
    return text;
  };
  EXPECT_EQ(words(narrow.out), words(wide));
}

}  // namespace

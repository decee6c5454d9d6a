// Tests the input of `fixproof eval`: lines that it skips, and lines that it rejects by number.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tests/cli/command.hpp"
#include "tests/cli/draw.hpp"

namespace {

using namespace std::string_literals;

constexpr std::string_view good = "00018000 00028000\n";
constexpr std::string_view answered = "0003c000\n";

void expect_one_line(const std::string& err) {
  ASSERT_FALSE(err.empty());
  EXPECT_EQ(err.find('\n'), err.size() - 1) << err;
}

/// Puts `bad` after two valid lines. Expects both answers, then an error with its line number.
void expect_refused(const std::string& bad, std::string_view arguments = "eval mul") {
  const auto run = command::fixproof(arguments, fmt::format("{0}{0}{1}\n{0}", good, bad));
  EXPECT_EQ(run.status, 2) << bad;
  EXPECT_EQ(run.out, fmt::format("{0}{0}", answered)) << bad;
  EXPECT_EQ(run.err.rfind("fixproof: line 3: ", 0), 0) << run.err;
  expect_one_line(run.err);
  EXPECT_LT(run.err.size(), 200);
}

TEST(EvalInput, PassesOverBlankLinesAndComments) {
  const auto run = command::fixproof("eval mul", fmt::format("\n# {0}{0}\n   \n\t\n#\n{0}", good));
  EXPECT_EQ(run.out, fmt::format("{0}{0}", answered));
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.status, 0);
}

TEST(EvalInput, PassedOverLinesCount) {
  const auto run = command::fixproof("eval mul", fmt::format("\n# comment\n{}wrong\n", good));
  EXPECT_EQ(run.out, answered);
  EXPECT_EQ(run.err.rfind("fixproof: line 4: ", 0), 0) << run.err;
}

TEST(EvalInput, NothingIsNothing) {
  const auto run = command::fixproof("eval mul", "");
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.status, 0);
}

TEST(EvalInput, TheLastLineNeedsNoNewline) {
  const auto run = command::fixproof("eval mul", good.substr(0, good.size() - 1));
  EXPECT_EQ(run.out, answered);
  EXPECT_EQ(run.status, 0);
}

TEST(EvalInput, AnswersBeforeTheNextLineIsAsked) {
  command::Process process(command::command("eval div"));
  process.write("00010000 00030000\n");
  ASSERT_EQ(process.read_line(), "00005555");
  process.write("# nothing to answer\n00010000 00000000\n");
  ASSERT_EQ(process.read_line(), "DE");
  // An incomplete line must get no answer.
  process.write("00020000 ");
  process.write("00030000\n");
  ASSERT_EQ(process.read_line(), "0000aaab");
  const auto run = process.finish();
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.status, 0);
}

TEST(EvalInput, RefusesWhatIsNoWord) {
  expect_refused("0001800g 00028000");
  expect_refused("0x018000 00028000");
  expect_refused("-0018000 00028000");
  expect_refused("+0018000 00028000");
  expect_refused("0001.000 00028000");
}

TEST(EvalInput, RefusesUpperCase) { expect_refused("0001800A 00028000"); }

TEST(EvalInput, RefusesSevenAndNineDigits) {
  expect_refused("0018000 00028000");
  expect_refused("000018000 00028000");
  expect_refused("00018000 0028000");
  expect_refused("00018000 000028000");
}

TEST(EvalInput, RefusesMissingAndExtraWords) {
  expect_refused("00018000");
  expect_refused("00018000 ");
  expect_refused("00018000 00028000 00000000");
  expect_refused("00018000 00028000 ");
}

TEST(EvalInput, RefusesOtherSpacing) {
  expect_refused("00018000  00028000");
  expect_refused(" 00018000 00028000");
  expect_refused("00018000\t00028000");
  expect_refused("00018000,00028000");
}

TEST(EvalInput, TakesLinesOfEitherKind) {
  const auto run =
      command::fixproof("eval mul", "\r\n# c\r\n00018000 00028000\r\n00018000 00028000");
  EXPECT_EQ(run.out, fmt::format("{0}{0}", answered));
  EXPECT_EQ(run.err, "");
  expect_refused("00018000\r 00028000");
  expect_refused("00018000 00028000\r\r");
}

TEST(EvalInput, RefusesAHashAfterASpace) { expect_refused(" # comment"); }

TEST(EvalInput, RefusesBinaryNoise) {
  expect_refused("00018000 0002800\0"s);
  expect_refused("\0"s);
  expect_refused("\0\0\0\0\0\0\0\0 \0\0\0\0\0\0\0\0"s);
  expect_refused("\x1b[31m00018000 \x80\xff\xfe");
  command::Random random(1990);
  for (int i = 0; i < 50; ++i) {
    std::string noise(1 + random() % 300, '\0');
    for (char& c : noise) c = static_cast<char>(random());
    noise.front() = '\x01';
    expect_refused(command::split(noise, '\n').front());
  }
}

TEST(EvalInput, RefusesALineOfTenMegabytes) {
  expect_refused(command::repeated(10'000'000, '0'));
  expect_refused(command::repeated(10'000'000, ' ') + "0");
}

TEST(EvalInput, CountsTheWordsOfEachOperation) {
  const auto expect_message = [](std::string_view operation, std::string_view line,
                                 std::string_view message) {
    const auto run =
        command::fixproof(fmt::format("eval {}", operation), fmt::format("{}\n", line));
    EXPECT_EQ(run.err, fmt::format("fixproof: line 1: {}\n", message));
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.status, 2);
  };
  expect_message("div", "00018000", "div takes 2 words, separated by single spaces");
  expect_message("cossin", "0000 0000", "cossin takes 1 word, separated by single spaces");
  expect_message("xformvec", "00000000", "xformvec takes 15 words, separated by single spaces");
  expect_message("concat", "00000000", "concat takes 24 words, separated by single spaces");
  expect_message("cossin", "00000000", "'00000000' has 8 hex digits instead of 4");
}

TEST(EvalInput, QuotesForeignTextShortAndPrintable) {
  const auto run = command::fixproof("eval cossin", "\x1b]0;\x07" + std::string(3000, 'x') + "\n");
  EXPECT_EQ(run.err,
            "fixproof: line 1: '?]0;?" + std::string(35, 'x') + "...' is not lower-case hex\n");
}

TEST(EvalOutput, AFullDiskIsAnError) {
  const auto run = command::fixproof("eval mul", good, command::Output::full_device);
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, "fixproof: cannot write standard output\n");
}

TEST(EvalOutput, AReaderThatHasGoneIsAnError) {
  std::string many;
  for (int i = 0; i < 100'000; ++i) many += good;
  for (const std::string_view input : {good, std::string_view(many)}) {
    const auto run = command::fixproof("eval mul", input, command::Output::reader_gone);
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.err, "fixproof: cannot write standard output\n");
  }
}

}  // namespace

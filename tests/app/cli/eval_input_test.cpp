// Tests the input of `fixproof eval`: lines that it skips, and lines that it rejects by number.
#include <fmt/format.h>

#include "tests/app/cli/draw.hpp"
#include "tests/support/command.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace std::string_literals;

constexpr std::string_view good = "00018000 00028000\n";
constexpr std::string_view answered = "0003c000\n";

/// Puts `bad` after two valid lines. Expects both answers, then an error with its line number.
void expect_line_refused(const std::string& bad) {
  const auto run = command::fixproof("eval mul", fmt::format("{0}{0}{1}\n{0}", good, bad));
  EXPECT_EQ(run.out, fmt::format("{0}{0}", answered));
  command::expect_usage_error(run, "fixproof: line 3: ");
  EXPECT_LT(run.err.size(), 200);
}

TEST(EvalInput, PassesOverBlankLinesAndComments) {
  EXPECT_EQ(command::output_of("eval mul", fmt::format("\n# {0}{0}\n   \n\t\n#\n{0}", good)),
            fmt::format("{0}{0}", answered));
  EXPECT_EQ(command::output_of("eval mul", ""), "");
}

TEST(EvalInput, PassedOverLinesCount) {
  const auto run = command::fixproof("eval mul", fmt::format("\n# comment\n{}wrong\n", good));
  EXPECT_EQ(run.out, answered);
  command::expect_usage_error(run, "fixproof: line 4: ");
}

// The last line needs no newline.
TEST(EvalInput, TakesLinesOfEitherKind) {
  EXPECT_EQ(command::output_of("eval mul", good.substr(0, good.size() - 1)), answered);
  EXPECT_EQ(command::output_of("eval mul", "\r\n# c\r\n00018000 00028000\r\n00018000 00028000"),
            fmt::format("{0}{0}", answered));
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

TEST(EvalInput, RefusesLinesThatAreNoTwoWords) {
  for (const char* line :
       {"0001800g 00028000", "0x123456789 00028000", "1800a 00028000", "1.5.5 00028000",
        // out of range
        "32768 00028000", "-0x80000001 00028000",
        // seven and nine digits
        "0018000 00028000", "000018000 00028000", "00018000 0028000", "00018000 000028000",
        // missing and extra words
        "00018000", "00018000 ", "00018000 00028000 00000000",
        // carriage returns
        "00018000\r 00028000", "00018000 00028000\r\r",
        // a hash after a space
        " # comment"}) {
    expect_line_refused(line);
  }
}

// docs/formats.md has the rule. 6554 units are nearest to 0.1.
TEST(EvalInput, TakesNumbersAsPeopleWriteThem) {
  for (const char* line :
       {"1.5 2.5", "00018000  00028000 ", " 00018000\t00028000", "00018000,00028000",
        "0x18000 0x28000", "0001800A 00027fff", "0.015e2 +2.5", "-1.5 \u22122.5"}) {
    SCOPED_TRACE(line);
    const bool last_digit = std::string_view(line).starts_with("0001800A");
    EXPECT_EQ(command::output_of("eval mul", line), last_digit ? "0003c017\n" : answered);
  }
  EXPECT_EQ(command::output_of("eval add", "0.1 0"), "0000199a\n");
  EXPECT_EQ(command::output_of("eval cossin", "450\n01C2\n-3150"),
            "0000b505 0000b505\n0000b505 0000b505\n0000b505 0000b505\n");
  EXPECT_EQ(command::output_of("eval mul --format q4_4", "10 1.5"), "18\n");
  EXPECT_EQ(command::output_of("eval add --format q32_32", "0.5 1"), "0000000180000000\n");
}

TEST(EvalInput, RefusesBinaryNoise) {
  expect_line_refused("00018000 0002800\0"s);
  expect_line_refused("\0"s);
  expect_line_refused("\0\0\0\0\0\0\0\0 \0\0\0\0\0\0\0\0"s);
  expect_line_refused("\x1b[31m00018000 \x80\xff\xfe");
  command::Random random(1990);
  for (int i = 0; i < 50; ++i) {
    std::string noise(1 + random() % 300, '\0');
    for (char& c : noise) c = static_cast<char>(random());
    noise.front() = '\x01';
    expect_line_refused(command::split(noise, '\n').front());
  }
}

TEST(EvalInput, RefusesALineOfTenMegabytes) {
  expect_line_refused(std::string(10'000'000, '0'));
  expect_line_refused(std::string(10'000'000, ' ') + "0");
}

TEST(EvalInput, CountsTheWordsOfEachOperation) {
  const auto expect = [](std::string_view operation, std::string_view line,
                         std::string_view message) {
    command::expect_refused(fmt::format("eval {}", operation),
                            fmt::format("fixproof: line 1: {}\n", message), line);
  };
  expect("div", "00018000", "div takes 2 words, not 1");
  expect("cossin", "0000 0000", "cossin takes 1 word, not 2");
  expect("xformvec", "00000000", "xformvec takes 15 words, not 1");
  expect("concat", "00000000", "concat takes 24 words, not 1");
  expect("cossin", "00000384",
         "'00000384': a word has 4 hexadecimal digits, or fewer after 0x, and a decimal number has "
         "no 0 in front");
  expect("cossin", "0.5", "'0.5' is not a whole number");
  expect("mul", "1e5 1", "'1e5': out of range, q16_16 has -32768 to 32767.9999847412109375");
  expect("mul --format u0_8", "1 ff",
         "'1': out of range, u0_8 has 0 to 0.99609375; a word has 2 hexadecimal digits, or fewer "
         "after 0x");
}

TEST(EvalInput, QuotesForeignTextShortAndPrintable) {
  command::expect_refused(
      "eval cossin",
      "line 1: '?]0:?" + std::string(35, 'x') + "...': the number is longer than 100 characters\n",
      "\x1b]0:\x07" + std::string(3000, 'x') + "\n");
}

TEST(EvalOutput, CannotBeWritten) {
  std::string many;
  for (int i = 0; i < 100'000; ++i) many += good;
  command::expect_output_needed("eval mul", good);
  command::expect_output_needed("eval mul", many);
}

}  // namespace

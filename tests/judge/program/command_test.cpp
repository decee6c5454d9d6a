// Tests `fixproof judge --run` as a user runs it.
#include "tests/support/command.hpp"

#include <fmt/format.h>

#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"

namespace {

using command::expect_contains;
using command::expect_refused;
using command::expect_usage_error;

command::Run run_of(const std::string& program, const std::string& options) {
  std::vector<std::string> arguments{paths::command(), "judge", "--run", program};
  const std::vector<std::string> more = command::command(options);
  arguments.insert(arguments.end(), more.begin() + 1, more.end());
  return command::run(arguments);
}

std::string plain(const std::string& operation) {
  return paths::built("docs/examples/plain") + " " + operation;
}

TEST(RunCommand, AProgramThatAgrees) {
  const auto run = run_of(plain("mul"), "--as mul --cases 2000");
  EXPECT_EQ(run.status, 0) << run.err;
  expect_contains(run.out, "\nmul q16_16: floor, the rounding that fits best; overflow any\n");
  expect_contains(run.out, "\nAGREES on 2,000 cases\n");
}

// C's division rounds towards zero.
TEST(RunCommand, AProgramThatIsWrong) {
  const auto run = run_of(plain("div"), "--as div --rounding floor --no-result de --cases 2000");
  EXPECT_EQ(run.status, 1) << run.err;
  expect_contains(run.out, "\nWRONG in ");
  expect_contains(run.out, "\n  smallest: ");
  expect_contains(run.out, "  rounding         toward-zero on all ");
}

// Four more bits after the point are one more digit.
TEST(RunCommand, ResultsInAnotherFormat) {
  const auto run = run_of("awk '{ print \"0000000\" $1 \"0\" }'",
                          "--as convert --format u16_16 --to u20_20 --cases 2000");
  EXPECT_EQ(run.status, 0) << run.err;
  expect_contains(run.out, "\nconvert u16_16 to u20_20: exact");
  expect_contains(run.out, "\nAGREES on ");
}

TEST(RunCommand, SaysHowAProgramFails) {
  const auto dies = run_of("echo oops >&2; kill -8 $$", "--as mul --cases 2000");
  EXPECT_EQ(dies.status, 1);
  expect_contains(dies.out,
                  "), even alone, the program ends by signal 8 "
                  "(Floating point exception) without a result; it says 'oops'; read cases from "
                  "standard input, and write one line for each, DE where there is no result\n");
  // Of a traceback the last line says what is wrong, and however long it is.
  const auto raises = run_of(
      "{ echo 'Traceback (most recent call last):'; yes '  File \"mine.py\"' | head -n 2000; "
      "echo 'ValueError: 3'; echo; } >&2; exit 1",
      "--as mul --cases 2000");
  expect_contains(raises.out, "; it says 'ValueError: 3'; read cases");
  const auto few = run_of(plain("mul") + " | head -n 7", "--as mul --cases 2000");
  expect_contains(few.out,
                  " the program ends with status 0 without a result, after 7 results; read cases "
                  "up to the end of the input, and write one line for each\n");
  const auto none = run_of("echo Ready; " + plain("mul"), "--as mul --cases 2000");
  EXPECT_EQ(none.status, 1);
  expect_contains(none.out,
                  " the program writes no result: 'Ready' is not lower-case hex; a result is 8 "
                  "lower-case hex digits, or DE for a divide error; begin any other line with #\n");
  const auto hangs = run_of("exec sleep 60", "--as mul --cases 2000 --timeout 1");
  expect_contains(hangs.out, " the program neither reads nor writes any more, after 0 results; ");
  expect_usage_error(run_of("./no_such_program", "--as mul"), "the shell cannot run it: ");
}

TEST(RunCommand, AProgramThatKeepsSomething) {
  const auto run = run_of("awk '{ printf \"%08x\\n\", n++ % 251 }'", "--as mul --cases 50000");
  EXPECT_EQ(run.status, 1) << run.err;
  expect_contains(run.out,
                  " the result differs from run to run: the program keeps something from case to "
                  "case, or reads registers or memory that nothing sets\n");
}

TEST(RunCommand, RefusesOptionsWithoutEffect) {
  expect_refused("judge --as mul", "Name the file of a routine, or a program: --run");
  expect_refused("judge mine.o --run cat --as mul", "--run and a file both name what to judge");
  for (const char* option : {"--frame c", "--at 0", "--symbol f", "--bits 32", "--prove",
                             "--clocks", "--list", "--trace 0", "--against-listing mul"}) {
    const std::string_view text = option;
    expect_refused(fmt::format("judge --run cat --as mul {}", text),
                   text.substr(0, text.find(' ')));
  }
  expect_refused("judge mine.o --as mul --processes 2", "--processes requires --run");
  expect_refused("judge mine.o --as mul --timeout 3", "--timeout requires --prove or --run");
  expect_refused("judge --run cat", "name with --as what the program computes");
  expect_refused("judge --run cat --as ?", "name with --as what the program computes");
  expect_refused("judge --run cat --as cossin", "choose an operation of check");
  expect_refused("judge --run cat --as mul --to q8_8 --shard 9/9000000", "this part has no cases");
}

}  // namespace

// Tests `program::judge_program` on programs with planted defects.
#include "judge/program/verdict.hpp"

#include <fmt/format.h>

#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"

namespace {

namespace check = fixproof::check;
namespace cases = fixproof::cases;
using fixproof::program::Fault;
using fixproof::program::Verdict;
using fixproof::program::VerdictOptions;
using oracle::Rounding;

/// C's multiply, which rounds down and wraps.
std::string multiply() { return paths::built("docs/examples/plain") + " mul"; }

VerdictOptions options_for(const std::string& command, std::uint64_t count) {
  VerdictOptions options{
      .command = command,
      .rules = {.variant = cases::variant_of(cases::Operation::mul, cases::q16_16),
                .overflow = check::Overflow::any},
      .rounding_is_open = true};
  options.cases.cases = count;
  return options;
}

Verdict verdict_on(const std::string& command, std::uint64_t count = 3000) {
  return fixproof::program::judge_program(options_for(command, count));
}

TEST(ProgramVerdict, FindsTheRounding) {
  const Verdict verdict = verdict_on(multiply());
  EXPECT_TRUE(verdict.is_right());
  EXPECT_EQ(verdict.rules.rounding, Rounding::floor);
  EXPECT_EQ(verdict.judge->cases(), 3000U);
}

TEST(ProgramVerdict, IsTheSameOnAnyNumberOfProcesses) {
  const std::string wrong = multiply() + " | sed 's/^0000000[1-7]$/00000000/'";
  VerdictOptions options = options_for(wrong, 50'000);
  std::optional<Verdict> one;
  for (const std::size_t processes : {1U, 2U, 5U}) {
    options.processes = processes;
    const Verdict verdict = fixproof::program::judge_program(options);
    EXPECT_EQ(verdict.processes, processes);
    ASSERT_TRUE(verdict.judge && verdict.smallest && !verdict.unsteady);
    EXPECT_EQ(verdict.judge->cases(), 50'000U);
    EXPECT_GT(verdict.judge->wrong(), 0U);
    if (!one) one.emplace(verdict);
    EXPECT_EQ(verdict.judge->wrong(), one->judge->wrong());
    EXPECT_EQ(verdict.smallest->number, one->smallest->number);
    ASSERT_EQ(verdict.judge->shown().size(), one->judge->shown().size());
    EXPECT_EQ(verdict.judge->shown().back().number, one->judge->shown().back().number);
  }
}

/// A program that prints all results at its end. So none of them tells which case came last.
std::string buffered(const std::string& body) {
  return "awk '" + body + " { all = all \"00000000\\n\" } END { printf \"%s\", all }'";
}

TEST(ProgramVerdict, NamesTheCaseThatEndsTheProgram) {
  const std::string dies =
      buffered(R"($2 ~ /^c/ { system("kill -9 $PPID"); fflush(); while (1); })");
  const Verdict verdict = verdict_on(dies);
  ASSERT_TRUE(verdict.failure && verdict.failure->at && verdict.failure->fault);
  EXPECT_TRUE(verdict.failure->is_alone);
  EXPECT_EQ(verdict.failure->at->words[1] >> 28U, 0xCU);
  ASSERT_TRUE(verdict.failure->fault->ending);
  EXPECT_EQ(verdict.failure->fault->ending->signal, 9);
}

TEST(ProgramVerdict, NamesTheCaseWithoutALine) {
  const Verdict verdict = verdict_on(buffered(R"($2 ~ /^c/ { next })"));
  ASSERT_TRUE(verdict.failure && verdict.failure->at);
  EXPECT_TRUE(verdict.failure->is_alone);
  EXPECT_EQ(verdict.failure->at->words[1] >> 28U, 0xCU);
}

TEST(ProgramVerdict, NamesTheCaseWithTwoLines) {
  const Verdict verdict = verdict_on(buffered(R"($2 ~ /^c/ { all = all "00000000\n" })"));
  ASSERT_TRUE(verdict.failure && verdict.failure->at);
  EXPECT_EQ(verdict.failure->fault->kind, Fault::Kind::too_many);
  EXPECT_TRUE(verdict.failure->is_alone);
  EXPECT_EQ(verdict.failure->at->words[1] >> 28U, 0xCU);
}

// No case is to blame for it.
TEST(ProgramVerdict, AProgramThatStopsAfterManyCases) {
  const Verdict verdict = verdict_on(multiply() + " | head -n 2500");
  ASSERT_TRUE(verdict.failure && verdict.failure->at);
  EXPECT_FALSE(verdict.failure->is_alone);
  EXPECT_EQ(verdict.failure->results, 2500U);
}

// The line that is no result explains that there are too many.
TEST(ProgramVerdict, AGreeting) {
  const Verdict verdict = verdict_on("echo Ready; " + multiply());
  ASSERT_TRUE(verdict.failure && verdict.failure->at);
  EXPECT_FALSE(verdict.failure->fault);
  EXPECT_NE(verdict.failure->defect.find("'Ready' is not"), std::string::npos);
  EXPECT_EQ(verdict.failure->at->number, 1U);
}

TEST(ProgramVerdict, AProgramThatKeepsSomething) {
  VerdictOptions options = options_for("awk '{ printf \"%08x\\n\", n++ % 251 }'", 50'000);
  EXPECT_TRUE(fixproof::program::judge_program(options).unsteady);
}

}  // namespace

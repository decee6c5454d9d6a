// Verdicts on the cases so far, after an interrupt, and on a machine that is busy.
#include <signal.h>  // NOLINT(modernize-deprecated-headers): kill() is POSIX's

#include <csignal>
#include <fstream>

#include "judge/code/frame.hpp"
#include "judge/code/load.hpp"
#include "judge/code/verdict.hpp"
#include "support/interrupt.hpp"
#include "tests/judge/code/judged.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace stopped_test {

namespace {

using namespace fixproof;
using judged::routine;

/// Judges a routine of two registers, and stops it when its first cases have run.
judge::Verdict stopped_early(const std::string& name, bool at_once = false) {
  const support::Interrupt interrupt;
  const judge::Image image = judge::load(routine(name), {.bits = 32});
  const cases::Variant product{};
  const judge::Subject subject{image, judge::frame_for(image, "eax, ebx -> eax", product), product};
  judge::VerdictOptions options{.rules = {.variant = product}};
  options.rules.rounding = oracle::Rounding::half_up;
  options.rounding_is_open = at_once;
  if (at_once) {
    (void)std::raise(SIGINT);
  } else {
    options.progress = [](std::uint64_t, std::uint64_t) { (void)std::raise(SIGINT); };
  }
  return judge::judge_routine(subject, options);
}

TEST(Stopped, ARightRoutineHasAVerdictOnTheCasesSoFar) {
  const judge::Verdict verdict = stopped_early("mul");
  EXPECT_TRUE(verdict.is_stopped);
  EXPECT_TRUE(verdict.is_right());
  EXPECT_GT(verdict.cases, 1000U);
  EXPECT_LT(verdict.cases, 100'000U);
  EXPECT_EQ(verdict.judge->cases(), verdict.cases);
  EXPECT_FALSE(verdict.smallest);
}

TEST(Stopped, AWrongRoutineHasItsSmallestCaseSoFar) {
  const judge::Verdict verdict = stopped_early("lost_carry");
  EXPECT_TRUE(verdict.is_stopped);
  EXPECT_FALSE(verdict.is_right());
  ASSERT_TRUE(verdict.smallest);
  EXPECT_GT(verdict.judge->wrong(), 0U);
}

TEST(Stopped, NoCaseHasRun) {
  const judge::Verdict verdict = stopped_early("mul", true);
  EXPECT_TRUE(verdict.is_stopped);
  EXPECT_EQ(verdict.cases, 0U);
}

TEST(Stopped, TheCommandSaysAfterHowManyCases) {
  const auto run = command::run({"bash", paths::source("tests/support/interrupted"), "INT", "0.1",
                                 paths::command(), "judge", routine("mul"), "--bits", "32",
                                 "--frame", "eax, ebx -> eax", "--as", "mul", "--level", "2"});
  EXPECT_EQ(run.status, 130) << run.out << run.err;
  command::expect_contains(run.out, "\nSTOPPED after ");
  command::expect_contains(run.out, " of 60,039,204 cases\n");
}

/// Stops the process that runs a routine, as a busy machine does for seconds.
void stop_children() {
  std::ifstream list("/proc/thread-self/children");
  for (pid_t child = 0; list >> child;) kill(child, SIGSTOP);
}

TEST(Busy, AProcessThatDoesNotRunForSecondsIsNoEndlessRoutine) {
  const support::Interrupt none_yet;
  const ScratchFolder folder;
  const judge::Image image =
      judge::load(folder.write("mul.asm", "bits 64\nlea eax, [rdi+rsi]\nret\n"), {});
  const cases::Variant sum = cases::variant_of(cases::Operation::add, cases::q16_16);
  const judge::Subject subject{image, judge::frame_for(image, "c", sum), sum};
  judge::VerdictOptions options{.rules = {.variant = sum}};
  options.cases.cases = 40'000;
  int calls = 0;
  options.progress = [&calls](std::uint64_t, std::uint64_t) {
    if (calls++ == 0) stop_children();
  };
  const judge::Verdict verdict = judge::judge_routine(subject, options);
  EXPECT_FALSE(verdict.stuck);
  EXPECT_EQ(verdict.cases, 40'000U);
  EXPECT_GT(calls, 3) << "all cases ran again";
}

}  // namespace

}  // namespace stopped_test

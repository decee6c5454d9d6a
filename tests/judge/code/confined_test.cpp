// The process that runs a user's code, tested with hostile native code.
#include "judge/code/confined.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>

#include "support/interrupt.hpp"
#include "tests/support/test.hpp"

namespace {

using fixproof::judge::Allowance;
using fixproof::judge::Calls;
using fixproof::judge::Confined;
using fixproof::judge::Downfall;
using std::chrono::milliseconds;

constexpr std::size_t memory = std::size_t{1} << 26U;

// A busy machine may not run the child for seconds.
constexpr milliseconds patience{30'000};

Allowance allowance(milliseconds time = patience) {
  return {.step = time, .whole = time, .steps = 1, .bytes = 100};
}

Downfall downfall_of(const Confined::Serve& serve, milliseconds time = patience,
                     Calls calls = Calls::emulator) {
  Confined child([&serve](Confined::Steps&) { return serve; }, memory, calls);
  return child.ask("request", allowance(time)).downfall;
}

/// The child's ends of the two pipes, which are all that is open.
struct Ends {
  int in = -1;
  int out = -1;
};
Ends open_ends() {
  Ends ends;
  for (int i = 0; i < 4096; ++i) {
    if (fcntl(i, F_GETFD) < 0) continue;
    (ends.in < 0 ? ends.in : ends.out) = i;
  }
  return ends;
}

/// Runs `act(ends)` in the child, which never replies by itself, with little time.
template <class Act>
Downfall downfall_of_writer(Act act, Calls calls = Calls::fewest) {
  Confined child(
      [act](Confined::Steps&) {
        return [act, ends = open_ends()](std::string_view) -> std::string {
          act(ends);
          for (volatile bool goes_on = true; goes_on;) {
          }
          return "";
        };
      },
      memory, calls);
  return child.ask("request", allowance(milliseconds(500))).downfall;
}

/// A message of `sent` bytes that claims to have `claimed`.
void write_message(int to, std::uint32_t claimed, std::size_t sent) {
  std::array<char, 200> bytes{};
  std::memcpy(bytes.data(), &claimed, sizeof claimed);
  if (write(to, bytes.data(), sizeof claimed + sent) < 0) _exit(7);
}

TEST(Confined, ServesRequestAfterRequest) {
  Confined child(
      [](Confined::Steps& steps) {
        return [&steps](std::string_view request) {
          ++steps;
          return std::string(request) + "!";
        };
      },
      memory, Calls::fewest);
  for (const char* text : {"one", "two"}) {
    EXPECT_EQ(child.ask(text, allowance()).bytes, std::string(text) + "!");
    EXPECT_EQ(child.steps(), 1U);
  }
  EXPECT_TRUE(child.is_alive());
}

TEST(Confined, AReplyMayComeInPieces) {
  Confined child([](Confined::Steps&) { return [](std::string_view) { return ""; }; }, memory,
                 Calls::emulator);
  const std::string large(1'000'000, 'x');
  EXPECT_EQ(child.ask(large, allowance()).downfall, Downfall::none);
}

TEST(Confined, AReplyLongerThanAllowedIsFalse) {
  EXPECT_EQ(downfall_of([](std::string_view) { return std::string(101, 'x'); }),
            Downfall::false_reply);
  EXPECT_EQ(downfall_of([](std::string_view) { return std::string(100, 'x'); }), Downfall::none);
}

TEST(Confined, ALengthWithoutAMessageRunsOutOfTime) {
  EXPECT_EQ(downfall_of_writer([](Ends ends) { write_message(ends.out, 100, 0); }),
            Downfall::out_of_time);
  EXPECT_EQ(downfall_of_writer([](Ends ends) { write_message(ends.out, 100, 99); }),
            Downfall::out_of_time);
}

TEST(Confined, AMessageLongerThanItsLengthIsFalse) {
  EXPECT_EQ(downfall_of_writer([](Ends ends) { write_message(ends.out, 10, 11); }),
            Downfall::false_reply);
}

TEST(Confined, AChildThatReadsNoRequestRunsOutOfTime) {
  Confined child(
      [](Confined::Steps&) {
        return [ends = open_ends()](std::string_view) -> std::string {
          write_message(ends.out, 1, 1);
          for (volatile bool goes_on = true; goes_on;) {
          }
          return "";
        };
      },
      memory, Calls::fewest);
  EXPECT_EQ(child.ask("request", allowance()).downfall, Downfall::none);
  const std::string larger_than_a_pipe(1U << 22U, 'x');
  EXPECT_EQ(child.ask(larger_than_a_pipe, allowance(milliseconds(500))).downfall,
            Downfall::out_of_time);
}

Downfall downfall_of_endless_steps(const Allowance& allowed) {
  Confined child(
      [](Confined::Steps& steps) {
        return [&steps](std::string_view) -> std::string {
          for (volatile bool goes_on = true; goes_on;) ++steps;
          return "";
        };
      },
      memory, Calls::fewest);
  return child.ask("request", allowed).downfall;
}

TEST(Confined, StepsWithoutEndBuyNoTime) {
  auto little = allowance();
  little.step = milliseconds(500);
  const auto begun = std::chrono::steady_clock::now();
  EXPECT_EQ(downfall_of_endless_steps(little), Downfall::out_of_time);
  EXPECT_LT(std::chrono::steady_clock::now() - begun, little.whole) << "the steps bought time";
  // The limit for the whole request holds for any number of steps.
  little.steps = ~std::uint64_t{0};
  little.whole = milliseconds(500);
  EXPECT_EQ(downfall_of_endless_steps(little), Downfall::out_of_time);
}

TEST(Confined, CtrlCEndsTheWaitForTheRestOfAReply) {
  Confined child(
      [](Confined::Steps&) {
        return [ends = open_ends()](std::string_view) -> std::string {
          write_message(ends.out, 100, 0);
          char byte = 0;
          while (read(ends.in, &byte, 1) >= 0) {
          }
          return "";
        };
      },
      memory, Calls::fewest);
  {
    const fixproof::support::Interrupt interrupt;
    (void)std::raise(SIGINT);
    EXPECT_THROW(child.ask("request", allowance()), fixproof::support::Stopped);
  }
  const fixproof::support::Interrupt none_yet;
}

TEST(Confined, UsesItsOwnPipesOnly) {
  for (const Calls calls : {Calls::fewest, Calls::emulator}) {
    for (const int wrong : {0, 1, 2, 777}) {
      EXPECT_EQ(downfall_of_writer([wrong](Ends) { (void)!write(wrong, "x", 1); }, calls),
                Downfall::system_call);
    }
    EXPECT_EQ(downfall_of_writer([](Ends ends) { (void)!write(ends.in, "x", 1); }, calls),
              Downfall::system_call);
  }
}

TEST(Confined, GetsNoMemoryToExecute) {
#ifdef JUDGE_SANITIZED
  GTEST_SKIP() << "AddressSanitizer looks at mmap";
#endif
  const auto map = [](int rights) {
    return [rights](std::string_view) {
      return std::to_string(mmap(nullptr, 4096, rights, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) ==
                            MAP_FAILED);
    };
  };
  EXPECT_EQ(downfall_of(map(PROT_READ | PROT_WRITE), patience, Calls::fewest), Downfall::none);
  EXPECT_EQ(downfall_of(map(PROT_READ | PROT_EXEC), patience, Calls::fewest),
            Downfall::system_call);
  EXPECT_EQ(downfall_of(map(PROT_READ | PROT_EXEC), patience, Calls::emulator), Downfall::none);
}

#if defined(__x86_64__) && defined(__linux__)
/// Whether a process that gives up the processor's clock is without it. Some virtual machines leave
/// it the clock.
bool clock_can_be_refused() {
  const pid_t child = fork();
  if (child == 0) {
    prctl(PR_SET_TSC, PR_TSC_SIGSEGV);  // NOLINT(cppcoreguidelines-pro-type-vararg)
    static_cast<void>(__builtin_ia32_rdtsc());
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status);
}

TEST(Confined, ReadsNoClockOfTheProcessor) {
#ifdef JUDGE_SANITIZED
  GTEST_SKIP() << "AddressSanitizer reads the clock";
#endif
  if (!clock_can_be_refused()) GTEST_SKIP() << "this system leaves every process the clock";
  const auto read_clock = [](std::string_view) { return std::to_string(__builtin_ia32_rdtsc()); };
  EXPECT_EQ(downfall_of(read_clock, patience, Calls::fewest), Downfall::crashed);
  EXPECT_EQ(downfall_of(read_clock, patience, Calls::emulator), Downfall::none);
}
#endif

TEST(Confined, OpensNoFile) {
  EXPECT_EQ(
      downfall_of([](std::string_view) { return std::to_string(open("/dev/null", O_RDONLY)); }),
      Downfall::system_call);
}

TEST(Confined, StartsNoProcess) {
  EXPECT_EQ(downfall_of([](std::string_view) { return std::to_string(fork()); }),
            Downfall::system_call);
}

TEST(Confined, HasLittleMemory) {
#ifdef JUDGE_SANITIZED
  GTEST_SKIP() << "AddressSanitizer ends the process before it throws";
#endif
  EXPECT_EQ(downfall_of([](std::string_view) { return std::string(16 * memory, 'x'); }),
            Downfall::out_of_memory);
}

TEST(Confined, HasLittleTime) {
  const auto serve = [](std::string_view) {
    // Volatile, because the compiler may assume that a loop without effects ends.
    for (volatile bool goes_on = true; goes_on;) {
    }
    return std::string();
  };
  EXPECT_EQ(downfall_of(serve, milliseconds(500)), Downfall::out_of_time);
}

TEST(Confined, ACrashIsNoReply) {
  EXPECT_EQ(downfall_of([](std::string_view) -> std::string { __builtin_trap(); }),
            Downfall::crashed);
}

}  // namespace

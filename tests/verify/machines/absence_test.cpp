// Tests that an unavailable party reports so and does not count as agreeing.
#include <csignal>

#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"
#include "verify/engine.hpp"
#include "verify/machine_code/emulator.hpp"
#include "verify/machine_code/machine_code.hpp"
#include "verify/machine_code/processor.hpp"
#include "verify/parties/answer.hpp"

#if defined(__linux__) && defined(__x86_64__)
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#endif

namespace {

using namespace fixproof;

TEST(Absence, IsSaidWhereThereIsNoMachineCode) {
  for (const auto& party : parties::parties()) {
    const bool is_machine = party->name() == "silicon" || party->name() == "unicorn";
    if (party->name().starts_with("batch-")) continue;  // for another processor
    if (!is_machine) {
      EXPECT_EQ(party->absence(), "") << party->name();
      continue;
    }
    EXPECT_EQ(party->absence().empty(), party->answers({})) << party->name();
    EXPECT_TRUE(machine_code::machine_code_absence().empty() || !party->absence().empty())
        << party->name();
    if (party->absence().empty()) {
      EXPECT_EQ(&parties::party_named(party->name()), party.get());
    } else {
      EXPECT_THROW(static_cast<void>(parties::party_named(party->name())), std::invalid_argument);
    }
  }
}

#if defined(__linux__) && defined(__x86_64__)

// NOLINTBEGIN(cppcoreguidelines-pro-type-vararg): prctl() and execl() are variadic

/// Makes the system refuse modify_ldt() to this process, as a container may.
void refuse_segments() {
  std::array<sock_filter, 4> rules{
      sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_modify_ldt, 0, 1),
      sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM),
      sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)};
  const sock_fprog program{.len = rules.size(), .filter = rules.data()};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) std::_Exit(125);
  if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) std::_Exit(125);
}

/// Turns the process into `fixproof verify mul OPTION VALUE` without segments.
void verify_without_segments(const char* option, const char* value) {
  refuse_segments();
  execl(paths::command().c_str(), "fixproof", "verify", "mul", option, value, nullptr);
}

// NOLINTEND(cppcoreguidelines-pro-type-vararg)

class AbsenceDeathTest : public testing::Test {
 protected:
  void SetUp() override {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    if (!machine_code::machine_code_absence().empty())
      GTEST_SKIP() << machine_code::machine_code_absence();
  }
};

TEST_F(AbsenceDeathTest, OfTheProcessorEndsWithStatus2AndTheReason) {
  const char* reason =
      "^fixproof: party 'silicon' is not available: the system does not provide 16-bit segments: "
      "modify_ldt: "
      "Operation not permitted\n$";
  EXPECT_EXIT(verify_without_segments("--against", "silicon"), testing::ExitedWithCode(2), reason);
  EXPECT_EXIT(verify_without_segments("--by", "silicon"), testing::ExitedWithCode(2), reason);
}

[[noreturn]] void exit_42(int /*signal*/) { std::_Exit(42); }

/// Raises a divide error in a segment, then SIGFPE in the program itself. `action`, installed
/// before the segment, must catch the second.
void fault_inside_then_outside(void (*action)(int)) {
  static_cast<void>(std::signal(SIGFPE, action));
  if (!machine_code::Processor::absence().empty()) std::_Exit(77);
  const std::array<std::uint32_t, 2> by_zero{1, 0};
  if (parties::ask(parties::party_named("silicon"), {.operation = cases::Operation::div}, by_zero)
          .text(32) != "DE")
    return;
  static_cast<void>(std::raise(SIGFPE));
}

TEST_F(AbsenceDeathTest, OfAHandlerIsNotBroughtAbout) {
  const auto absent = [](int status) {
    return testing::ExitedWithCode(77)(status) && !machine_code::Processor::absence().empty();
  };
  const auto handled = [&](int status) {
    return testing::ExitedWithCode(42)(status) || absent(status);
  };
  const auto killed = [&](int status) {
    return testing::KilledBySignal(SIGFPE)(status) || absent(status);
  };
  EXPECT_EXIT(fault_inside_then_outside(exit_42), handled, "^$");
  EXPECT_EXIT(fault_inside_then_outside(SIG_DFL), killed, "");
}

#endif

}  // namespace

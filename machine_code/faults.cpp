#include "machine_code/faults.hpp"

#if defined(__linux__) && defined(__x86_64__) && !defined(__ILP32__)

#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigaction() is POSIX's
#include <ucontext.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <system_error>

namespace fixproof::machine_code {

namespace {

constexpr std::array fault_signals{SIGFPE, SIGSEGV, SIGBUS, SIGILL, SIGTRAP};

using Actions = std::array<struct sigaction, fault_signals.size()>;

Actions& previous_actions() {
  static Actions actions{};
  return actions;
}

/// The current call of this thread and the signal that ended it. Thread-local, because a signal
/// handler takes no user argument.
struct Running {
  SegmentCall* call = nullptr;
  int signal = 0;
};
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
thread_local Running running;

/// Handles a fault outside the segment as if this file did not exist.
void pass_on(int signal, siginfo_t* info, void* context) {
  for (std::size_t i = 0; i < fault_signals.size(); ++i) {
    if (fault_signals.at(i) != signal) continue;
    const struct sigaction& previous = previous_actions().at(i);
    if ((previous.sa_flags & SA_SIGINFO) != 0) return previous.sa_sigaction(signal, info, context);
    const bool was_sent = info->si_code <= 0;
    if (previous.sa_handler == SIG_IGN && was_sent) return;
    if (previous.sa_handler != SIG_IGN && previous.sa_handler != SIG_DFL) {
      return previous.sa_handler(signal);
    }
  }
  // With the default action, the raised signal ends the process when this handler returns.
  struct sigaction by_default {};
  by_default.sa_handler = SIG_DFL;
  sigaction(signal, &by_default, nullptr);
  static_cast<void>(raise(signal));
}

/// CS, GS, FS and SS share one word of the context, with CS lowest.
constexpr unsigned ss_shift = 48;

void on_fault(int signal, siginfo_t* info, void* context) {
  auto& registers = static_cast<ucontext_t*>(context)->uc_mcontext.gregs;
  auto selectors = static_cast<std::uint64_t>(registers[REG_CSGSFS]);
  const SegmentCall* call = running.call;
  if (call == nullptr || static_cast<std::uint16_t>(selectors) != call->code_selector) {
    return pass_on(signal, info, context);
  }
  running.signal = signal;
  // Continues where the code would have returned, as the landing code does.
  registers[REG_R10] = registers[REG_RSP];
  registers[REG_RSP] = static_cast<greg_t>(call->landing->stack);
  registers[REG_RIP] = static_cast<greg_t>(call->landing->resume);
  selectors &= ~(std::uint64_t{0xFFFF} << ss_shift | 0xFFFFU);
  selectors |= code_selector_of_64_bits();
  selectors |= std::uint64_t{stack_selector_of_64_bits()} << ss_shift;
  registers[REG_CSGSFS] = static_cast<greg_t>(selectors);
}

}  // namespace

void catch_segment_faults() {
  static const bool caught = [] {
    struct sigaction action {};
    action.sa_sigaction = on_fault;
    // A handler cannot use the stack of the segment.
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < fault_signals.size(); ++i) {
      if (sigaction(fault_signals.at(i), &action, &previous_actions().at(i)) != 0) {
        throw std::system_error(errno, std::generic_category(), "sigaction");
      }
    }
    return true;
  }();
  static_cast<void>(caught);
}

int call_segment(SegmentCall& call) {
  running.signal = 0;
  running.call = &call;
  std::atomic_signal_fence(std::memory_order_seq_cst);
  fixproof_enter_segment(&call);
  std::atomic_signal_fence(std::memory_order_seq_cst);
  running.call = nullptr;
  return running.signal;
}

std::uint16_t code_selector_of_64_bits() {
  std::uint16_t selector = 0;
  asm("movw %%cs, %0" : "=r"(selector));
  return selector;
}

std::uint16_t stack_selector_of_64_bits() {
  std::uint16_t selector = 0;
  asm("movw %%ss, %0" : "=r"(selector));
  return selector;
}

}  // namespace fixproof::machine_code

#endif

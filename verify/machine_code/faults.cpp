#include "verify/machine_code/faults.hpp"

#if defined(__linux__) && defined(__x86_64__) && !defined(__ILP32__)

#include <ucontext.h>

#include <atomic>

#include "support/fault_signals.hpp"

namespace fixproof::machine_code {

namespace {

/// The current call of this thread and how it ended. Thread-local, because a signal
/// handler takes no user argument.
struct Running {
  SegmentCall* call = nullptr;
  CallEnding ending = CallEnding::returned;
};
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
thread_local Running running;

/// CS, GS, FS and SS share one word of the context, with CS lowest.
constexpr unsigned ss_shift = 48;

bool end_call(int /*signal*/, void* context) {
  auto& registers = static_cast<ucontext_t*>(context)->uc_mcontext.gregs;
  auto selectors = static_cast<std::uint64_t>(registers[REG_CSGSFS]);
  const SegmentCall* call = running.call;
  if (call == nullptr || static_cast<std::uint16_t>(selectors) != call->code_selector) {
    return false;
  }
  // SIGFPE does not tell: exceptions of the x87 and of SSE raise it, too.
  constexpr greg_t divide_error = 0;
  running.ending =
      registers[REG_TRAPNO] == divide_error ? CallEnding::divide_error : CallEnding::fault;
  // Continues where the code would have returned, as the landing code does.
  registers[REG_R10] = registers[REG_RSP];
  registers[REG_RSP] = static_cast<greg_t>(call->landing->stack);
  registers[REG_RIP] = static_cast<greg_t>(call->landing->resume);
  selectors &= ~(std::uint64_t{0xFFFF} << ss_shift | 0xFFFFU);
  selectors |= code_selector_of_64_bits();
  selectors |= std::uint64_t{stack_selector_of_64_bits()} << ss_shift;
  registers[REG_CSGSFS] = static_cast<greg_t>(selectors);
  return true;
}

}  // namespace

void catch_segment_faults() { support::add_fault_handler(end_call); }

CallEnding call_segment(SegmentCall& call) {
  running.ending = CallEnding::returned;
  running.call = &call;
  std::atomic_signal_fence(std::memory_order_seq_cst);
  fixproof_enter_segment(&call);
  std::atomic_signal_fence(std::memory_order_seq_cst);
  running.call = nullptr;
  return running.ending;
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

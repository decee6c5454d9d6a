#include "verify/interrupt.hpp"

#include <csignal>

namespace fixproof {

namespace {

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): all that a handler can reach
std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait for a lock");

extern "C" void note_interrupt(int /*signal*/) { interrupted = true; }

void set_handler(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  // One shot: whoever presses Ctrl-C twice does not want to wait.
  action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

Interrupt::Interrupt() {
  interrupted = false;
  set_handler(note_interrupt);
}

Interrupt::~Interrupt() { set_handler(SIG_DFL); }

const std::atomic<bool>& Interrupt::flag() { return interrupted; }

}  // namespace fixproof

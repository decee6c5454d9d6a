#include "support/interrupt.hpp"

#include <csignal>
#include <cstdint>
#include <ctime>

namespace fixproof::support {

namespace {

// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables): all that a handler can reach
std::atomic<bool> interrupted = false;
std::atomic<std::int64_t> interrupted_at = 0;
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)
static_assert(std::atomic<bool>::is_always_lock_free &&
                  std::atomic<std::int64_t>::is_always_lock_free,
              "a signal handler must not wait for a lock");

/// Seconds of a clock that a signal handler may read.
std::int64_t seconds_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec;
}

extern "C" void note_interrupt(int signal) {
  const std::int64_t now = seconds_now();
  if (!interrupted.exchange(true)) {
    interrupted_at = now;
  } else if (now > interrupted_at + 1) {
    static_cast<void>(std::signal(signal, SIG_DFL));
    static_cast<void>(std::raise(signal));
  }
}

void set_handler(void (*handler)(int)) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    // nohup ignores SIGHUP; leave that as it is.
    if (signal == SIGHUP && action.sa_handler == SIG_IGN) continue;
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
}

}  // namespace

Interrupt::Interrupt() {
  interrupted = false;
  set_handler(note_interrupt);
}

Interrupt::~Interrupt() { set_handler(SIG_DFL); }

const std::atomic<bool>& Interrupt::flag() { return interrupted; }

}  // namespace fixproof::support

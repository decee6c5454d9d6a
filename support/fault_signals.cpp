#include "support/fault_signals.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <mutex>
#include <stdexcept>
#include <system_error>

namespace fixproof::support {

namespace {

constexpr std::array fault_signals{SIGFPE, SIGSEGV, SIGBUS, SIGILL, SIGTRAP};

using Actions = std::array<struct sigaction, fault_signals.size()>;

Actions& previous_actions() {
  static Actions actions{};
  return actions;
}

// Atomic, because a fault of another thread may come while a handler is added.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): all that a handler can reach
std::array<std::atomic<FaultHandler>, 4> handlers{};
static_assert(std::atomic<FaultHandler>::is_always_lock_free,
              "a signal handler must not wait for a lock");

/// Does what the process did before this file installed its handler.
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

void on_fault(int signal, siginfo_t* info, void* context) {
  for (std::size_t i = handlers.size(); i-- > 0;) {
    const FaultHandler handler = handlers.at(i);
    if (handler != nullptr && handler(signal, context)) return;
  }
  pass_on(signal, info, context);
}

void install() {
  struct sigaction action {};
  action.sa_sigaction = on_fault;
  // The code that faults may have no stack for a handler.
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < fault_signals.size(); ++i) {
    if (sigaction(fault_signals.at(i), &action, &previous_actions().at(i)) != 0) {
      throw std::system_error(errno, std::generic_category(), "sigaction");
    }
  }
}

}  // namespace

void add_fault_handler(FaultHandler handler) {
  static std::mutex adding;
  const std::lock_guard lock(adding);
  for (auto& place : handlers) {
    if (place == handler) return;
    if (place != nullptr) continue;
    if (&place == &handlers.front()) install();
    place = handler;
    return;
  }
  throw std::length_error("handlers of faults");
}

}  // namespace fixproof::support

#include "verify/machine_code/guarded_call.hpp"

#include <setjmp.h>  // NOLINT(modernize-deprecated-headers): sigsetjmp() is POSIX's

#include <boost/noncopyable.hpp>

#include "support/fault_signals.hpp"
#include "verify/machine_code/handler_stack.hpp"

namespace fixproof::machine_code {

namespace {

/// Where the running call of this thread continues after a fault; null between calls.
// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables): all that a handler can reach
thread_local sigjmp_buf* landing = nullptr;
thread_local int fault = 0;
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)

bool leave_call(int signal, void* /*context*/) {
  if (landing == nullptr) return false;
  fault = signal;
  siglongjmp(*landing, 1);
}

class Landing : private boost::noncopyable {
 public:
  explicit Landing(sigjmp_buf& buffer) { landing = &buffer; }
  ~Landing() { landing = nullptr; }
};

}  // namespace

int signal_of(const std::function<void()>& body) {
  support::add_fault_handler(leave_call);
  const HandlerStack stack;
  sigjmp_buf buffer;
  const Landing in_call(buffer);
  // Nothing in this function changes between the two returns of sigsetjmp().
  if (sigsetjmp(buffer, 1) != 0) return fault;
  body();
  return 0;
}

}  // namespace fixproof::machine_code

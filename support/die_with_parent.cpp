#include "support/die_with_parent.hpp"

#ifdef __linux__
#include <signal.h>  // NOLINT(modernize-deprecated-headers): SIGKILL as the system names it
#include <sys/prctl.h>
#include <unistd.h>
#endif

namespace fixproof::support {

#ifdef __linux__
void die_with_parent(pid_t parent) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): the only function there is
  prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
  if (getppid() != parent) _exit(0);  // the signal would never come
}
#else
void die_with_parent(pid_t /*parent*/) {}
#endif

}  // namespace fixproof::support

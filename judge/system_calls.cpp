#include "judge/system_calls.hpp"

#ifdef __linux__

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): SIGKILL as the system names it
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <system_error>
#include <vector>

namespace fixproof::judge {

namespace {

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#elif defined(__i386__)
constexpr std::uint32_t architecture = AUDIT_ARCH_I386;
#else
constexpr std::uint32_t architecture = 0;
#endif

/// What the C library and Unicorn need between a request and its reply.
constexpr std::array allowed{
    SYS_read,        SYS_write,         SYS_exit,         SYS_exit_group,
    SYS_brk,         SYS_munmap,        SYS_mprotect,     SYS_madvise,
    SYS_mremap,      SYS_futex,         SYS_rt_sigreturn, SYS_rt_sigprocmask,
#ifdef SYS_mmap
    SYS_mmap,
#endif
#ifdef SYS_mmap2
    SYS_mmap2,
#endif
    SYS_sigaltstack, SYS_clock_gettime, SYS_sched_yield,  SYS_getrandom,
};

sock_filter statement(int code, std::uint32_t k) {
  return {static_cast<std::uint16_t>(code), 0, 0, k};
}
sock_filter jump_if_equal(std::uint32_t k, std::uint8_t yes, std::uint8_t no) {
  return {BPF_JMP | BPF_JEQ | BPF_K, yes, no, k};
}

void set(int option, unsigned long first, unsigned long second) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): the only function there is
  if (prctl(option, first, second, 0, 0) != 0) {
    throw std::system_error(errno, std::generic_category(), "prctl");
  }
}

}  // namespace

void allow_only_computing() {
  std::vector<sock_filter> filter;
  if (architecture != 0) {
    // Calls of another mode, such as INT 80h in a 64-bit process, have other numbers.
    filter.push_back(statement(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)));
    filter.push_back(jump_if_equal(architecture, 1, 0));
    filter.push_back(statement(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS));
  }
  filter.push_back(statement(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)));
  for (const long number : allowed) {
    filter.push_back(jump_if_equal(static_cast<std::uint32_t>(number), 0, 1));
    filter.push_back(statement(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  }
  filter.push_back(statement(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS));
  const sock_fprog program{static_cast<std::uint16_t>(filter.size()), filter.data()};
  set(PR_SET_NO_NEW_PRIVS, 1, 0);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): how prctl() takes a pointer
  set(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, reinterpret_cast<unsigned long>(&program));
}

void die_with_parent() {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): as above
  prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
}

}  // namespace fixproof::judge

#else

namespace fixproof::judge {

void allow_only_computing() {}
void die_with_parent() {}

}  // namespace fixproof::judge

#endif

#include "judge/code/system_calls.hpp"

#ifdef __linux__

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <system_error>
#include <vector>

namespace fixproof::judge {

namespace {

#if defined(__x86_64__)
constexpr std::uint32_t audited_architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t audited_architecture = AUDIT_ARCH_AARCH64;
#elif defined(__i386__)
constexpr std::uint32_t audited_architecture = AUDIT_ARCH_I386;
#else
constexpr std::uint32_t audited_architecture = 0;
#endif
/// The offset of the low half of an argument.
constexpr std::size_t low_half = std::endian::native == std::endian::little ? 0 : 4;

/// What an argument of a call must be. Only the low 32 bits count: the kernel ignores the others in
/// a descriptor and in the rights to memory.
struct Argument {
  unsigned number;
  enum class Is { equal, without } is;
  std::uint32_t value;  ///< of the argument, or bits that it must not have
};

struct AllowedCall {
  long number;
  std::vector<Argument> arguments{};
};

/// What the C library needs between a request and its reply, and with Calls::emulator also Unicorn.
std::vector<AllowedCall> allowed_calls(Calls calls, int in, int out) {
  using enum Argument::Is;
  const auto descriptor = [](int number) {
    return Argument{0, equal, static_cast<std::uint32_t>(number)};
  };
  const Argument anonymous{4, equal, ~0U};
  std::vector<AllowedCall> all{
      {SYS_read, {descriptor(in)}},
      {SYS_write, {descriptor(out)}},
      {SYS_exit_group},
      {SYS_rt_sigreturn},
      {SYS_brk},
      {SYS_munmap},
      {SYS_mremap},
  };
#ifdef SYS_mmap
  constexpr long map = SYS_mmap;
#else
  constexpr long map = SYS_mmap2;
#endif
  if (calls == Calls::fewest) {
    all.push_back({map, {anonymous, {2, without, PROT_EXEC}}});
    return all;
  }
  all.push_back({map, {anonymous}});
  for (const long number : {SYS_exit, SYS_mprotect, SYS_madvise, SYS_futex, SYS_rt_sigprocmask,
                            SYS_sigaltstack, SYS_clock_gettime, SYS_sched_yield, SYS_getrandom}) {
    all.push_back({number});
  }
  return all;
}

sock_filter statement(int code, std::uint32_t k) {
  return {static_cast<std::uint16_t>(code), 0, 0, k};
}
/// Skips `yes` statements if the comparison with `k` holds, else `no`.
sock_filter jump(int comparison, std::uint32_t k, std::uint8_t yes, std::uint8_t no) {
  return {static_cast<std::uint16_t>(BPF_JMP | comparison | BPF_K), yes, no, k};
}
sock_filter load(std::size_t offset) {
  return statement(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
}

/// Appends what decides on a call whose number is loaded; other numbers go on behind it.
void append(std::vector<sock_filter>& filter, const AllowedCall& call) {
  std::vector<sock_filter> decision;
  for (const Argument& argument : call.arguments) {
    const bool is_equal = argument.is == Argument::Is::equal;
    decision.push_back(load(offsetof(seccomp_data, args) +
                            argument.number * sizeof(seccomp_data::args[0]) + low_half));
    decision.push_back(
        jump(is_equal ? BPF_JEQ : BPF_JSET, argument.value, is_equal ? 1 : 0, is_equal ? 0 : 1));
    decision.push_back(statement(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS));
  }
  decision.push_back(statement(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  filter.push_back(jump(BPF_JEQ, static_cast<std::uint32_t>(call.number), 0,
                        static_cast<std::uint8_t>(decision.size())));
  filter.insert(filter.end(), decision.begin(), decision.end());
}

void set(int option, unsigned long first, unsigned long second) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): the only function there is
  if (prctl(option, first, second, 0, 0) != 0) {
    throw std::system_error(errno, std::generic_category(), "prctl");
  }
}

}  // namespace

void allow_only_computing(Calls calls, int in, int out) {
  // AddressSanitizer's allocator reads the clock.
#if (defined(__x86_64__) || defined(__i386__)) && !defined(JUDGE_SANITIZED)
  // Code that searches for addresses without a clock learns nothing from what is in a cache.
  if (calls == Calls::fewest) set(PR_SET_TSC, PR_TSC_SIGSEGV, 0);
#endif
  std::vector<sock_filter> filter;
  if (audited_architecture != 0) {
    // Calls of another mode, such as INT 80h in a 64-bit process, have other numbers.
    filter.push_back(load(offsetof(seccomp_data, arch)));
    filter.push_back(jump(BPF_JEQ, audited_architecture, 1, 0));
    filter.push_back(statement(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS));
  }
  filter.push_back(load(offsetof(seccomp_data, nr)));
  for (const AllowedCall& call : allowed_calls(calls, in, out)) append(filter, call);
  filter.push_back(statement(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS));
  const sock_fprog program{static_cast<std::uint16_t>(filter.size()), filter.data()};
  set(PR_SET_NO_NEW_PRIVS, 1, 0);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): how prctl() takes a pointer
  set(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, reinterpret_cast<unsigned long>(&program));
}

}  // namespace fixproof::judge

#else

namespace fixproof::judge {

void allow_only_computing(Calls /*calls*/, int /*in*/, int /*out*/) {}

}  // namespace fixproof::judge

#endif

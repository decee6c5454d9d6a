#include "tests/verify/vectors/processor.hpp"

#include <algorithm>
#include <stdexcept>

#if defined(__x86_64__)

#include <sys/mman.h>
#include <ucontext.h>

#include <cerrno>
#include <csignal>
#include <system_error>

// Loads the registers at RDI, jumps to the code at RSI, which ends in JMP R13, and stores them. The
// instruction may use all eight registers, even ESP, so R13 to R15 hold the saved values.
extern "C" void fixproof_execute(vectors::Registers* registers, const std::uint8_t* code);
asm(R"(
    .text
    .type fixproof_execute, @function
fixproof_execute:
    push %rbx
    push %rbp
    push %r12
    push %r13
    push %r14
    push %r15
    mov  %rdi, %r15
    mov  %rsi, %r14
    mov  %rsp, %r12
    lea  1f(%rip), %r13
    mov  32(%r15), %eax
    push %rax
    popfq
    mov  0(%r15), %eax
    mov  4(%r15), %ecx
    mov  8(%r15), %edx
    mov  12(%r15), %ebx
    mov  16(%r15), %esp
    mov  20(%r15), %ebp
    mov  24(%r15), %esi
    mov  28(%r15), %edi
    jmp  *%r14
1:  mov  %esp, 16(%r15)
    mov  %r12, %rsp
    mov  %eax, 0(%r15)
    mov  %ecx, 4(%r15)
    mov  %edx, 8(%r15)
    mov  %ebx, 12(%r15)
    mov  %ebp, 20(%r15)
    mov  %esi, 24(%r15)
    mov  %edi, 28(%r15)
    pushfq
    pop  %rax
    mov  %eax, 32(%r15)
    pop  %r15
    pop  %r14
    pop  %r13
    pop  %r12
    pop  %rbp
    pop  %rbx
    ret
    .size fixproof_execute, .-fixproof_execute
)");

namespace vectors {

namespace {

constexpr std::uint32_t always_set = 0x202;  // bit 1, and IF, which user programs always have set

// NOLINTNEXTLINE(*-avoid-non-const-global-variables): all that a signal handler may write
volatile std::sig_atomic_t faulted = 0;

/// Continues after the instruction that raised a divide error, with its registers unchanged.
void skip_instruction(int /*signal*/, siginfo_t* /*info*/, void* context) {
  faulted = 1;
  auto& registers = static_cast<ucontext_t*>(context)->uc_mcontext.gregs;
  registers[REG_RIP] = registers[REG_R13];
}

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// A page of code, and a SIGFPE handler on its own stack, because ESP may hold any value.
class Sandbox {
 public:
  Sandbox()
      : page_(
            mmap(nullptr, page_size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)) {
    if (page_ == MAP_FAILED) fail("mmap");
    stack_t stack{};
    stack.ss_sp = stack_.data();
    stack.ss_size = stack_.size();
    struct sigaction action {};
    action.sa_sigaction = skip_instruction;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    if (sigaltstack(&stack, &old_stack_) != 0) fail("sigaltstack");
    if (sigaction(SIGFPE, &action, &old_action_) != 0) fail("sigaction");
  }
  ~Sandbox() {
    sigaction(SIGFPE, &old_action_, nullptr);
    sigaltstack(&old_stack_, nullptr);
    munmap(page_, page_size);
  }
  Sandbox(const Sandbox&) = delete;
  Sandbox(Sandbox&&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;
  Sandbox& operator=(Sandbox&&) = delete;

  const std::uint8_t* place(std::span<const std::uint8_t> code) {
    constexpr std::array<std::uint8_t, 3> jmp_r13{0x41, 0xFF, 0xE5};
    if (code.size() + jmp_r13.size() > page_size) throw std::length_error("no such instruction");
    auto* to = static_cast<std::uint8_t*>(page_);
    std::copy(jmp_r13.begin(), jmp_r13.end(), std::copy(code.begin(), code.end(), to));
    if (mprotect(page_, page_size, PROT_READ | PROT_EXEC) != 0) fail("mprotect");
    return to;
  }

 private:
  static constexpr std::size_t page_size = 4096;

  void* page_;
  std::array<std::uint8_t, 65536> stack_{};
  stack_t old_stack_{};
  struct sigaction old_action_ {};
};

}  // namespace

bool has_processor() { return true; }

bool execute(std::span<const std::uint8_t> code, Registers& registers) {
  Sandbox sandbox;
  const std::uint8_t* placed = sandbox.place(code);
  Registers work = registers;
  work.flags = (registers.flags & six_flags) | always_set;
  faulted = 0;
  fixproof_execute(&work, placed);
  if (faulted != 0) return false;
  work.flags = (registers.flags & ~six_flags) | (work.flags & six_flags);
  registers = work;
  return true;
}

}  // namespace vectors

#else

namespace vectors {

bool has_processor() { return false; }

bool execute(std::span<const std::uint8_t> /*code*/, Registers& /*registers*/) {
  throw std::logic_error("needs an x86-64 processor");
}

}  // namespace vectors

#endif

#include "verify/machine_code/enter_segment.hpp"

#if defined(__linux__) && defined(__x86_64__) && !defined(__ILP32__)

// The state that the switch must preserve:
// - The mode switch may lose r8 to r15 and the upper halves of the other registers. The 64-bit
//   stack saves all registers that the ABI preserves, and the Landing holds its RSP.
// - DS, ES and SS hold the segment during the call and are restored. FS and GS stay untouched,
//   because thread-local storage depends on them.
// - The caller sets only the six arithmetic flags. The flags at the exit are stored, then
//   cleared: the ABI requires DF to be 0, and AC would make unaligned accesses fault.
// - The x87, SSE and AVX state stays untouched. A function call leaves no red zone to preserve. If
//   the caller asks for it, the registers of SSE and AVX that the code can read are cleared,
//   because C++ code leaves addresses there. The ABI preserves none of them.
asm(R"(
        .pushsection .text
        .p2align 4
        .globl fixproof_enter_segment
        .hidden fixproof_enter_segment
        .type fixproof_enter_segment, @function
fixproof_enter_segment:
        pushq %rbx
        pushq %rbp
        pushq %r12
        pushq %r13
        pushq %r14
        pushq %r15
        pushq %rdi
        movl %ds, %eax
        pushq %rax
        movl %es, %eax
        pushq %rax
        movl %ss, %eax
        pushq %rax
        cmpl $1, 44(%rdi)
        jb 2f
        je 1f
        vzeroall
1:      pxor %xmm0, %xmm0
        pxor %xmm1, %xmm1
        pxor %xmm2, %xmm2
        pxor %xmm3, %xmm3
        pxor %xmm4, %xmm4
        pxor %xmm5, %xmm5
        pxor %xmm6, %xmm6
        pxor %xmm7, %xmm7
2:      movq 48(%rdi), %r9
        leaq fixproof_leave_segment(%rip), %rax
        movq %rax, 8(%r9)
        movq %rsp, (%r9)
        movq %rdi, %r8
        movl 32(%r8), %eax
        pushq %rax
        popfq
        movw 42(%r8), %ds
        movw 42(%r8), %es
        movl 0(%r8), %eax
        movl 4(%r8), %ecx
        movl 8(%r8), %edx
        movl 12(%r8), %ebx
        movl 20(%r8), %ebp
        movl 24(%r8), %esi
        movl 28(%r8), %edi
        movw 42(%r8), %ss
        movl 16(%r8), %esp
        ljmpl *36(%r8)

        .globl fixproof_leave_segment
        .hidden fixproof_leave_segment
fixproof_leave_segment:
        popq %r8
        movw %r8w, %ss
        popq %r8
        movw %r8w, %es
        popq %r8
        movw %r8w, %ds
        popq %r8
        pushfq
        popq %r9
        movl %r9d, 32(%r8)
        movl %eax, 0(%r8)
        movl %ecx, 4(%r8)
        movl %edx, 8(%r8)
        movl %ebx, 12(%r8)
        movl %r10d, 16(%r8)
        movl %ebp, 20(%r8)
        movl %esi, 24(%r8)
        movl %edi, 28(%r8)
        pushq $0x202
        popfq
        popq %r15
        popq %r14
        popq %r13
        popq %r12
        popq %rbp
        popq %rbx
        retq
        .size fixproof_enter_segment, . - fixproof_enter_segment

        # Copied to low memory. Both addresses are relative to the instruction pointer and lead to
        # the Landing behind the copy.
        .globl fixproof_landing
        .hidden fixproof_landing
fixproof_landing:
        movl %esp, %r10d
        movq fixproof_landing + 0x1000(%rip), %rsp
        jmpq *fixproof_landing + 0x1008(%rip)
        .globl fixproof_landing_end
        .hidden fixproof_landing_end
fixproof_landing_end:
        .popsection
)");

#endif

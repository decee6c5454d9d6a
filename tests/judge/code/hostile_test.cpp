// Hostile code of each width leads to a clear message and has no effect.
#include <fmt/format.h>

#include "tests/judge/code/judged.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

using judged::expect;
using Widths = std::vector<int>;

/// In each width.
const std::string multiplies = "imul ebx\nshrd eax, edx, 16\n";

void expect_found(const std::string& source, const std::vector<std::string>& parts,
                  const Widths& widths = {32}) {
  for (const int bits : widths) {
    SCOPED_TRACE(fmt::format("{} bits: {}", bits, source));
    const ScratchFolder folder;
    expect(
        judged::judge(folder.write("hostile.asm", source),
                      fmt::format("--bits|{}|--frame|eax, ebx -> eax|--as|mul|--cases|5000", bits)),
        1, parts);
  }
}

void expect_broken(const std::string& source, const std::string& what,
                   const Widths& widths = {32}) {
  expect_found(source, {"BROKEN", what}, widths);
}

/// After the hostile code comes a product, so that nothing else is wrong.
void expect_wide(const std::string& code, const std::string& what) {
  expect_found(code + "\n" + multiplies + "ret", {what}, {64});
}

TEST(Hostile, AnEndlessLoop) { expect_broken("jmp $", "the routine does not end", {32, 64}); }

TEST(Hostile, ARareEndlessLoop) {
  expect_broken("cmp ebx, 0x20000\nje $\nret", " 2) the routine does not end", {32, 64});
}

TEST(Hostile, AWildJump) {
  expect_broken("mov ebx, 0x5000\njmp ebx", "the routine leaves the code, to 5000h");
  expect_broken("mov ebx, 0x5000\njmp rbx", "the routine leaves the code, to 5000h", {64});
}

TEST(Hostile, AJumpBeyondAllMemory) {
  expect_wide("mov rcx, 0x100000000\njmp rcx", "the routine uses memory at 100000000h");
  expect_wide("mov rcx, -16\njmp rcx", "the routine uses memory at fffffffffffffff0h");
  expect_wide("mov rcx, 0x123456789abc\npush rcx\nret", "uses memory at 123456789abch");
}

TEST(Hostile, AWildPointer) {
  expect_broken("mov [0x12345678], eax\nret", "the routine uses memory at 12345678h", {32, 64});
}

TEST(Hostile, AWildPointerOf64Bits) {
  // The low halves are addresses of memory.
  expect_wide("mov rcx, 0x100004000\nmov [rcx], eax", "uses memory at 100004000h, where there is");
  expect_wide("mov rcx, 0x1000000000100\nmov rcx, [rcx]",
              "the routine uses memory at 1000000000100h");
  // Addresses that are not canonical, and the last ones.
  expect_wide("mov rcx, 0x800000004000\nmov [rcx], eax", "uses memory at 800000004000h");
  expect_wide("mov rcx, -8\nmov rcx, [rcx]", "uses memory at fffffffffffffff8h");
}

TEST(Hostile, ASystemCall) {
  expect_broken("mov eax, 1\nint 0x80\nret", "the routine calls interrupt 80h at 0005h", {32, 64});
}

TEST(Hostile, ASystemCallByAnInstruction) {
  const std::string text = "the routine makes a system call at 000";
  for (const std::string call : {"syscall", "sysenter"}) {
    const std::string source = multiplies + call + "\nret";
    expect_broken(source, text + "6h: routines run without a system", {32, 64});
    expect_broken(source, text + "8h: routines run without a system", {16});
  }
}

TEST(Hostile, AFork) {
  expect_broken("again: mov eax, 2\nint 0x80\njmp again", "the routine calls interrupt 80h");
  expect_broken("again: mov eax, 57\nsyscall\njmp again", "the routine makes a system call", {64});
}

TEST(Hostile, ASystemCallOf64BitCode) {
  // Jumps far into 64-bit code to open a file: the kernel ends the process.
  expect_broken("jmp 0x33:0x10\nalign 16\nbits 64\nmov eax, 2\nsyscall", "BROKEN");
}

TEST(Hostile, OtherSegments) {
  for (const char* segment : {"ds", "es", "ss", "fs", "gs"}) {
    expect_wide(fmt::format("mov ecx, 0x2b\nmov {}, cx", segment), "general protection fault");
  }
  expect_wide("wrfsbase rax", "the routine has an invalid instruction at 0000h");
  expect_wide("wrgsbase rax", "the routine has an invalid instruction at 0000h");
  expect_wide("push 0x23\npush 0\nretfq", "raises a general protection fault (#GP) at 0004h");
  expect_wide("jmp far [rel there]\nthere: dd 0\ndw 0x23", "general protection fault (#GP)");
}

TEST(Hostile, HugeMemory) {
  expect_broken("mov edi, 0x100000\nmov ecx, -1\nrep stosd\nret",
                "the routine uses memory at 100000h, where there is none", {32, 64});
  expect_broken("mov edi, 0x100000\nmov rcx, -1\nrep stosq\nret",
                "the routine uses memory at 100000h, where there is none", {64});
}

TEST(Hostile, AStackWithoutEnd) {
  expect_broken("again: call again", "the routine ", {32, 64});
  expect_broken("mov rcx, [rsp]\nagain: push rcx\njmp again", "the routine ", {64});
  expect_wide("sub rsp, 0x70000000\npush rax", "the routine uses memory at ffffffff9");
}

TEST(Hostile, AnInstructionOfTheSystem) {
  expect_broken("hlt", "halts the processor at 0", {16, 32, 64});
}

TEST(Hostile, APrivilegedInstruction) {
  expect_wide("cli", "USES A PRIVILEGED INSTRUCTION: cli at 0000h");
  expect_wide("mov rcx, cr3\nmov cr3, rcx", "INSTRUCTION: mov rcx,cr3 at 0000h");
}

TEST(Hostile, APort) {
  expect_broken("in al, 0x60\nret", "uses an input or output port at 0000h", {16, 32, 64});
  expect_broken("out dx, al\nret", "uses an input or output port at 0000h", {16, 32, 64});
}

TEST(Hostile, AFarReturnToNoSegment) {
  expect_broken("retf", "raises a general protection fault (#GP) at 0000h", {32, 64});
}

TEST(Hostile, AWrongReturn) {
  expect_wide("add rsp, 8", "BROKEN");
  expect_wide("mov qword [rsp], 0x5000", "the routine leaves the code, to 5000h");
}

TEST(Hostile, ChangesToWhereItReturns) {
  for (const char* code : {"0x0b0f", "0xfeeb"}) {  // UD2, and a jump to itself
    expect_found(fmt::format("mov rcx, [rsp]\nmov word [rcx], {}\n", code) + multiplies + "ret",
                 {"AGREES", "USES FOREIGN MEMORY: mov word [rcx],"}, {64});
  }
}

TEST(Hostile, BrokenConventions) {
  const ScratchFolder folder;
  const std::string code =
      "bits 64\nlea eax, [rdi+rsi]\ninc rbx\ninc rbp\ninc r12\ninc r13\ninc r14\ninc r15\n"
      "std\npush 0x27f\nfldcw [rsp]\npop rcx\nfld1\nret 8\n";
  expect(
      judged::judge(folder.write("hostile.asm", code), "--as|add|--cases|2000"), 1,
      {"BREAKS its convention in 2,000 cases: it does not keep rbx, rsp, rbp, r12, r13, r14, r15 "
       "and leaves the direction flag set and leaves values on the x87 stack and changes the "
       "control word of the x87"});
}

// A routine that finds what an earlier call left faults.
TEST(Hostile, StateOfTheProcessor) {
  // XMM15, the control word of SSE, CR3 and the base of GS.
  const std::string code =
      "f: movq rcx, xmm15\ntest rcx, rcx\njnz .wrong\nmovq xmm15, rsp\n"
      "push 0x5f80\nstmxcsr [rsp-8]\ncmp dword [rsp-8], 0x1f80\njne .wrong\n"
      "ldmxcsr [rsp]\npop rcx\nmov rcx, cr3\ntest ecx, ecx\njnz .wrong\nmov cr3, rsp\n"
      "mov r8d, eax\nmov ecx, 0xc0000101\nrdmsr\ntest eax, eax\njnz .wrong\ninc eax\nwrmsr\n"
      "mov eax, r8d\n";
  expect_found(code + multiplies + "ret\n.wrong: mov dword [0x300000], 0\n",
               {"AGREES on 5,000 cases"}, {64});
}

TEST(Hostile, SelfModification) {
#ifdef JUDGE_SANITIZED
  GTEST_SKIP() << "the process with AddressSanitizer has too little memory for a million cases";
#endif
  expect_found("call $+5\npop ecx\nmov byte [ecx+10], 0x10\nimul ebx\nshrd eax, edx, 16\nret",
               {"CHANGES ITS OWN CODE: mov byte [ecx+0xa],0x10 at 0006h writes fh"});
  expect_found("lea rcx, [rel last]\nmov byte [rcx-1], 0x10\n" + multiplies + "last: ret",
               {"CHANGES ITS OWN CODE: mov byte [rcx-0x1],0x10 at 0007h writes 10h"}, {64});
}

TEST(Hostile, ForeignMemory) {
  expect_found(multiplies + "mov [0x4000], eax\nret",
               {"USES FOREIGN MEMORY: mov [0x4000],eax at 0006h writes 4000h"}, {32, 64});
}

}  // namespace

// Hostile code leads to a clear message and has no effect.
#include "tests/judge/code/judged.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

using judged::expect;

const std::string multiplies = "|--frame|eax, ebx -> eax|--as|mul";

void expect_broken(const std::string& source, const std::string& what,
                   const std::string& bits = "32") {
  SCOPED_TRACE(source);
  const ScratchFolder folder;
  expect(judged::judge(folder.write("hostile.asm", source), "--bits|" + bits + multiplies), 1,
         {what});
}

TEST(Hostile, AnEndlessLoop) { expect_broken("jmp $", "the routine does not end"); }

TEST(Hostile, ARareEndlessLoop) {
  expect_broken("cmp ebx, 0x20000\nje $\nret", " 2) the routine does not end");
}

TEST(Hostile, AWildJump) {
  expect_broken("mov ebx, 0x5000\njmp ebx", "the routine leaves the code, to 5000h");
}

TEST(Hostile, AWildPointer) {
  expect_broken("mov [0x12345678], eax\nret", "the routine uses memory at 12345678h");
}

TEST(Hostile, ASystemCall) {
  expect_broken("mov eax, 1\nint 0x80\nret", "the routine calls interrupt 80h at 0005h");
}

TEST(Hostile, ASystemCallByAnInstruction) {
  const std::string text = "the routine makes a system call at 000";
  for (const std::string call : {"syscall", "sysenter"}) {
    const std::string source = "imul ebx\nshrd eax, edx, 16\n" + call + "\nret";
    expect_broken(source, text + "6h: routines run without a system");
    expect_broken(source, text + "8h: routines run without a system", "16");
  }
}

TEST(Hostile, AFork) {
  expect_broken("again: mov eax, 2\nint 0x80\njmp again", "the routine calls interrupt 80h");
}

TEST(Hostile, ASystemCallOf64BitCode) {
  // Jumps far into 64-bit code to open a file: the kernel ends the process.
  expect_broken("jmp 0x33:0x10\nalign 16\nbits 64\nmov eax, 2\nsyscall", "BROKEN");
}

TEST(Hostile, HugeMemory) {
  expect_broken("mov edi, 0x100000\nmov ecx, -1\nrep stosd\nret",
                "the routine uses memory at 100000h, where there is none");
}

TEST(Hostile, AStackWithoutEnd) { expect_broken("again: call again", "the routine "); }

TEST(Hostile, AnInstructionOfTheSystem) { expect_broken("hlt", "halts the processor at 0"); }

TEST(Hostile, APort) { expect_broken("in al, 0x60\nret", "uses an input or output port at 0000h"); }

TEST(Hostile, AFarReturnToNoSegment) {
  expect_broken("retf", "raises a general protection fault (#GP) at 0000h");
}

TEST(Hostile, SelfModification) {
#ifdef JUDGE_SANITIZED
  GTEST_SKIP() << "the process with AddressSanitizer has too little memory for a million cases";
#endif
  expect_broken("call $+5\npop ecx\nmov byte [ecx+10], 0x10\nimul ebx\nshrd eax, edx, 16\nret",
                "CHANGES ITS OWN CODE: mov byte [ecx+0xa],0x10 at 0006h writes fh");
}

TEST(Hostile, ForeignMemory) {
  expect_broken("imul ebx\nshrd eax, edx, 16\nmov [0x4000], eax\nret",
                "USES FOREIGN MEMORY: mov [0x4000],eax at 0006h writes 4000h");
}

}  // namespace

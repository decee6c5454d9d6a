// The containers that judge reads.
#include "tests/judge/judged.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

using judged::exe_of;
using judged::expect;
using judged::judge;
using judged::routine;

std::string source_of(const std::string& name) { return command::run({"cat", routine(name)}).out; }

const std::string few = "|--cases|20000";

TEST(Containers, AFlatBinary) {
  const ScratchFolder folder;
  const std::string code = command::assemble("bits 32\n" + source_of("mul"));
  expect(judge(folder.write("code.bin", "xx" + code), judged::in_registers + "|--at|2..0x10" + few),
         0, {"flat binary, routine at 0002h, 32-bit code", "AGREES on 20,000 cases"});
}

TEST(Containers, AComProgram) {
  const ScratchFolder folder;
  const std::string code =
      command::assemble("org 0x100\nbits 16\nret\ncpu 386\n" + source_of("mul_c"));
  expect(judge(folder.write("old.COM", code), "--at|101h|--as|mul" + few), 0,
         {".COM program, routine at 0101h, 16-bit code", "AGREES on 20,000 cases"});
}

TEST(Containers, AnExeThatReadsATableInARelocatedSegment) {
  const ScratchFolder folder;
  // The routine is in segment 2 of the program, its table in the last 16 bytes.
  std::string code =
      std::string(32, '\x90') + command::assemble("bits 16\n" + source_of("halves_from_table"));
  const auto place = 32U + static_cast<unsigned char>(code[code.size() - 4]);
  ASSERT_EQ(code[place - 1], '\xB9');  // MOV CX,imm16
  code[place] = static_cast<char>(code.size() / 16 - 1);
  const std::string options =
      "--at|2:0|--frame|eax, ebx -> eax|--as|mul|--rounding|half-away" + few;
  expect(judge(folder.write("game.exe", exe_of(code, {place})), options), 0,
         {"MZ .EXE, routine at 0000h, 16-bit code", "on Unicorn", "AGREES on 20,000 cases"});
  // Without the relocation DS leads to memory that is not the program's.
  expect(judge(folder.write("game.exe", exe_of(code, {})), options), 1,
         {"WRONG in ", "USES FOREIGN MEMORY: add eax,[bx] at "});
}

TEST(Containers, AFarRoutineThatIsCalledNearIsBroken) {
  const ScratchFolder folder;
  const std::string code = command::assemble("bits 16\nimul bx\nretf");
  expect(judge(folder.write("far.exe", exe_of(code, {})),
               "--frame|ax, bx -> ax|--as|mul|--format|q8_8" + few),
         1, {"BROKEN: for "});
}

TEST(Containers, AFarPascalFunctionInAnExe) {
  const ScratchFolder folder;
  const std::string code = command::assemble("bits 16\n" + source_of("mul_pascal_far"));
  expect(judge(folder.write("turbo.exe", exe_of(code, {})), "--frame|pascal-far|--as|mul" + few), 0,
         {"MZ .EXE", "on Unicorn", "AGREES on 20,000 cases"});
}

TEST(Containers, AnElfObject) {
  const ScratchFolder folder;
  const std::string object = folder.path("fixed.o");
  ASSERT_EQ(command::run({"nasm", "-f", "elf32", "-o", object, routine("mul_cdecl")}).status, 0);
  expect(judge(object, "--symbol|mul_cdecl|--as|mul" + few), 0,
         {"ELF object, routine at 1000h, 32-bit code", "must keep ebx, ebp, esi, edi"});
  const auto missing = judge(object, "--symbol|other|--as|mul");
  command::expect_usage_error(missing, "--symbol 'other': there is none; choose one of mul_cdecl");
}

TEST(Containers, WhatCannotBeReadIsSaid) {
  const ScratchFolder folder;
  command::expect_usage_error(judge(folder.path("none"), "--as|mul"), "none: ");
  command::expect_usage_error(judge(folder.write("bad.asm", "mov ax"), "--as|mul"),
                              "bad.asm: nasm: 1: error: ");
  command::expect_usage_error(judge(folder.write("cut.exe", "MZ"), "--as|mul"), "is cut off");
  command::expect_usage_error(judge(folder.write("code", "\xC3"), "--as|mul|--at|7"),
                              "the routine at 7h is outside the code, 0h to 1h");
}

}  // namespace

// The containers that judge reads.
#include "tests/judge/judged.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

using judged::expect;
using judged::judge;
using judged::routine;

std::string source_of(const std::string& name) { return command::run({"cat", routine(name)}).out; }

std::string word(unsigned value) {
  return {static_cast<char>(value & 0xFFU), static_cast<char>(value >> 8U & 0xFFU)};
}

/// Returns an .EXE of code with relocations at these offsets. The stack segment follows the code.
std::string exe_of(const std::string& code, const std::vector<unsigned>& relocations) {
  const auto size = static_cast<unsigned>(64 + code.size());
  const auto paragraphs = static_cast<unsigned>((code.size() + 15) / 16);
  std::string exe = "MZ" + word(size % 512) + word((size + 511) / 512) +
                    word(static_cast<unsigned>(relocations.size())) + word(4) + word(0x200) +
                    word(0xFFFF) + word(paragraphs) + word(0x1000) + word(0) + word(0) + word(0) +
                    word(0x1C) + word(0);
  for (const unsigned at : relocations) exe += word(at) + word(0);
  exe.resize(64);
  return exe + code;
}

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

TEST(Containers, AnExeWithARelocation) {
  const ScratchFolder folder;
  std::string code = command::assemble("bits 16\n" + source_of("halves_from_data"));
  code[2] =
      static_cast<char>(code.size() / 16 - 1);  // the segment of `half`, counted from the start
  expect(judge(folder.write("game.exe", exe_of(code, {2})),
               "--at|0:0|--frame|eax, ebx -> eax|--as|mul" + few),
         1, {"BROKEN: for 00000000 0003ffff"});  // a near call of a far routine
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
  command::expect_usage_error(missing,
                              "--symbol 'other': there is no such symbol; choose one of mul_cdecl");
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

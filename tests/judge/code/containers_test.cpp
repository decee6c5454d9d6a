// The containers that judge reads.
#include <array>

#include "tests/judge/code/judged.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

using judged::exe_of;
using judged::expect;
using judged::judge;
using judged::routine;
using judged::word;

std::string source_of(const std::string& name) { return command::run({"cat", routine(name)}).out; }

/// The start of an ELF object for the i386 with sections, each the words of its header.
std::string object_of(const std::vector<std::array<unsigned, 10>>& sections,
                      const std::string& rest = "") {
  const auto dword = [](unsigned value) { return word(value & 0xFFFFU) + word(value >> 16U); };
  constexpr unsigned header = 52;
  std::string object = "\177ELF\1\1\1";
  object.resize(16);
  object += word(1) + word(3) + dword(1) + dword(0) + dword(0) + dword(header) + dword(0) +
            word(header) + word(0) + word(0) + word(40) +
            word(static_cast<unsigned>(sections.size())) + word(0);
  for (const auto& one : sections) {
    for (const unsigned value : one) object += dword(value);
  }
  return object + rest;
}

const std::string few = "|--cases|20000";

TEST(Containers, AFlatBinary) {
  const ScratchFolder folder;
  const std::string code = command::assemble("bits 32\n" + source_of("mul"));
  expect(judge(folder.write("code.bin", "xx" + code), judged::in_registers + "|--at|2..0x10" + few),
         0, {"flat binary, routine at 0002h, 32-bit code", "AGREES on 20,000 cases"});
}

TEST(Containers, ASourceWithAnOriginAndMemoryWithoutContents) {
  const ScratchFolder folder;
  const std::string source =
      "org 100h\nmov bx, sp\nmov eax, [bx+2]\nimul dword [bx+6]\nadd eax, [half]\nadc edx, 0\n"
      "shrd eax, edx, 16\nmov [kept], eax\nshld edx, eax, 16\nret\nhalf: dd 8000h\n"
      "section .bss\nkept: resd 1\n";
  expect(judge(folder.write("origin.asm", source), "--as|mul" + few), 0,
         {"routine at 0100h, 16-bit code", "AGREES on 20,000 cases", "no foreign memory is used"});
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

TEST(Containers, AddressesAfterASegmentAreHexadecimal) {
  const ScratchFolder folder;
  const std::string code =
      std::string(0x1F40, '\x90') + command::assemble("bits 16\ncpu 386\n" + source_of("mul_c"));
  const auto file = folder.write("game.exe", exe_of(code, {}));
  for (const char* at : {"0:1f40", "0000:1F40", "1f4:0", "0:1f40h", "0:0x1f40"}) {
    expect(judge(file, std::string("--at|") + at + "|--as|mul" + few), 0,
           {"AGREES on 20,000 cases"});
  }
}

TEST(Containers, AnExeWithASmallStack) {
  const ScratchFolder folder;
  std::string exe = exe_of(
      std::string(1024, '\x90') + command::assemble("bits 16\ncpu 386\n" + source_of("mul_c")), {});
  exe.replace(0x10, 2, judged::word(0x100));  // SP
  expect(judge(folder.write("small.exe", exe), "--at|0:400|--as|mul" + few), 0,
         {"AGREES on 20,000 cases"});
}

TEST(Containers, AnExeOfSeveralSegments) {
  const ScratchFolder folder;
  // More code than a segment has: the first segment has no room for a return address.
  const std::string exe = exe_of(
      std::string(0x18000, '\x90') + command::assemble("bits 16\ncpu 386\n" + source_of("mul_c")),
      {});
  const auto file = folder.write("large.exe", exe);
  expect(judge(file, "--at|1800:0|--as|mul" + few), 0, {"AGREES on 20,000 cases"});
  command::expect_usage_error(judge(file, "--at|0:0|--as|mul"),
                              "the .EXE uses all 64 KiB of the code segment 0h");
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
  command::expect_usage_error(
      missing, "--symbol 'other': there is no such global function; choose one of mul_cdecl");
}

TEST(Containers, ANameWithAControlCharacterIsPrintedWithoutIt) {
  const ScratchFolder folder;
  const std::string made = folder.path("fixed.o");
  ASSERT_EQ(command::run({"nasm", "-f", "elf32", "-o", made, routine("mul_cdecl")}).status, 0);
  std::string object = command::run({"cat", made}).out;
  object.replace(object.find(std::string("\0mul_cdecl\0", 11)) + 1, 9, "mul_cde\tl");
  command::expect_usage_error(judge(folder.write("tab.o", object), "--symbol|mul_cdec|--as|mul"),
                              "choose one of mul_cde?l; did you mean mul_cde?l?");
}

TEST(Containers, WhatCannotBeReadIsSaid) {
  const ScratchFolder folder;
  command::expect_usage_error(judge(folder.path("none"), "--as|mul"), "none: ");
  command::expect_usage_error(judge(folder.write("bad.asm", "mov ax"), "--as|mul"),
                              "bad.asm: nasm: 1: error: ");
  command::expect_usage_error(judge(folder.write("cut.exe", "MZ"), "--as|mul"), "is cut off");
  command::expect_usage_error(judge(folder.write("code", "\xC3"), "--as|mul|--symbol|a\nb"),
                              "--symbol 'a?b': this flat binary has no symbols; use --at");
  command::expect_usage_error(judge(folder.write("code", "\xC3"), "--as|mul|--at|7"),
                              "the routine at 7h is outside the code, 0h to 1h");
}

TEST(Containers, ASourceOfAnotherKindIsNoFlatBinary) {
  const ScratchFolder folder;
  for (const std::string name : {"mul.s", "mul.S", "MUL.PAS"}) {
    command::expect_usage_error(judge(folder.write(name, "ret"), "--as|mul"),
                                name + ": is a source; compile it, as with gcc -c, and give ");
  }
  command::expect_usage_error(judge(folder.write("MUL.OBJ", "\x80"), "--as|mul"),
                              "MUL.OBJ: is an object, but not ELF; link it to a .COM program or");
}

TEST(Containers, AFileThatIsNoMachineCodeSaysWhatToGive) {
  const ScratchFolder folder;
  const auto refuse = [&](const std::string& name, const std::string& text, const char* part) {
    command::expect_usage_error(judge(folder.write(name, text), "--as|mul"), name + part);
  };
  refuse("mine.py", "# \xC3\xA9", ": is no machine code; import fixproof in Python");
  refuse("mine.JS", "x", ": is no machine code; judge a program that reads cases");
  refuse("mul.v", "module mul; endmodule", ": describes hardware; simulate it with a bench");
  refuse("firmware.hex", ":00000001FF", ": does not say for which processor it is; give the ELF");
  refuse("results", "00000000\n\tDE\r\n", ": is text, no machine code; judge a program with --run");
  refuse(
      "mine.o", std::string("\xCF\xFA\xED\xFE\x07\0\0\x01", 8),
      ": is a Mach-O file, and judge reads ELF; compile the source for Linux, or judge a program");
  refuse("mine.wasm", std::string("\0asm\x01\0\0\0", 8), ": is a module of WebAssembly, and");
  refuse("libmine.a", "!<arch>\n\x80", ": is an archive of objects; give one of them");
  refuse("mine.o",
         std::string("\x64\x86\x01", 3) + std::string(17, '\0') + ".text" + std::string(20, '\0'),
         ": is an object for Windows, and judge reads ELF");
  std::string windows = exe_of("\xC3", {});
  windows.resize(0x80);
  windows[0x3C] = '\x70';
  windows.replace(0x70, 4, "PE\0\0", 4);
  refuse("mine.exe", windows, ": is a program or library of Windows, and judge reads ELF");
  // A single byte that is not text makes it code.
  expect(judge(folder.write("code", "\x58\x5A\xC3"), "--as|mul" + few), 1, {"flat binary"});
  expect(judge(folder.write("image.bin", std::string(16, '\xFF')), "--as|mul"), 1,
         {"If it is not for x86, give the ELF file that it was made from.\n"});
}

TEST(Containers, ASmallObjectThatAsksForMuchIsRefused) {
  const ScratchFolder folder;
  const auto refuse = [&](const std::string& object, const std::string& part) {
    command::expect_usage_error(judge(folder.write("hostile.o", object), "--as|mul"), part);
  };
  // name, type, flags, address, offset, size, link, info, alignment, size of an entry
  constexpr std::array<unsigned, 10> zeros{0, 8, 2, 0, 0, 0x100000, 0, 0, 1, 0};
  refuse(object_of(std::vector(2000, zeros)), "more than 1 MiB of code and data");

  constexpr std::array<unsigned, 10> code{0, 1, 6, 0, 0, 16, 0, 0, 1, 0};
  // Each symbol: name, value, size, then global, of section 0. All names are the same 60,000 bytes.
  constexpr unsigned symbols = 3000;
  constexpr unsigned tables = 52 + 3 * 40;
  std::string table;
  for (unsigned i = 0; i < symbols; ++i) {
    table += word(1) + word(0) + std::string(8, '\0') + word(0x12) + word(0);
  }
  const std::array<unsigned, 10> table_header{0, 2, 0, 0, tables, symbols * 16, 2, 0, 1, 16};
  const std::array<unsigned, 10> names{0, 3, 0, 0, tables + symbols * 16, 60'002, 0, 0, 1, 0};
  const std::string strings =
      std::string(1, '\0') + std::string(60'000, 'x') + std::string(1, '\0');
  refuse(object_of({code, table_header, names}, table + strings),
         "the names in the ELF file have more than 4 MiB");
  refuse(object_of(std::vector{code, table_header, names},
                   table + std::string(1, '\0') + "name" + std::string(1, '\0')),
         "choose one of name, name");

  std::vector<std::array<unsigned, 10>> relocations(3000, {0, 9, 0, 0, 0, 64, 0, 0, 1, 8});
  relocations[0] = code;
  refuse(object_of(relocations), "the ELF file is damaged");
}

}  // namespace

// ELF objects with names that they lack, position-independent code, and variables without a
// section.
#include <fstream>
#include <iterator>

#include "tests/judge/code/judged.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

using judged::expect;

/// Assembles an object from 32-bit code.
std::string object_file(const ScratchFolder& folder, const std::string& source) {
  const std::string from = folder.write("object.asm", "bits 32\n" + source);
  std::string to = folder.path("object.o");
  EXPECT_EQ(command::run({"nasm", "-f", "elf32", "-o", to, from}).status, 0) << source;
  return to;
}

command::Run judge_symbol(const std::string& file, const std::string& symbol) {
  return judged::judge(file, "--as|mul|--cases|5000|--symbol|" + symbol);
}

const std::string plain_mul =
    "global mul\nmul: mov eax, [esp+4]\nimul dword [esp+8]\nshrd eax, edx, 16\nret\n";

TEST(JudgeElf, ANameThatOnlyAnotherFunctionUsesIsNoObstacle) {
  const ScratchFolder folder;
  const std::string file =
      object_file(folder, plain_mul +
                              "extern other, table\nglobal reads, calls\n"
                              "calls: call other\nret\n"
                              "reads: mov eax, [esp+4]\nadd eax, [table+400]\nret\n"
                              "section .data\ndd other\n");
  expect(judge_symbol(file, "mul"), 0, {"AGREES on 5,000 cases"});
  expect(judge_symbol(file, "calls"), 1,
         {"the routine uses 'other', which the object does not have, at 101dh; add it with ld -r"});
  expect(judge_symbol(file, "reads"), 1,
         {"the routine uses 'table', which the object does not have, at 1027h; add it with ld -r"});
}

TEST(JudgeElf, A16BitAddressOfAMissingNameIsRefused) {
  const ScratchFolder folder;
  command::expect_usage_error(
      judge_symbol(object_file(folder, plain_mul + "bits 16\nextern other\nmov ax, [other]\n"),
                   "mul"),
      "object.o: the code uses 'other', which the object does not have");
}

TEST(JudgeElf, AWeakNameThatIsMissingIsZero) {
  const ScratchFolder folder;
  expect(judge_symbol(
             object_file(folder,
                         "global mul\nextern hook:weak\nmul: mov eax, hook\nmov ecx, [esp+4]\n"
                         "add eax, ecx\nimul dword [esp+8]\nshrd eax, edx, 16\nret\n"),
             "mul"),
         0, {"AGREES on 5,000 cases"});
}

TEST(JudgeElf, PositionIndependentCode) {
  const ScratchFolder folder;
  // A product by what three kinds of relocations reach: 1 + 2 + 3 - 6 is added to it.
  const std::string file = object_file(
      folder,
      "extern _GLOBAL_OFFSET_TABLE_\nglobal mul, first, thunk:function hidden\nmul: push ebx\n"
      "call thunk\n.here: add ebx, _GLOBAL_OFFSET_TABLE_+$$-.here wrt ..gotpc\n"
      "mov eax, [esp+8]\nimul dword [esp+12]\nshrd eax, edx, 16\n"
      "mov ecx, [ebx+first wrt ..got]\nadd eax, [ecx]\nadd eax, [ebx+second wrt ..gotoff]\n"
      "mov ecx, [third wrt ..got]\nadd eax, [ecx]\nsub eax, 6\npop ebx\nret\n"
      "thunk: mov ebx, [esp]\nret\n"
      "section .data\nglobal third\nfirst: dd 1\nsecond: dd 2\nthird: dd 3\n");
  expect(judge_symbol(file, "mul"), 0, {"AGREES on 5,000 cases"});
}

TEST(JudgeElf, TheThunkOfPositionIndependentCodeIsNoRoutine) {
  const ScratchFolder folder;
  const std::string file = object_file(
      folder,
      plain_mul + "global __x86.get_pc_thunk.ax\n__x86.get_pc_thunk.ax: mov eax, [esp]\nret\n");
  expect(judged::judge(file, "--as|mul|--cases|5000"), 0, {"AGREES on 5,000 cases"});
}

TEST(JudgeElf, AnotherRelocationIsRefused) {
  const ScratchFolder folder;
  command::expect_usage_error(
      judge_symbol(object_file(folder, plain_mul + "extern local\nmov eax, [local wrt ..tlsie]\n"),
                   "mul"),
      "the object has a relocation of type 15; compile with -fno-pic -fno-pie");
}

TEST(JudgeElf, AVariableWithoutASection) {
  const ScratchFolder folder;
  expect(judge_symbol(
             object_file(folder,
                         "common scratch 4:4\ncommon other 4:4\nglobal mul\n"
                         "mul: mov eax, [esp+4]\nimul dword [esp+8]\nmov [scratch], eax\n"
                         "mov dword [other], 5\nmov eax, [scratch]\nshrd eax, edx, 16\nret\n"),
             "mul"),
         0, {"AGREES on 5,000 cases", "no foreign memory is used"});
}

TEST(JudgeElf, AnObjectOfAnotherProcessorIsRefused) {
  const ScratchFolder folder;
  const std::string from = folder.write("wide.asm", "bits 64\nmul: mov rax, rdi\nret\n");
  const std::string to = folder.path("wide.o");
  ASSERT_EQ(command::run({"nasm", "-f", "elf64", "-o", to, from}).status, 0);
  command::expect_usage_error(judge(to, "--bits|32|--as|mul"),
                              "--bits 32: the ELF file has 64-bit code; leave --bits out");
  std::ifstream stream(to, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(stream), {});
  bytes[18] = '\x15';  // e_machine: PowerPC of 64 bits
  command::expect_usage_error(
      judge(folder.write("arm.o", bytes), "--as|mul"),
      "the ELF file is for none of the processors that judge runs: i386, x86-64, ARM, ");
}

}  // namespace

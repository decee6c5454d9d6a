// Routines of 64-bit code: objects, conventions, cases and proofs.
#include "judge/code/register_name.hpp"
#include "tests/judge/code/judged.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

using judged::expect;
using judged::judge;

std::string wide_object(const ScratchFolder& folder, const std::string& source) {
  const std::string from = folder.write("object.asm", "bits 64\ndefault rel\n" + source);
  std::string to = folder.path("object.o");
  EXPECT_EQ(command::run({"nasm", "-f", "elf64", "-o", to, from}).status, 0) << source;
  return to;
}

command::Run judge_source(const std::string& source, const std::string& options) {
  const ScratchFolder folder;
  return judge(wide_object(folder, "global f\nf:\n" + source), options);
}

const std::string product = "movsxd rdi, edi\nmovsxd rsi, esi\nimul rdi, rsi\n";
const std::string quotient = "movsxd rax, edi\nmovsxd rsi, esi\nshl rax, 16\ncqo\nidiv rsi\nret\n";
const std::string as_mul = "--as|mul|--cases|5000";
const std::string and_prove = "|--prove|--timeout|60";

TEST(JudgeWide, RegistersHaveTheNamesOfInstructions) {
  using fixproof::judge::register_named;
  for (const char* name : {"al", "ah", "bh", "cx", "esi", "rax", "rsp", "rdi", "r8", "r15", "r8d",
                           "r12w", "r9b", "r15b", "spl", "bpl", "sil", "dil"}) {
    const auto found = register_named(name);
    ASSERT_TRUE(found) << name;
    EXPECT_EQ(fixproof::judge::name_of(*found), name);
  }
  for (const char* name : {"", "r", "r7", "r16", "r8q", "bl ", "axl", "ral", "rip", "xmm0"}) {
    EXPECT_FALSE(register_named(name)) << name;
  }
  EXPECT_EQ(register_named("ah")->holder(), register_named("rax")->holder());
  EXPECT_EQ(register_named("sil")->holder(), register_named("esi")->holder());
  EXPECT_EQ(register_named("bh")->shift(), 8);
  EXPECT_EQ(register_named("dil")->shift(), 0);
}

TEST(JudgeWide, ProductsAreJudgedAndProven) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const std::string wraps = "lea rax, [rdi+0x8000]\nsar rax, 16\nret\n";
  expect(judge_source(product + wraps, as_mul + and_prove + "|--rounding|half-up|--overflow|wrap"),
         0,
         {"64-bit code, frame sysv", "cases on Unicorn", "64-bit code runs on Unicorn only",
          "must keep rbx, rbp, r12, r13, r14, r15", "PROVEN for all operands (1 path"});
  const std::string saturates =
      "add rdi, 0x8000\nsar rdi, 16\nmov eax, 0x7fffffff\ncmp rdi, rax\ncmovg rdi, rax\n"
      "mov rdx, -0x80000000\ncmp rdi, rdx\nmov eax, edi\ncmovl eax, edx\nret\n";
  expect(judge_source(product + saturates,
                      as_mul + and_prove + "|--rounding|half-up|--overflow|saturate"),
         0, {"PROVEN for all operands (1 path"});
}

TEST(JudgeWide, DefectsAreDisproven) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const std::string rules = as_mul + and_prove + "|--rounding|half-up|--overflow|wrap";
  const std::string tie = "lea rax, [rdi+0x7fff]\nsar rax, 16\nret\n";
  expect(judge_source(product + tie, rules), 1, {"DISPROVEN (1 path"});
  // One wrong pair in 2^64, which no case has.
  const std::string pair =
      "mov eax, esi\nshl rax, 32\nmov ecx, edi\nor rax, rcx\nmov rdx, 0x0123456789abcdef\n"
      "cmp rax, rdx\nsete cl\nmovzx ecx, cl\n" +
      product + "lea rax, [rdi+0x8000]\nsar rax, 16\nadd eax, ecx\nret\n";
  expect(judge_source(pair, rules), 1,
         {"AGREES on 5,000 cases", "DISPROVEN (1 path", "89abcdef 01234567"});
  // The upper halves of the operands' registers hold anything.
  expect(judge_source("imul rdi, rsi\nlea rax, [rdi+0x8000]\nsar rax, 16\nret\n", as_mul), 1,
         {"WRONG in "});
}

TEST(JudgeWide, QuotientsAreProven) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const std::string rules = "--as|div|--cases|5000|--no-result|de" + and_prove;
  expect(judge_source(quotient, rules + "|--rounding|toward-zero|--overflow|wrap"), 0,
         {"PROVEN for all operands (2 paths"});
  expect(judge_source(quotient, rules + "|--rounding|floor|--overflow|wrap"), 1,
         {"DISPROVEN (2 paths"});
  // One ulp more for one divisor, which no case has.
  const std::string one_more =
      "movsxd rax, edi\nmovsxd rcx, esi\nshl rax, 16\ncqo\nidiv rcx\ncmp esi, 0x12345677\n"
      "sete dl\nmovzx edx, dl\nadd eax, edx\nret\n";
  expect(judge_source(one_more, rules + "|--rounding|toward-zero|--overflow|wrap"), 1,
         {"DISPROVEN (2 paths"});
}

TEST(JudgeWide, ConventionsAreKept) {
  const std::string by_name = product + "lea r10, [rdi+0x8000]\nsar r10, 16\nmov r12d, r10d\nret\n";
  expect(judge_source(by_name, as_mul + "|--frame|edi, esi -> r12d keeps rbx, r10b"), 1,
         {"BREAKS its convention", "does not keep r10"});
  expect(judge_source("movsxd rax, ecx\nmovsxd rdx, edx\nimul rax, rdx\nmov [rsp+8], rax\n"
                      "mov [rsp+32], rdx\nadd rax, 0x8000\nsar rax, 16\nret\n",
                      as_mul + "|--frame|ms"),
         0, {"frame ms", "AGREES on 5,000 cases", "no foreign memory is used"});
  expect(judge_source("xor r13d, r13d\n" + product + "lea rax, [rdi+0x8000]\nsar rax, 16\nret\n",
                      as_mul),
         1, {"it does not keep r13"});
  command::expect_usage_error(judge_source("ret\n", as_mul + "|--frame|pascal"),
                              "--frame 'pascal': choose sysv or ms for 64-bit code");
  command::expect_usage_error(judge_source("ret\n", as_mul + "|--frame|rsp, esi -> eax"),
                              "'rsp' is not a register for operands");
  command::expect_usage_error(
      judge(judged::routine("mul"), "--bits|32|--as|mul|--frame|rax, ebx -> eax"),
      "'rax' is not a register for operands");
}

TEST(JudgeWide, PointersAndNumbersOf64Bits) {
  expect(judge_source("mov rax, rdi\nimul rsi\nmov esi, 0x80000000\nadd rax, rsi\nadc rdx, 0\n"
                      "shrd rax, rdx, 32\nret\n",
                      "--as|mul|--format|q32_32|--cases|5000"),
         0, {"AGREES on 5,000 cases", "half-up on all"});
  expect(judge_source("mov dword [rsi], 0x10000\nmov dword [rdx], 0\nret\n",
                      "--as|cos_sin|--cases|5000"),
         1, {"frame sysv"});
}

TEST(JudgeWide, AProtectedStackIsNoForeignMemory) {
  expect(judge_source("mov rax, [fs:0x28]\npush rax\n" + product +
                          "mov rax, rdi\nsar rax, 16\npop rcx\nsub rcx, [fs:0x28]\njne wrong\nret\n"
                          "wrong: hlt\n",
                      as_mul),
         0, {"AGREES on 5,000 cases", "no foreign memory is used"});
}

TEST(JudgeWide, RelocationsOfObjects) {
  const ScratchFolder folder;
  const std::string source =
      "global mul, calls\nextern other\ncommon scratch 8:8\n"
      "mul: call inner\nadd rax, [half]\n"
      "mov [scratch], rax\nmov rax, [scratch]\nsar rax, 16\nret\n"
      "calls: call other\nret\n"
      "section .text.more exec\ninner:\n" +
      product + "mov rax, rdi\nret\nsection .rodata\nhalf: dq 0x8000\n";
  const std::string file = wide_object(folder, source);
  expect(judge(file, as_mul + "|--symbol|mul"), 0, {"AGREES on 5,000 cases"});
  expect(judge(file, as_mul + "|--symbol|calls"), 1,
         {"uses 'other', which the object does not have"});
  command::expect_usage_error(
      judge(file, as_mul),
      "name the routine as FILE:ROUTINE or with --symbol; choose one of mul, calls");
  const std::string runtime = "global __library:function\n__library: ret\n";
  command::expect_usage_error(judge(wide_object(folder, runtime + source), as_mul),
                              "choose one of mul, calls, __library");
}

TEST(JudgeWide, CompiledCodeWithAnOffsetTable) {
  if (!command::has("gcc")) GTEST_SKIP() << "no gcc";
  const ScratchFolder folder;
  const std::string from = folder.write(
      "mine.c",
      "long half = 0x8000;\nint f(int a, int b) { return (int)(((long)a * b + half) >> 16); }\n");
  const std::string to = folder.path("mine.o");
  ASSERT_EQ(command::run({"gcc", "-O2", "-fPIC", "-c", "-o", to, from}).status, 0);
  expect(judge(to, as_mul), 0, {"AGREES on 5,000 cases"});
}

TEST(JudgeWide, ListsAndClocks) {
  const std::string code = product + "lea rax, [rdi+0x8000]\nsar rax, 16\nret\n";
  expect(judge_source(code, "--list"), 0, {"bits 64", "movsxd rdi,edi", "lea rax,[rdi+0x8000]"});
  expect(judge_source(code, as_mul + "|--clocks"), 0, {"clocks are not counted: "});
}

TEST(JudgeWide, TracesShowWholeRegisters) {
  const auto run = judge_source(product + "lea rax, [rdi+0x8000]\nsar rax, 16\nret\n",
                                "--as|mul|--trace|ffff8000 00020000");
  expect(run, 0,
         {"movsxd rdi,edi                 rdi=ffffffffffff8000", "rax=ffffffffffff0000",
          "returns ffff0000"});
}

TEST(JudgeWide, LocalsOnTheStackAreTerms) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  expect(judge_source("push rbp\nmov rbp, rsp\nmov [rbp-20], edi\nmov [rbp-24], esi\n"
                      "mov eax, [rbp-20]\ncdqe\nmov [rbp-8], rax\nmovsxd rdx, [rbp-24]\n"
                      "mov rax, [rbp-8]\nimul rax, rdx\nadd rax, 0x8000\nmov ecx, 16\n"
                      "sar rax, cl\nmov [rbp-8], rax\nmov eax, [rbp-8]\npop rbp\nret\n",
                      as_mul + and_prove + "|--rounding|half-up|--overflow|wrap"),
         0, {"PROVEN for all operands (1 path"});
}

TEST(JudgeWide, LoopsThatEndForAllOperandsAreFollowed) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const std::string adds = "--as|add|--overflow|wrap|--cases|1000" + and_prove;
  const std::string sum = "lea eax, [rdi+rsi]\nret\n";
  // The turns are a constant, or at most as many as there are bits.
  expect(judge_source("mov ecx, 10\n.next: xor edi, 5\ndec ecx\njnz .next\n" + sum, adds), 0,
         {"PROVEN for all operands (1 path"});
  expect(judge_source("movzx ecx, dil\n.next: test ecx, ecx\njz .sum\nshr ecx, 1\njmp .next\n"
                      ".sum: " +
                          sum,
                      adds),
         0, {"PROVEN for all operands (9 paths"});
  expect(
      judge_source("movzx ecx, di\n.next: test ecx, ecx\njz .sum\ndec ecx\njmp .next\n.sum: " + sum,
                   "--as|add|--overflow|wrap|--cases|1" + and_prove),
      0, {"NOT PROVEN, only judged by cases: jz", "there are more than 200 paths"});
}

TEST(JudgeWide, WhatIsNotModelledIsNamed) {
  expect(judge_source("mov rax, rdi\nimul rsi\nshrd rax, rdx, 32\nret\n",
                      "--as|mul|--format|q32_32|--cases|1000|--prove"),
         0, {"NOT PROVEN"});
  expect(judge_source("movsxd rax, edi\nmovsxd rsi, esi\nshl rax, 16\nmov rdx, rax\nsar rdx, 63\n"
                      "xor edx, 1\nxor edx, 1\nidiv rsi\nret\n",
                      "--as|div|--cases|1000|--prove|--timeout|2"),
         1, {"WRONG"});
}

}  // namespace

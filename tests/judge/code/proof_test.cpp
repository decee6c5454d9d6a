// Proofs of routines, and what prevents one.
#include "tests/judge/code/judged.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

using judged::expect;
using judged::judge;
using judged::routine;

const std::string prove = "|--cases|5000|--timeout|60|--prove";

TEST(JudgeProof, RightRoutinesAreProven) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const std::string proven = judged::in_registers + prove;
  expect(judge(routine("mul"), proven + "|--rounding|half-up|--overflow|wrap"), 0,
         {"PROVEN for all operands (1 path"});
  expect(judge(routine("mul_c"), "--as|mul" + prove), 0, {"PROVEN for all operands"});
  expect(judge(routine("mul_cdecl"), "--bits|32|--as|mul" + prove), 0, {"PROVEN for all operands"});
  expect(judge(routine("muldiv"), "--bits|32|--frame|eax, ebx, ecx -> eax|--as|muldiv" + prove), 0,
         {"PROVEN for all operands (2 paths"});
}

TEST(JudgeProof, AConstantInMemoryIsProven) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const ScratchFolder folder;
  const auto source = [](const std::string& half) {
    return "imul ebx\nadd eax, [half]\nadc edx, 0\nshrd eax, edx, 16\nret\nhalf: dd " + half;
  };
  const std::string options = judged::in_registers + prove + "|--rounding|half-up";
  expect(judge(folder.write("half.asm", source("0x8000")), options), 0,
         {"PROVEN for all operands"});
  expect(judge(folder.write("half.asm", source("0x7fff")), options), 1, {"DISPROVEN ("});
}

TEST(JudgeProof, AResultThatDependsOnEarlierCallsIsNotProven) {
  const ScratchFolder folder;
  const std::string source =
      "imul ebx\nshrd eax, edx, 16\nadd eax, [last]\nxor dword [last], 1\nret\nlast: dd 0";
  const auto run = judge(folder.write("state.asm", source), judged::in_registers + prove);
  expect(run, 1, {"STATEFUL: for "});
  EXPECT_EQ(run.out.find("PROVEN"), std::string::npos) << run.out;
}

TEST(JudgeProof, TheListedDivideIsProven) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const ScratchFolder folder;
  const auto file = folder.write("div.asm", command::output_of("list div"));
  expect(judge(file, "--as|div" + prove), 0, {"PROVEN for all operands (8 paths"});
}

TEST(JudgeProof, RulesOfProgramsThatGeneralRulesExpressAreProven) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  expect(judge(routine("mul"), judged::in_registers + prove + "|--rule|rott"), 0,
         {"PROVEN for all operands (1 path"});
  expect(judge(routine("mul"), judged::in_registers + prove + "|--rule|doom"), 1, {"DISPROVEN ("});
}

TEST(JudgeProof, TheDivideOfDoomIsProven) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const std::string divides = "--bits|32|--frame|eax, ebx -> eax|--as|div" + prove;
  expect(judge(routine("doom_div"), divides + "|--rule|doom"), 0,
         {"PROVEN for all operands (3 paths"});
  expect(judge(routine("doom_div"), divides + "|--rule|build"), 1, {"WRONG in", "DISPROVEN ("});
  // A guard that takes the size of 80000000h for a number above 0, on cases that do not have it.
  const ScratchFolder folder;
  const auto cut = folder.write("cut.asm",
                                "mov ecx, eax\ncdq\nxor eax, edx\nsub eax, edx\nshr eax, 14\n"
                                "mov esi, eax\nmov eax, ebx\ncdq\nxor eax, edx\nsub eax, edx\n"
                                "cmp esi, eax\njl .divide\nmov eax, ecx\nxor eax, ebx\ncdq\n"
                                "mov eax, 0x7fffffff\nxor eax, edx\nret\n.divide:\n"
                                "mov eax, ecx\ncdq\nshld edx, eax, 16\nshl eax, 16\nidiv ebx\nret");
  expect(
      judge(
          cut,
          "--bits|32|--frame|eax, ebx -> eax|--as|div|--rule|doom|--cases|20|--timeout|60|--prove"),
      1, {"AGREES on 20 cases", "DISPROVEN ("});
}

TEST(JudgeProof, IdivIsProvenFaultsIncluded) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const ScratchFolder folder;
  const std::string idiv = "cdq\nshld edx, eax, 16\nshl eax, 16\nidiv ebx\nret";
  const std::string divides = "--bits|32|--frame|eax, ebx -> eax|--as|div|--rule|build" + prove;
  expect(judge(folder.write("idiv.asm", idiv), divides), 0, {"PROVEN for all operands (2 paths"});
  const auto tame =
      folder.write("tame.asm", "test ebx, ebx\njz .zero\n" + idiv + "\n.zero: mov eax, 1\nret");
  expect(judge(tame, divides), 1, {"DISPROVEN (", "DE expected, 00000001 said"});
}

TEST(JudgeProof, ARuleWithoutAClaimIsNamed) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  expect(judge(routine("by_fraction"), "--as|mul|--rule|wolf3d" + prove), 0,
         {"AGREES on", "NOT PROVEN, only judged by cases: only mul, div, add and sub "});
}

TEST(JudgeProof, OneWrongCaseIn2To32IsFoundByTheProofAlone) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  expect(judge(routine("one_in_4g"),
               "--frame|ax, bx -> ax|--as|mul|--format|q8_8|--rounding|floor" + prove),
         1,
         {"AGREES on 5,000 cases", "DISPROVEN (",
          "\n  1234 0125 (18.203125 1.14453125): 14d5 expected, 0001 said"});
}

TEST(JudgeProof, AWrongRuleIsDisproven) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  expect(judge(routine("lost_carry"), judged::in_registers + prove + "|--rounding|half-up"), 1,
         {"WRONG in", "DISPROVEN ("});
}

TEST(JudgeProof, WhatIsNotModelledIsNamed) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const ScratchFolder folder;
  const auto file = folder.write("fnop.asm", "imul ebx\nfnop\nshrd eax, edx, 16\nret");
  expect(judge(file, judged::in_registers + prove), 0,
         {"NOT PROVEN, only judged by cases: fnop at 0002h: this instruction is not modelled"});
}

}  // namespace

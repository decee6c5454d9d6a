// Proofs of routines, and what keeps one from being proven.
#include "tests/judge/judged.hpp"
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

TEST(JudgeProof, OneWrongCaseIn2To32IsFoundByTheProofAlone) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  expect(judge(routine("one_in_4g"),
               "--frame|ax, bx -> ax|--as|mul|--format|q8_8|--rounding|floor" + prove),
         1,
         {"AGREES on 5,000 cases", "DISPROVEN (",
          "\n  1234 0125 (18.203 1.145): 14d5 expected, 0001 said"});
}

TEST(JudgeProof, AWrongRuleIsDisproven) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  expect(judge(routine("lost_carry"), judged::in_registers + prove + "|--rounding|half-up"), 1,
         {"WRONG in", "DISPROVEN ("});
}

TEST(JudgeProof, WhatIsNotModelledIsNamed) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const ScratchFolder folder;
  const auto file = folder.write("bsf.asm", "imul ebx\nbsf ecx, eax\nshrd eax, edx, 16\nret");
  expect(judge(file, judged::in_registers + prove), 0,
         {"NOT PROVEN, only judged by cases: bsf ecx,eax at 0002h: this is not modelled"});
}

}  // namespace

// Proofs of routines, and what prevents one.
#include <fmt/format.h>

#include <filesystem>

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

const std::string sums_of_two =
    "--bits|32|--frame|eax, ebx -> eax|--as|add|--overflow|wrap" + prove;

TEST(JudgeProof, ALoopThatOnlyItsConditionEndsIsProven) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const ScratchFolder folder;
  const auto loop =
      folder.write("loop.asm", "add eax, ebx\nand ebx, 7\nagain: dec ebx\njns again\nret");
  expect(judge(loop, sums_of_two), 0, {"PROVEN for all operands (8 paths"});
  // No operand jumps back to the start: a path that seems to do so ends there.
  const auto recursion = folder.write(
      "recursion.asm",
      "start: test ebx, ebx\njs negative\nadd eax, ebx\nret\nnegative: mov ecx, ebx\nnot ecx\n"
      "test ecx, ecx\nmov ebx, ecx\njs start\nsub eax, ecx\ndec eax\nret");
  expect(judge(recursion, sums_of_two), 0, {"PROVEN for all operands (2 paths"});
}

TEST(JudgeProof, TooManyPathsAreNamed) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const ScratchFolder folder;
  std::string source = "add eax, ebx\n";
  for (int bit = 0; bit < 8; ++bit) {
    source += fmt::format("test bl, {}\njz over{}\nnop\nover{}:\n", 1 << bit, bit, bit);
  }
  expect(judge(folder.write("many.asm", source + "ret"), sums_of_two), 0,
         {"NOT PROVEN, only judged by cases: ", "there are more than 200 paths"});
}

TEST(JudgeProof, ALoadFromAChosenAddressTakesTheChosenOne) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const ScratchFolder folder;
  // Adds what the sign of EBX chooses from memory: 0 or, which the code takes off again, 1.
  const auto source = [](const std::string& plus, const std::string& minus) {
    return "mov ecx, plus\nmov edx, minus\ntest ebx, ebx\ncmovs ecx, edx\nadd eax, ebx\n"
           "add eax, [ecx]\nshr ebx, 31\nsub eax, ebx\nret\nplus: dd " +
           plus + "\nminus: dd " + minus;
  };
  expect(judge(folder.write("right.asm", source("0", "1")), sums_of_two), 0,
         {"PROVEN for all operands (1 path"});
  expect(judge(folder.write("minus.asm", source("0", "0")), sums_of_two), 1, {"DISPROVEN (1 path"});
  expect(judge(folder.write("plus.asm", source("1", "1")), sums_of_two), 1, {"DISPROVEN (1 path"});
}

TEST(JudgeProof, WhatTheStackHoldsMayBeAnything) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const ScratchFolder folder;
  // No case has that word there.
  const auto depends =
      folder.write("depends.asm",
                   "add eax, ebx\ncmp dword [esp - 8], 0x12345678\njne right\ninc eax\nright: ret");
  expect(judge(depends, sums_of_two), 0,
         {"AGREES on 5,000 cases", "NOT PROVEN", "the counterexample is right when run"});
  const auto cancels = folder.write(
      "cancels.asm", "add eax, ebx\nmov ecx, [esp - 8]\nsub ecx, [esp - 8]\nadd eax, ecx\nret");
  expect(judge(cancels, sums_of_two), 0, {"PROVEN for all operands (1 path"});
}

TEST(JudgeProof, OneWrongPairIn2To64IsFoundByTheProofAlone) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const ScratchFolder folder;
  const std::string is_pair =
      "mov ecx, eax\nxor ecx, 0x12345678\nmov edi, ebx\nxor edi, 0x9abcdef0\nor ecx, edi\n"
      "mov ecx, 0\nsete cl\n";
  const auto product =
      folder.write("product.asm", is_pair + "imul ebx\nshrd eax, edx, 16\nadd eax, ecx\nret");
  // The expected words are those of integers of any size.
  expect(judge(product, judged::in_registers + prove + "|--rounding|floor|--overflow|wrap"), 1,
         {"AGREES on 5,000 cases", "DISPROVEN (1 path",
          "\n  12345678 9abcdef0 (4660.33777 -25923.12915): 93d6242d expected, 93d6242e said"});
  const auto quotient = folder.write(
      "quotient.asm", is_pair + "cdq\nshld edx, eax, 16\nshl eax, 16\nidiv ebx\nadd eax, ecx\nret");
  const std::string divides = "--bits|32|--frame|eax, ebx -> eax|--as|div" + prove;
  for (const char* const rules : {"|--rule|build", "|--rounding|toward-zero|--overflow|any"}) {
    expect(judge(quotient, divides + rules), 1,
           {"AGREES on 5,000 cases", "DISPROVEN (2 paths",
            "\n  12345678 9abcdef0 (4660.33777 -25923.12915): ffffd1fb expected, ffffd1fc said"});
  }
}

TEST(JudgeProof, ATerminalShowsThePathWhileASolverWorks) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  if (!command::has("script")) GTEST_SKIP() << "no script, which makes a terminal";
  const ScratchFolder folder;
  // Takes a second for the question about the routine, and none for the test questions.
  const auto slow = folder.write(
      "z3",
      "#!/bin/sh\nPATH=${PATH#*:}\ncase \"$*\" in *-in*) ;; *) exec z3 \"$@\" ;; esac\n"
      "text=$(cat)\ncase $text in *sfault128*) sleep 1 ;; esac\n"
      "printf '%s\\n' \"$text\" | exec z3 \"$@\"\n");
  std::filesystem::permissions(slow, std::filesystem::perms::owner_all);
  const auto shown = command::run(
      {"sh", "-c",
       R"(PATH=$1:$PATH script -qefc "$2 judge $3 --bits 32 --as mul --frame 'eax, ebx -> eax' --cases 1000 --prove" /dev/null)",
       "sh", folder.path(""), paths::command(), routine("mul")});
  command::expect_contains(shown.out, "\rpath 1 of 1, 0 s\x1b[K");
  command::expect_contains(shown.out, "PROVEN\x1b[0m for all operands");
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

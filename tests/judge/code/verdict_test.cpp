// Right and subtly wrong routines. Their comments say what each verdict must be.
#include "tests/judge/code/judged.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"
#include "verify/machine_code/host_segment.hpp"

namespace {

using judged::expect;
using judged::in_registers;
using judged::judge;
using judged::routine;

// Some systems make no segments for code of this processor.
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): it ends the test
#define SKIP_WITHOUT_SEGMENTS()                                                      \
  if (const auto why = fixproof::machine_code::HostSegment::absence(); !why.empty()) \
  GTEST_SKIP() << why

/// Runs a routine of two registers behind STI, which only Unicorn executes.
command::Run judge_on_unicorn(const std::string& name) {
  const ScratchFolder folder;
  const std::string source = "sti\n" + command::run({"cat", routine(name)}).out;
  return judge(folder.write(name + ".asm", source), in_registers + "|--cases|5000");
}

TEST(Judge, ARightMultiplyAgrees) {
  expect(judge(routine("mul"), in_registers + "|--rounding|half-up|--overflow|wrap"), 0,
         {"AGREES on 1,039,204 cases", "half-up on all 644,778 cases in range",
          "changes registers eax, edx",
          "no undefined flag is read, no foreign memory is used, no instruction is changed"});
}

TEST(Judge, FindsTheRoundingThatNobodyNamed) {
  expect(judge(routine("mul_c"), "--as|mul|--cases|50000"), 0,
         {"mul q16_16: half-up, the rounding that fits best", "AGREES on 50,000 cases",
          "must keep bp, si, di"});
}

TEST(Judge, FindsTheOperationThatNobodyNamed) {
  expect(judge(routine("mul_c"), "--as|?|--cases|20000"), 0,
         {"mul          100.0 % of", "mul q16_16: half-up", "AGREES on 20,000 cases"});
}

TEST(Judge, FindsTheProgramWhoseRuleFits) {
  const std::string in_pair = "--bits|32|--frame|eax, ebx -> eax";
  expect(judge(routine("doom_div"), in_pair + "|--as|?"), 0,
         {"div q16_16: the rule doom (FixedDiv), which fits", "AGREES on 1,039,204 cases",
          "follows the rule doom on all 1,039,204 cases"});
  expect(judge(routine("allegro_div"), in_pair + "|--as|div"), 0,
         {"div q16_16: the rule allegro-i386 (fixdiv), which fits", "AGREES on 1,039,204 cases"});
  // What the user expects of an overflow counts, whatever program has that rounding.
  expect(
      judge(routine("doom_div"), in_pair + "|--as|div|--overflow|de|--no-result|de|--cases|20000"),
      1, {"WRONG in "});
  // A rounding that fits all cases is told first.
  expect(judge(routine("mul"), in_registers + "|--cases|20000"), 0,
         {"mul q16_16: half-up, the rounding that fits best",
          "follows the rule rott on all 20,000 cases"});
}

TEST(Judge, JudgesByTheRuleOfAProgram) {
  expect(judge(routine("by_fraction"), "--as|mul|--rule|wolf3d"), 0,
         {"mul q16_16: the rule wolf3d (FixedByFrac)", "AGREES on 1,039,204 cases",
          "rounding         toward-zero on all 1,039,204 cases in range"});
  // A product by a number in two's complement is another one.
  expect(judge(routine("mul_c"), "--as|mul|--rule|wolf3d|--cases|20000"), 1,
         {"smallest: 00000003 ffffffff (0.00005 -0.99998): fffffffe expected, 00000000 said"});
  expect(judge(routine("doom_div"),
               "--bits|32|--frame|eax, ebx -> eax|--as|div|--rule|chocolate-doom"),
         1, {"follows the rule doom on all 1,039,204 cases", ": 00000000 expected, DE said"});
}

TEST(Judge, TiesOfNegativesHaveThatInCommon) {
  expect(judge(routine("ties_of_negatives"), in_registers + "|--rounding|half-up"), 1,
         {"WRONG in 100,538 of 1,039,204 cases",
          "smallest: 00000001 ffff8000 (0.00002 -0.5): 00000000 expected, ffffffff said",
          "every wrong case is an exact tie", "every wrong case has an exact result below 0",
          "half-away on all 644,778 cases in range"});
}

TEST(Judge, ALostCarryIsFound) {
  expect(judge(routine("lost_carry"), in_registers + "|--rounding|half-up"), 1,
         {"WRONG in", "smallest: ",
          "every wrong result is 1.0 too low, as if a carry from the fraction were lost"});
}

TEST(Judge, AnUndefinedFlagIsNamed) {
  expect(judge(routine("undefined_flag"), in_registers + "|--cases|20000"), 1,
         {"AGREES on 20,000 cases", "READS AN UNDEFINED FLAG: js 0x4 at 0002h reads SF"});
}

TEST(Judge, ARegisterThatIsNotKeptIsNamed) {
  expect(judge(routine("breaks_si"), "--as|mul|--cases|20000"), 1,
         {"AGREES on 20,000 cases", "BREAKS its convention in 20,000 cases: it does not keep si"});
}

TEST(Judge, ADirectionFlagThatIsLeftSetIsNamed) {
  SKIP_WITHOUT_SEGMENTS();
  const std::string named =
      "BREAKS its convention in 5,000 cases: it leaves the direction flag set, ";
  expect(judge(routine("leaves_direction"), in_registers + "|--cases|5000"), 1,
         {"AGREES on 5,000 cases", named});
  expect(judge_on_unicorn("leaves_direction"), 1,
         {"(it faults on this processor, but not on Unicorn)", "AGREES on 5,000 cases", named});
}

TEST(Judge, ValuesThatAreLeftOnTheX87StackAreNamed) {
  const std::string named =
      "BREAKS its convention in 5,000 cases: it leaves values on the x87 stack, first for ";
  expect(judge(routine("leaves_x87"), in_registers + "|--cases|5000"), 1,
         {"AGREES on 5,000 cases", named});
  expect(judge_on_unicorn("leaves_x87"), 1, {" on Unicorn ", "AGREES on 5,000 cases", named});
}

TEST(Judge, ASegmentRegisterThatIsNotKeptIsNamed) {
  const ScratchFolder folder;
  // A later call that kept this DS would read another factor.
  const std::string source =
      "mov cx, [factor]\nimul cx\nimul bx\nmov al, ah\nmov ah, dl\nmov cx, ds\n"
      "inc cx\nmov ds, cx\nret\nfactor: dw 1\n";
  const std::string options = "--frame|ax, bx -> ax|--as|mul|--format|q8_8|--cases|5000";
  expect(judge(folder.write("ds.asm", source), options), 1,
         {" on Unicorn ", "AGREES on 5,000 cases",
          "BREAKS its convention in 5,000 cases: it changes DS or SS, first for "});
  expect(judge(folder.write("es.asm",
                            "mov cx, 0x50\nmov es, cx\nimul bx\nmov al, ah\nmov ah, dl\nret\n"),
               options),
         0, {" on Unicorn ", "AGREES on 5,000 cases"});
}

TEST(Judge, EveryDefectOfAReturnIsNamed) {
  const ScratchFolder folder;
  const std::string source =
      "imul ebx\nshrd eax, edx, 16\npush ecx\nfnstcw [esp]\nor byte [esp+1], 12\nfldcw [esp]\n"
      "pop ecx\nfld1\nstd\nret\n";
  expect(
      judge(folder.write("all.asm", source),
            "--bits|32|--frame|eax, ebx -> eax keeps edx, ecx|--as|mul|--cases|5000"),
      1,
      {"it does not keep ecx, edx and leaves the direction flag set and leaves values on the x87 "
       "stack and changes the control word of the x87, first for "});
}

TEST(Judge, AFaultForOneDivisorIsFound) {
  expect(judge(routine("faults_for_four"),
               "--bits|32|--frame|eax, ebx -> eax|--as|div|--rounding|toward-zero"),
         1, {"smallest: 00000000 00040000 (0 4): 00000000 expected, DE said"});
}

TEST(Judge, AResultThatDependsOnNoiseIsUnsteady) {
  expect(judge(routine("own_noise"), in_registers + "|--cases|5000|--rounding|floor"), 1,
         {"UNSTEADY: for ", "WRONG in"});
}

TEST(Judge, AResultThatDependsOnEarlierCallsIsStateful) {
  const ScratchFolder folder;
  const std::string source =
      "imul ebx\nshrd eax, edx, 16\ninc dword [calls]\nmov ecx, [calls]\nand ecx, 1\nadd eax, ecx\n"
      "ret\ncalls: dd 0\n";
  const auto run = judge(folder.write("state.asm", source), in_registers + "|--cases|5000");
  expect(run, 1,
         {"mul q16_16: any rounding; overflow any\n",
          "the result depends on earlier calls: inc dword [dword 0x18] at 0006h reads 18h, and "
          "inc dword [dword 0x18] at 0006h writes it. No rule is tried: the operands alone do not "
          "decide the result\n\n40 calls step by step"});
  EXPECT_EQ(run.out.find("expected"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("UNSTEADY"), std::string::npos) << run.out;
  // What the routine writes before it reads it is no state.
  expect(judge(folder.write("scratch.asm",
                            "imul ebx\nshrd eax, edx, 16\nmov [last], eax\n"
                            "mov eax, [last]\nret\nlast: dd 0\n"),
               in_registers + "|--cases|5000"),
         0, {"AGREES on 5,000 cases"});
}

TEST(Judge, ACaseThatIsNotWrongAgainIsNotTheSmallest) {
  const ScratchFolder folder;
  // What an earlier call left below the stack pointer is not memory of the routine.
  const std::string source =
      "imul ebx\nshrd eax, edx, 16\nmov ecx, [esp-64]\nand ecx, 1\nadd eax, ecx\n"
      "inc dword [esp-64]\nret\n";
  const auto run = judge(folder.write("stack.asm", source), in_registers + "|--cases|5000");
  expect(run, 1, {"UNSTEADY: for ", "the result differs from call to call", "WRONG in"});
  EXPECT_EQ(run.out.find("00000000 expected, 00000000 said"), std::string::npos) << run.out;
}

TEST(Judge, AResultThatDependsOnTheProcessorIsUnsteady) {
  SKIP_WITHOUT_SEGMENTS();
  const ScratchFolder folder;
  const std::string source =
      "imul ebx\nshrd eax, edx, 16\nmov edi, eax\nmov eax, 1\ncpuid\nadd eax, edi\nret\n";
  expect(judge(folder.write("cpuid.asm", source), in_registers + "|--cases|5000"), 1,
         {"the result on Unicorn is not that on this processor"});
}

TEST(Judge, FloatingPointStartsAlikeOnBothMachines) {
  expect(judge(routine("x87_floor"), in_registers + "|--cases|5000"), 0,
         {"AGREES on 5,000 cases", "floor on all"});
  // The control words and the tags of a new process on Linux.
  const ScratchFolder folder;
  const auto expect_state = [&](const std::string& store, const std::string& result) {
    const std::string source = "sub esp, 28\nmov dword [esp], 0\n" + store + "\nadd esp, 28\nret";
    expect(judge(folder.write("state.asm", source), in_registers + "|--trace|00000001 00000001"), 0,
           {"returns " + result});
  };
  expect_state("fnstcw [esp]\nmov eax, [esp]", "0000037f");
  expect_state("fnstenv [esp]\nmovzx eax, word [esp+8]", "0000ffff");
  expect_state("stmxcsr [esp]\nmov eax, [esp]", "00001f80");
}

TEST(Judge, EveryCallStartsWithTheFloatingPointOfANewProcess) {
  const ScratchFolder folder;
  // A word that is not the initial one is added to the result. Then the words change.
  const std::string source =
      "imul ebx\nshrd eax, edx, 16\nsub esp, 4\nstmxcsr [esp]\nadd eax, [esp]\nsub eax, 0x1F80\n"
      "or dword [esp], 0x6000\nldmxcsr [esp]\nmov dword [esp], 0\nfnstcw [esp]\nadd eax, [esp]\n"
      "sub eax, 0x37F\nmov dword [esp], 0xF7F\nfldcw [esp]\nadd esp, 4\nret\n";
  const auto file = folder.write("words.asm", source);
  const auto on_unicorn = folder.write("unicorn.asm", "sti\n" + source);
  for (const std::string& path : {file, on_unicorn}) {
    expect(judge(path, in_registers + "|--cases|5000"), 1,
           {"AGREES on 5,000 cases", "it changes the control word of the x87, first for "});
  }
}

TEST(Judge, AnX87ExceptionIsNoDivideError) {
  SKIP_WITHOUT_SEGMENTS();
  const ScratchFolder folder;
  const std::string source =
      "imul ebx\nshrd eax, edx, 16\npush dword 0x37B\nfldcw [esp]\nfld1\nfldz\nfdivp\nfwait\n"
      "pop ecx\nret\n";
  expect(judge(folder.write("divides_by_zero.asm", source), in_registers + "|--cases|5000"), 1,
         {"(it faults on this processor, but not on Unicorn)"});
}

TEST(Judge, ARoutineMaySwitchAlignmentChecksOn) {
  SKIP_WITHOUT_SEGMENTS();
  const ScratchFolder folder;
  const std::string source =
      "imul ebx\nshrd eax, edx, 16\npushfd\nor dword [esp], 0x40000\npopfd\n";
  const auto expect_agreement = [&](const std::string& rest, const std::string& where) {
    expect(judge(folder.write("alignment.asm", source + rest), in_registers + "|--cases|5000"), 0,
           {where, "AGREES on 5,000 cases"});
  };
  expect_agreement("ret\n", " on this processor ");
  expect_agreement("mov ecx, [esp-3]\nret\n", "(it faults on this processor, but not on Unicorn)");
}

TEST(Judge, AFaultOnTheProcessorAloneIsANote) {
  SKIP_WITHOUT_SEGMENTS();
  const ScratchFolder folder;
  const std::string source = "imul ebx\nshrd eax, edx, 16\nmovaps xmm0, [esp+8]\nret\n";
  expect(judge(folder.write("misaligned.asm", source), in_registers + "|--cases|5000"), 0,
         {"(it faults on this processor, but not on Unicorn)", "AGREES on 5,000 cases"});
}

TEST(Judge, AProductOverADivisor) {
  expect(
      judge(routine("muldiv"), "--bits|32|--frame|eax, ebx, ecx -> eax|--as|muldiv|--cases|100000"),
      0, {"mul_div q16_16: toward-zero, the rounding that fits best"});
}

TEST(Judge, ListedRoutinesOfSeveralWordsAgree) {
  const ScratchFolder folder;
  for (const auto& [operation, as, rule] :
       {std::tuple("cossin", "cos_sin", "the nearest words"),
        std::tuple("xformvec", "transform", "each product half-up")}) {
    const auto file = folder.write(std::string(operation) + ".asm",
                                   command::output_of(std::string("list ") + operation));
    expect(judge(file, std::string("--cases|20000|--as|") + as), 0,
           {"AGREES on 20,000 cases", rule});
  }
}

TEST(Judge, ATraceHasEachInstruction) {
  for (const char* operands : {"00018000 00020000", "1.5, 0x20000"}) {
    expect(judge(routine("mul"), in_registers + "|--trace|" + operands), 0,
           {"0000  imul ebx                       eax=00000000 edx=00000003", "000e  ret",
            "returns 00030000"});
  }
}

TEST(Judge, ATraceSaysHowACallEnds) {
  const ScratchFolder folder;
  const std::string words = in_registers + "|--trace|00018000 00020000";
  expect(judge(folder.write("divides.asm", "xor ecx, ecx\ndiv ecx\nret\n"), words), 0,
         {"0002  div ecx\nraises a divide error (#DE) at 0002h\n"});
  expect(judge(folder.write("waits.asm", "again: jmp again\n"), words), 0, {"\ndoes not end\n"});
}

TEST(Judge, DecimalAdjustmentsDefineAndReadFlags) {
  const ScratchFolder folder;
  // MUL leaves ZF and AF undefined. AAM defines ZF, and DAA reads AF.
  const auto expect_of = [&](const std::string& name, int status, const std::string& said) {
    const std::string source = "imul ebx\nshrd eax, edx, 16\nmov ecx, eax\nmul dl\n" + name +
                               "\njz done\ndone: mov eax, ecx\nret\n";
    expect(judge(folder.write(name + ".asm", source), in_registers + "|--cases|5000"), status,
           {said});
  };
  expect_of("aam", 0, "no undefined flag is read");
  expect_of("aad", 0, "no undefined flag is read");
  expect_of("daa", 1, "READS AN UNDEFINED FLAG: daa");
}

TEST(Judge, TheStackOf32BitRoutinesIsAligned) {
  const ScratchFolder folder;
  // The routine answers 0 if ESP + 4 is not a multiple of 16 where it begins.
  const std::string source =
      "bits 32\nmov eax, [esp+4]\nimul dword [esp+8]\nshrd eax, edx, 16\nlea ecx, [esp+4]\n"
      "test ecx, 15\njz done\nxor eax, eax\ndone: ";
  for (const auto& [frame, ending] : {std::pair("c", "ret\n"), std::pair("stdcall", "ret 8\n")}) {
    const auto file = folder.write("stack.asm", source + ending);
    expect(judge(file, std::string("--as|mul|--cases|5000|--frame|") + frame), 0,
           {"AGREES on 5,000 cases"});
  }
}

TEST(Judge, AListingAssemblesAgain) {
  const ScratchFolder folder;
  for (const char* name : {"mul", "mul_c", "mul_cdecl", "faults_for_four", "one_in_4g"}) {
    const std::string bits = std::string(name) == "mul_c" ? "16" : "32";
    const auto listed = judge(routine(name), "--list|--bits|" + bits);
    EXPECT_EQ(listed.status, 0) << listed.err;
    const std::string source = command::run({"cat", routine(name)}).out;
    EXPECT_EQ(command::hex(command::assemble(listed.out)),
              command::hex(command::assemble("bits " + bits + "\n" + source)))
        << listed.out;
  }
}

}  // namespace

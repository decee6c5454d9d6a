// Options and files that users get wrong.
#include "tests/judge/code/judged.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

using judged::expect;
using judged::in_registers;
using judged::judge;
using judged::routine;

TEST(JudgeOptions, AListingRefusesWhatHasNoEffect) {
  for (const std::string option :
       {"--as|mul", "--frame|c", "--format|q8_8", "--rule|doom", "--rounding|floor",
        "--overflow|wrap", "--no-result|de", "--cases|5", "--level|2", "--seed|3", "--shard|1/2",
        "--show|1", "--prove", "--clocks", "--trace|00000001 00000001"}) {
    command::expect_usage_error(
        judge(routine("mul"), "--bits|32|--list|" + option),
        option.substr(0, option.find('|')) + " has no effect with --list; leave it out");
  }
  EXPECT_EQ(judge(routine("mul"), "--bits|32|--at|0|--list").status, 0);
}

TEST(JudgeOptions, ATraceRefusesWhatHasNoEffect) {
  for (const std::string option :
       {"--rule|doom", "--rounding|floor", "--overflow|wrap", "--no-result|de", "--cases|5",
        "--level|2", "--seed|3", "--shard|1/2", "--show|1", "--prove", "--clocks"}) {
    command::expect_usage_error(
        judge(routine("mul"), in_registers + "|--trace|00000001 00000001|" + option),
        option.substr(0, option.find('|')) + " has no effect with --trace; leave it out");
  }
  expect(judge(routine("mul"), in_registers + "|--format|q8_24|--at|0|--trace|01000000 01000000"),
         0, {"returns "});
}

TEST(JudgeOptions, ASolverNeedsAProof) {
  command::expect_usage_error(judge(routine("mul"), in_registers + "|--timeout|5"),
                              "--timeout requires --prove");
  command::expect_usage_error(judge(routine("mul"), in_registers + "|--solver|z3"),
                              "--solver requires --prove");
}

TEST(JudgeOptions, AFileWhoseNameLooksLikeAnOption) {
  const ScratchFolder folder;
  const std::string command =
      "cd \"$1\" && exec \"$2\" judge --as mul --bits 32 --cases 5000 --frame "
      "'eax, ebx -> eax' -- \"$3\"";
  const auto judge_there = [&](const std::string& name) {
    return command::run({"sh", "-c", command, "sh", folder.path(), paths::command(), name});
  };
  folder.write("-Pmul.asm", "imul ebx\nshrd eax, edx, 16\nret\n");
  expect(judge_there("-Pmul.asm"), 0, {"AGREES on 5,000 cases"});
  folder.write("-Pbad.asm", "imul\n");
  command::expect_usage_error(judge_there("-Pbad.asm"), "-Pbad.asm: nasm: 1: error: ");
}

TEST(JudgeOptions, CodeOf64Bits) {
  const ScratchFolder folder;
  const std::string source =
      "movsxd rsi, esi\nmovsxd rdi, edi\nimul rdi, rsi\nmov rax, rdi\n"
      "sar rax, 16\nret\n";
  const std::string hint =
      "The code looks like 64-bit code, and ran as 32-bit code: add --bits 64.";
  const std::string code = folder.write("wide.bin", command::assemble("bits 64\n" + source));
  expect(judge(code, "--bits|32|--as|mul|--cases|5000"), 1, {hint});
  const std::string wide = folder.write("wide.asm", "; mine\n[bits 64]\n" + source);
  command::expect_usage_error(judge(wide, "--bits|32|--as|mul"),
                              "--bits 32: the source says bits 64; leave --bits out");
  for (const std::string& right : {code + "|--bits|64", wide}) {
    const auto words = command::split(right, '|');
    expect(judge(words[0],
                 (words.size() > 1 ? "--bits|64|" : "") + std::string("--as|mul|--cases|5000")),
           0, {"64-bit code, frame sysv", "AGREES on 5,000 cases"});
  }
  command::expect_usage_error(
      judge(folder.write("rax.asm", "\nmov rax, rdi"), "--bits|32|--as|mul"),
      "nasm: 2: error: instruction not supported in 32-bit mode; without BITS in the source the "
      "code "
      "has 16 bits: add --bits 32 or 64");
  // A routine that decrements is not 64-bit code.
  const auto other = judge(folder.write("dec.asm", "dec eax\nimul ebx\nshrd eax, edx, 16\nret\n"),
                           in_registers + "|--cases|5000");
  EXPECT_EQ(other.status, 1);
  EXPECT_EQ(other.out.find("64-bit"), std::string::npos) << other.out;
}

TEST(JudgeOptions, ASourceStatesItsWidth) {
  const ScratchFolder folder;
  const std::string mul = "mov eax, [esp+4]\nimul dword [esp+8]\nshrd eax, edx, 16\nret\n";
  for (const std::string start :
       {"bits 32\n", "; mine\n\n  org 0x100\n  [BITS 32] ; 386\n", "global mul\nUSE32\nmul: "}) {
    expect(judge(folder.write("code.asm", start + mul), "--as|mul|--cases|5000"), 0,
           {"32-bit code", "AGREES on 5,000 cases"});
  }
  command::expect_usage_error(
      judge(folder.write("code.asm", "bits 32\n" + mul), "--bits|16|--as|mul"),
      "code.asm: --bits 16: the source says bits 32; leave --bits out");
  // Without a width, 16 bits are assumed, and the verdict says so if the code fails as 32-bit code
  // would.
  const std::string hint = "The code ran as 16-bit code: add --bits 32 if it has 32 bits.\n";
  for (const std::string& file : {folder.write("code.asm", mul),
                                  folder.write("code.bin", command::assemble("bits 32\n" + mul))}) {
    expect(judge(file, "--as|mul|--cases|5000"), 1, {hint});
    EXPECT_EQ(judge(file, "--as|mul|--cases|5000|--bits|16").out.find(hint), std::string::npos);
  }
  const auto endless = judge(folder.write("loop.asm", "jmp $"), "--as|mul");
  EXPECT_EQ(endless.out.find(hint), std::string::npos) << endless.out;
}

TEST(JudgeOptions, ARoundingThatIsNoRule) {
  const auto refuse = [](const std::string& option, const std::string& part) {
    command::expect_usage_error(judge(routine("mul"), in_registers + option), part);
  };
  refuse("|--rounding|nearest",
         "--rounding nearest: to nearest needs a rule for ties; choose half-up, half-away or "
         "half-even");
  refuse("|--rounding|up",
         "--rounding 'up': choose one of half-up, half-away, half-even, floor, "
         "toward-zero, ceiling, faithful, best");
  refuse("|--round|floor", "floor not in {on,off}; did you mean --rounding?");
  expect(judge(routine("mul"), in_registers + "|--rounding|best|--cases|1000"), 0,
         {"mul q16_16: half-up, the rounding that fits best", "AGREES on 1,000 cases"});
}

}  // namespace

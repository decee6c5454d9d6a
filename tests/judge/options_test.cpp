// Options and files that users get wrong.
#include "tests/judge/judged.hpp"
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
    return command::run({"sh", "-c", command, "sh", folder.path(), FIXPROOF_COMMAND, name});
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
      "The code looks like 64-bit code, and ran as 32-bit code: compile with -m32.";
  const std::string code = folder.write("wide.bin", command::assemble("bits 64\n" + source));
  expect(judge(code, "--bits|32|--as|mul|--cases|5000"), 1, {hint});
  expect(judge(folder.write("wide.asm", "bits 64\n" + source), "--bits|32|--as|mul|--cases|5000"),
         1, {hint});
  command::expect_usage_error(
      judge(folder.write("rax.asm", "\nmov rax, rdi"), "--bits|32|--as|mul"),
      "nasm: 2: error: instruction not supported in 32-bit mode; judge runs "
      "code of 16 bits, or with --bits 32 of 32, not of 64");
  // A routine that decrements is not 64-bit code.
  const auto other = judge(folder.write("dec.asm", "dec eax\nimul ebx\nshrd eax, edx, 16\nret\n"),
                           in_registers + "|--cases|5000");
  EXPECT_EQ(other.status, 1);
  EXPECT_EQ(other.out.find("64-bit"), std::string::npos) << other.out;
}

}  // namespace

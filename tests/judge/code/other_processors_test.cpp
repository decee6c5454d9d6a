// Code for processors other than x86: conventions, verdicts, ends of calls, and memory.
#include "tests/judge/code/other_processors.hpp"

#include <elf.h>
#include <fmt/format.h>

#include <set>

#include "judge/code/convention.hpp"
#include "judge/code/frame.hpp"
#include "tests/judge/code/elf_of.hpp"
#include "tests/judge/code/judged.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using elf_of::bytes_of_hex;
using judged::expect;
using judged::judge;
using other_processors::Code;
using other_processors::is_present;
using other_processors::linked;
using other_processors::present;
using other_processors::processor;

/// Returns the line of a verdict that begins with a text.
std::string line_of(const std::string& verdict, const std::string& beginning) {
  const std::size_t at = verdict.find("\n" + beginning);
  if (at == std::string::npos) return "no line '" + beginning + "' in\n" + verdict;
  return verdict.substr(at + 1, verdict.find('\n', at + 1) - at - 1);
}

TEST(OtherProcessors, RightProductsAgree) {
  const ScratchFolder folder;
  for (const Code& code : present()) {
    const auto run = judge(folder.write("f.elf", linked(code, code.mul)), "--as|mul|--cases|5000");
    expect(run, 0,
           {fmt::format("linked ELF file, routine at 10000h, {} code, frame c\n",
                        code.is_thumb ? "Thumb" : code.name),
            "half-up, the rounding that fits best", "AGREES on 5,000 cases\n",
            "no foreign memory is used, no instruction is changed\ninstructions of a call: "});
  }
}

TEST(OtherProcessors, ADefectHasTheSameVerdictOnAll) {
  const ScratchFolder folder;
  std::set<std::string> carries;
  std::set<std::string> ties;
  for (const Code& code : present()) {
    const auto carry = judge(folder.write("f.elf", linked(code, code.lost_carry)),
                             "--as|mul|--cases|20000|--rounding|half-up");
    expect(carry, 1,
           {"every wrong result is 1.0 too low, as if a carry from the fraction were lost"});
    carries.insert(line_of(carry.out, "WRONG") + line_of(carry.out, "  smallest:"));
    const auto tie = judge(folder.write("f.elf", linked(code, code.wrong_ties)),
                           "--as|mul|--cases|20000|--rounding|half-up");
    expect(tie, 1, {"rounding         half-away on all"});
    ties.insert(line_of(tie.out, "WRONG") + line_of(tie.out, "  smallest:"));
  }
  EXPECT_EQ(carries.size(), 1U) << *carries.begin() << '\n' << *carries.rbegin();
  EXPECT_EQ(ties.size(), 1U) << *ties.begin() << '\n' << *ties.rbegin();
}

TEST(OtherProcessors, NumbersOf64BitsArePassedAsTheAbiSays) {
  const ScratchFolder folder;
  for (const Code& code : present()) {
    const auto run = judge(folder.write("f.elf", linked(code, code.add)),
                           "--as|add|--format|q32_32|--overflow|wrap|--cases|5000");
    expect(run, 0, {"AGREES on 5,000 cases\n"});
  }
}

// What the ABIs say of numbers that do not fit into the registers for arguments. Parts have the
// lowest bits first.
class Placed {
 public:
  explicit Placed(const Code& code)
      : architecture_(*judge::architecture_of_elf(linked(code, code.add))), file_(architecture_) {}

  /// @param bits of each parameter
  std::string of(const std::vector<int>& bits) const {
    std::vector<judge::Parameter> parameters;
    for (const int b : bits) parameters.push_back({.bits = b});
    std::string text;
    for (const judge::Passing& passing : judge::convention_of_c(architecture_, parameters, 64).in) {
      text += text.empty() ? "" : " ";
      for (const judge::Part& part : passing.parts) {
        text += &part == &passing.parts.front() ? "" : "+";
        text += part.is_register ? file_.names[part.at] : fmt::format("[{}]", part.at);
      }
    }
    return text;
  }

 private:
  const judge::Architecture& architecture_;
  judge::RegisterFile file_;
};

TEST(OtherProcessors, ArgumentsAreWhereTheAbiHasThem) {
  EXPECT_EQ(Placed(processor("ARM")).of({32, 64, 32}), "r0 r2+r3 [0]");
  EXPECT_EQ(Placed(processor("ARM")).of({64, 32, 64, 32}), "r0+r1 r2 [0]+[4] [8]");
  EXPECT_EQ(Placed(processor("ARM")).of({32, 32, 32, 32, 32, 64}), "r0 r1 r2 r3 [0] [8]+[12]");
  EXPECT_EQ(Placed(processor("AArch64")).of({32, 64, 32}), "x0 x1 x2");
  EXPECT_EQ(Placed(processor("RISC-V of 32 bits")).of({32, 64, 64, 64, 64}),
            "a0 a1+a2 a3+a4 a5+a6 a7+[0]");
  EXPECT_EQ(Placed(processor("RISC-V of 64 bits")).of({64, 32}), "a0 a1");
  EXPECT_EQ(Placed(processor("MIPS")).of({32, 64, 32}), "a0 a2+a3 [16]");
  EXPECT_EQ(Placed(processor("big-endian MIPS")).of({32, 64, 32}), "a0 a3+a2 [16]");
  EXPECT_EQ(Placed(processor("68000")).of({32, 64, 32}), "[4] [12]+[8] [16]");
  EXPECT_EQ(Placed(processor("PowerPC")).of({32, 64, 32}), "r3 r6+r5 r7");
  EXPECT_EQ(Placed(processor("s390x")).of({64, 32, 64, 64, 32, 64}), "r2 r3 r4 r5 r6 [160]");
  EXPECT_EQ(Placed(processor("SPARC")).of({32, 64, 32, 32, 64}), "o0 o2+o1 o3 o4 [92]+o5");
  // The lowest byte first. A byte has the lower one of two registers.
  EXPECT_EQ(Placed(processor("AVR")).of({32, 16, 8}), "r22+r23+r24+r25 r20+r21 r18");
  EXPECT_EQ(Placed(processor("AVR")).of({64, 64, 32, 16}),
            "r18+r19+r20+r21+r22+r23+r24+r25 r10+r11+r12+r13+r14+r15+r16+r17 [3]+[4]+[5]+[6] "
            "[7]+[8]");
}

TEST(OtherProcessors, AnS390xHasAddressesOf64BitsAndFloatingPoint) {
  const ScratchFolder folder;
  // long away(long a, long b) { long p = a * b; return (p + 0x8000 + (p >> 63)) >> 16; } adds by
  // LAY.
  const std::string away = "b90c0023eb12003f000ae32210000871eb220010000a07fe";
  expect(judge(folder.write("f.elf", linked(processor("s390x"), away)),
               "--as|mul|--cases|1000|--frame|long, long -> long"),
         0, {"half-away, the rounding that fits best", "AGREES on 1,000 cases\n"});
  // int sum(int a, int b) { return (int)((double)a + b); }
  const std::string sum = "b3950023b3950002b31a0002b3995020b914002207fe";
  expect(judge(folder.write("f.elf", linked(processor("s390x"), sum)), "--as|add|--cases|1000"), 0,
         {"AGREES on 1,000 cases\n"});
}

TEST(OtherProcessors, AFrameOfRegisters) {
  const ScratchFolder folder;
  const Code& arm = processor("ARM");
  const std::string file = folder.write("f.elf", linked(arm, arm.mul));
  const auto frame = [&](const std::string& text) {
    return judge(file, "--as|mul|--cases|2000|--frame|" + text);
  };
  expect(frame("r1, r0 -> r0"), 0, {"frame r1, r0 -> r0\n", "AGREES on 2,000 cases"});
  expect(frame("r0, r1 -> r0 keeps r3, r4"), 1,
         {"must keep r3, r4\n", "BREAKS its convention in 2,000 cases: it does not keep r3"});
  expect(frame("r0, r1 -> r12"), 1, {"WRONG in"});
  for (const auto& [text, part] :
       {std::pair{"r0, r0 -> r0", "r0 is named twice"},
        {"eax, r0 -> r0", "'eax' is not a register for operands on ARM; choose one of r0, r1, "},
        {"r0, sp -> r0", "'sp' is not a register for operands on ARM"},
        {"r0 -> r0", "name 2 places before -> and one after it"},
        {"[r0], r1 -> r0", "write the registers of pointers, and no others, like [r0]"},
        {"stdcall", "choose c for ARM, or name registers"}}) {
    command::expect_usage_error(frame(text), part);
  }
}

TEST(OtherProcessors, HowACallEnds) {
  const ScratchFolder folder;
  const auto verdict = [&](const char* name, const char* hex) {
    return judge(folder.write("f.elf", linked(processor(name), hex)), "--as|mul|--cases|100").out;
  };
  const auto expect_end = [&](const char* name, const char* hex, const std::string& end) {
    command::expect_contains(verdict(name, hex), end);
  };
  // Endless; a system call; an invalid instruction; memory that is not there; code that is not.
  expect_end("ARM", "feffffea", "the routine does not end");
  expect_end("ARM", "000000ef", "makes a system call at 10000h: routines run without a system");
  expect_end("ARM", "0000a0e3000090e5",
             "the routine uses memory at 0h, where there is none, at 10004h");
  expect_end("ARM", "f000f0e7", "the routine has an invalid instruction at 10000h");
  expect_end("AArch64", "00000014", "the routine does not end");
  expect_end("AArch64", "010000d4", "makes a system call at 1");
  expect_end("AArch64", "000080d2010040f9", "uses memory at 0h, where there is none, at 10004h");
  expect_end("RISC-V of 32 bits", "6f000000", "the routine does not end");
  expect_end("RISC-V of 32 bits", "73000000", "makes a system call at 1");
  expect_end("RISC-V of 64 bits", "73000000", "makes a system call at 1");
  expect_end("RISC-V of 32 bits", "03250000", "uses memory at 0h, where there is none, at 10000h");
  // divu.w #0, d0; rts
  expect_end("68000", "80fc00004e75", "100 cases raise a divide error (#DE)");
  for (const Code& code : present()) {
    const auto run = judge(folder.write("f.elf", linked(code, "")), "--as|mul|--cases|100");
    EXPECT_NE(run.status, 0) << code.name;
  }
}

TEST(OtherProcessors, AFrameOfTheRegistersOfAnAvr) {
  const Code& avr = processor("AVR");
  if (!is_present(avr)) GTEST_SKIP() << "simavr is not installed";
  const ScratchFolder folder;
  const std::string file = folder.write("f.elf", linked(avr, avr.mul));
  const auto frame = [&](const std::string& text) {
    return judge(file, "--as|mul|--cases|500|--frame|" + text);
  };
  const std::string first = "r25:r24:r23:r22";
  expect(frame("r21:r20:r19:r18, " + first + " -> " + first), 0, {"AGREES on 500 cases"});
  expect(frame("r21:r20:r18:r19, " + first + " -> " + first), 1, {"WRONG in"});
  // An int has 16 bits.
  expect(frame("long, long -> long"), 0, {"AGREES on 500 cases"});
  command::expect_usage_error(frame("int, int -> int"), "'int' has 16 bits, and a number of");
  command::expect_usage_error(frame("r24, r25 -> r24"),
                              "a place has 8 bits, and a number has 32; write several registers "
                              "like r1:r0, the highest first");
}

TEST(OtherProcessors, VariablesOfAnAvrAreInItsMemoryForData) {
  const Code& avr = processor("AVR");
  if (!is_present(avr)) GTEST_SKIP() << "simavr is not installed";
  const ScratchFolder folder;
  // add r22, r18; adc r23, r19; adc r24, r20; adc r25, r21; lds r18, 100h; add r22, r18;
  // adc r23, r1; adc r24, r1; adc r25, r1; ret
  const std::string code = bytes_of_hex("620f731f841f951f20910001620f711d811d911d0895");
  const auto verdict = [&](const char* variable, std::uint32_t at) {
    const elf_of::File file{.machine = EM_AVR,
                            .flags = 5,
                            .parts = {{0x80, code}, {at, bytes_of_hex(variable)}},
                            .functions = {{"f", 0x80}}};
    return judge(folder.write("firmware.elf", elf_of::Writer(file).write()),
                 "--as|add|--overflow|wrap|--cases|2000");
  };
  expect(verdict("00", 0x800100), 0, {"AGREES on 2,000 cases"});
  expect(verdict("01", 0x800100), 1, {"every wrong result is 1 ulp too high: all 2,000"});
  command::expect_usage_error(verdict("01", 0x80FF00),
                              "the variables at 80ff00h to 80ff01h are outside the memory for "
                              "data, 800000h to 80f370h");
  // The fuses are no memory.
  expect(verdict("01", 0x820000), 1, {"USES FOREIGN MEMORY: f+8h at 0088h reads 800100h"});
}

TEST(OtherProcessors, WhatIsThereForX86Only) {
  const ScratchFolder folder;
  const Code& arm = processor("ARM");
  const std::string file = folder.write("f.elf", linked(arm, arm.mul));
  for (const std::string option : {"--prove", "--clocks"}) {
    command::expect_usage_error(judge(file, "--as|mul|" + option),
                                option + " is for x86, and this is code for ARM");
  }
  command::expect_usage_error(judge(file, "--list"), "--list is for x86, and this is code for ARM");
  command::expect_usage_error(judge(file, "--as|mul|--bits|16"),
                              "--bits 16: the ELF file has 32-bit");
}

TEST(OtherProcessors, ATraceShowsTheRegisters) {
  const ScratchFolder folder;
  const Code& code = processor("68000");
  const auto run = judge(folder.write("f.elf", linked(code, code.add)),
                         "--as|add|--format|q32_32|--trace|0000000100000002 0000000300000004");
  expect(run, 0, {"10000  f+0h", "d0=00000001", "returns 0000000400000006\n"});
}

TEST(OtherProcessors, TheMemoryOfAMicrocontrollerIsFarFromItsCode) {
  const ScratchFolder folder;
  // ldr r3, [pc, #8]; ldr r3, [r3]; adds r0, r0, r1; adds r0, r0, r3; bx lr; .word 20000000h
  const std::string code = bytes_of_hex("024b1b684018c018704700bf00000020");
  const auto verdict = [&](const char* ram, std::uint32_t at) {
    const elf_of::File file{.machine = EM_ARM,
                            .parts = {{0x8000000, code}, {at, bytes_of_hex(ram)}},
                            .functions = {{"f", 0x8000001}}};
    return judge(folder.write("firmware.elf", elf_of::Writer(file).write()),
                 "--as|add|--overflow|wrap|--cases|2000");
  };
  expect(verdict("00000000", 0x20000000), 0, {"AGREES on 2,000 cases"});
  expect(verdict("01000000", 0x20000000), 1, {"every wrong result is 1 ulp too high: all 2,000"});
  expect(verdict("00000000", 0x30000000), 1,
         {"uses memory at 20000000h, where there is none, at 8000002h"});
}

TEST(OtherProcessors, AnObjectNeedsTheLinkerOfItsToolchain) {
  const ScratchFolder folder;
  std::string object = linked(processor("s390x"), processor("s390x").mul);
  object[17] = '\1';  // e_type: an object
  const std::string file = folder.write("f.o", object);
  const auto run =
      command::run({"env", "PATH=/nowhere", paths::command(), "judge", file, "--as", "mul"});
  command::expect_usage_error(run,
                              "an object for s390x needs the linker of its toolchain, which is not "
                              "installed; install Debian's package gcc-s390x-linux-gnu");
}

}  // namespace

// Tests the output of `fixproof step` against states worked out by hand.
#include <fmt/format.h>

#include "tests/support/command.hpp"
#include "tests/support/test.hpp"

namespace {

constexpr std::string_view zeros =
    "ax=0000 bx=0000 cx=0000 dx=0000 si=0000 di=0000 bp=0000 sp=0000 fl=0000";

/// The registers of a line: those in `given`, such as "cx=0001 fl=0002", and 0 for the others.
std::string state(std::string_view given) {
  std::string result;
  for (const std::string& field : command::split(zeros, ' ')) {
    const std::string name = field.substr(0, field.find('='));
    std::string text = field;
    for (const std::string& other : command::split(given, ' ')) {
      const std::string other_name = other.substr(0, other.find('='));
      if (other_name == name || other_name == "e" + name) text = other;
    }
    result += (result.empty() ? "" : " ") + text;
  }
  return result;
}

void expect_answer(std::string_view cpu, std::string_view line, const std::string& answer) {
  EXPECT_EQ(command::output_of(fmt::format("step --cpu {}", cpu), line), answer + '\n') << line;
}

struct Step {
  std::string_view instruction;
  std::string_view before;  ///< as `after`, an argument of state()
  std::string_view after;
  std::string_view undefined = "-";
};

void expect_steps(const std::vector<std::string_view>& processors, const std::vector<Step>& steps) {
  for (const std::string_view cpu : processors) {
    for (const auto& [instruction, before, after, undefined] : steps) {
      expect_answer(cpu, fmt::format("{} | {}", instruction, state(before)),
                    fmt::format("{} undef={}", state(after), undefined));
    }
  }
}

TEST(StepCommand, OnBothProcessors) {
  expect_steps(
      {"8088", "386"},
      {// ffff + 0 + 1 = 0 sets CF, AF (carry from the low digit), ZF, and PF because no bit is set.
       {"adc bx, dx", "bx=ffff sp=fffe fl=0001", "bx=0000 sp=fffe fl=0055"},
       // signed overflow
       {"add ax, cx", "ax=7fff cx=0001", "ax=8000 cx=0001 fl=0894"},
       {"sub ax, cx", "ax=8000 cx=0001", "ax=7fff cx=0001 fl=0814"},
       {"neg ax", "ax=8000", "ax=8000 fl=0885"},
       // PF depends on the low byte alone.
       {"add ax, 0", "ax=0100", "ax=0100 fl=0004"},
       {"add ax, 0", "ax=0301", "ax=0301"},
       {"cmp bx, 3600", "bx=0e10", "bx=0e10 fl=0044"},
       {"cmp bx, 3600", "bx=0e0f", "bx=0e0f fl=0085"},
       // INC and DEC keep the carry.
       {"inc cx", "cx=ffff fl=0001", "fl=0055"},
       {"inc cx", "cx=ffff fl=0000", "fl=0054"},
       {"dec cx", "cx=0000 fl=0001", "cx=ffff fl=0095"},
       {"dec cx", "cx=0000 fl=0000", "cx=ffff fl=0094"},
       // Logic clears carry and overflow.
       {"and ax, bx", "ax=ff00 bx=8001 fl=0811", "ax=8000 bx=8001 fl=0084", "AF"},
       {"xor cx, 1", "cx=0001 fl=0801", "fl=0044", "AF"},
       // Other bits of FLAGS pass through; f72a has none of the six flags.
       {"mov ax, bx", "bx=1234 fl=f72a", "ax=1234 bx=1234 fl=f72a"},
       {"sub cx, cx", "cx=1234 fl=f72a", "fl=f76e"},
       {"mov ax, bx", "fl=ffff", "fl=ffff"},
       {"mul bx", "ax=ffff bx=ffff", "ax=0001 bx=ffff dx=fffe fl=0801", "PF,AF,ZF,SF"},
       {"mul bx", "ax=00ff bx=00ff dx=1234 fl=0801", "ax=fe01 bx=00ff", "PF,AF,ZF,SF"},
       {"div bx", "ax=0007 bx=0002 fl=08d5", "ax=0003 bx=0002 dx=0001", "CF,PF,AF,ZF,SF,OF"},
       // A shift by one defines OF.
       {"shl bx, 1", "bx=4000", "bx=8000 fl=0884", "AF"},
       {"shl bx, 1", "bx=c000", "bx=8000 fl=0085", "AF"},
       {"shr bx, 1", "bx=8001", "bx=4000 fl=0805", "AF"},
       {"push cx", "cx=1234 sp=0000 fl=08d5", "cx=1234 sp=fffe fl=08d5"},
       // Jumps are not taken.
       {"jns FDP1", "fl=0000", "fl=0000"},
       {"jmp .FixedDivDone", "fl=08d5", "fl=08d5"}});
}

TEST(StepCommand, OnThe386) {
  expect_steps(
      {"386"},
      {{"imul ebx", "eax=ffffffff ebx=00000002 edx=00000000",
        "eax=fffffffe ebx=00000002 edx=ffffffff", "PF,AF,ZF,SF"},
       {"imul ebx", "eax=80000000 ebx=ffffffff edx=00000000",
        "eax=80000000 ebx=ffffffff edx=00000000 fl=0801", "PF,AF,ZF,SF"},
       // -7 / 2 truncates to -3, and the remainder has the sign of the dividend.
       {"idiv ebx", "eax=fffffff9 ebx=00000002 edx=ffffffff",
        "eax=fffffffd ebx=00000002 edx=ffffffff", "CF,PF,AF,ZF,SF,OF"},
       // Shifts by more than one leave OF undefined.
       {"shl bx, 2", "bx=4000", "fl=0045", "AF,OF"},
       {"sar edx, 16", "edx=80008000", "edx=ffff8000 fl=0085", "AF,OF"},
       {"shrd eax, edx, 16", "eax=12345678 edx=9abcdef0", "eax=def01234 edx=9abcdef0 fl=0080",
        "AF,OF"},
       {"shld edx, eax, 16", "eax=12345678 edx=9abcdef0", "eax=12345678 edx=def01234 fl=0080",
        "AF,OF"},
       // A shift by the whole width leaves CF undefined too.
       {"shl bx, 16", "bx=ffff", "fl=0044", "CF,AF,OF"},
       {"shl bx, 15", "bx=ffff", "bx=8000 fl=0085", "AF,OF"},
       // Counts are taken modulo 32.
       {"shl bx, 0", "bx=8000 fl=08d5", "bx=8000 fl=08d5"},
       {"shl bx, 32", "bx=8000 fl=08d5", "bx=8000 fl=08d5"},
       {"shl bx, 33", "bx=8000", "fl=0845", "AF"},
       {"rol eax, 255", "eax=00000002", "eax=00000001 fl=0001", "OF"},
       // A rotation changes CF and OF alone.
       {"rol eax, 16", "eax=00018000 fl=08d4", "eax=80000001 fl=00d5", "OF"},
       {"rol eax, 33", "eax=40000000 fl=00d5", "eax=80000000 fl=08d4"},
       // Words leave the upper half alone.
       {"add ax, bx", "eax=1234ffff ebx=56780001", "eax=12340000 ebx=56780001 fl=0055"},
       {"mul bx", "eax=1234ffff bx=0002 edx=56780000", "eax=1234fffe bx=0002 edx=56780001 fl=0801",
        "PF,AF,ZF,SF"},
       {"mov ax, bx", "eax=00000000 bx=0001 edx=00000007", "eax=00000001 bx=0001 edx=00000007"},
       // A register given as ax returns as eax if its upper half is no longer zero.
       {"neg eax", "ax=0001", "eax=ffffffff fl=0095"},
       {"add eax, ebx", "ax=0001 bx=0001", "ax=0002 bx=0001"}});
}

TEST(StepCommand, DivideErrors) {
  for (const std::string_view cpu : {"8088", "386"}) {
    expect_answer(cpu, "div bx | " + state("ax=0001"), "DE");
    expect_answer(cpu, "div bx | " + state("bx=0001 dx=0001"), "DE");
    expect_answer(cpu, "div dx | " + state("dx=0001"), "DE");
  }
  // A quotient of 2^31 does not fit; -2^31 does.
  expect_answer("386", "idiv ebx | " + state("eax=80000000 ebx=00000001 edx=00000000"), "DE");
  expect_steps({"386"}, {{"idiv ebx", "eax=80000000 ebx=00000001 edx=ffffffff",
                          "eax=80000000 ebx=00000001 edx=00000000", "CF,PF,AF,ZF,SF,OF"}});
}

TEST(StepCommand, SaysWhatIsUnmodelled) {
  // The 8088 has no shift by two and no 32-bit registers.
  const auto run = command::fixproof(
      "step --cpu 8088", fmt::format("shl bx, 2 | {0}\nshl bx, 1 | {0}\nadd eax, ebx | {0}\n"
                                     "imul bx | {0}\n",
                                     zeros));
  EXPECT_EQ(run.out,
            fmt::format("unmodelled\n{} undef=AF\nunmodelled\nunmodelled\n", state("fl=0044")));
  EXPECT_EQ(
      run.err,
      "fixproof step: 3 lines unmodelled, such as shl bx, 2; add eax, ebx; imul bx; the model "
      "has what FIXED.ASM and the inner loops use, on registers: fixproof list forms\n");
  EXPECT_EQ(run.status, 0);
  for (const std::string_view instruction :
       {"or ax, bx", "add al, bl", "mov ax, [bx]", "add word [bp+4], 1", "pop ax", "ret",
        "call FixedMul", "mov ds, ax", "nop", "rol eax, 1", "mov ax, 5", "lodsw", "idiv bl",
        "idiv bx", "div bl", "rep idiv bx", "repne scasb", "lock add ax, bx"}) {
    const auto other =
        command::fixproof("step --cpu 386", fmt::format("{} | {}\n", instruction, zeros));
    EXPECT_EQ(other.out, "unmodelled\n") << instruction;
    EXPECT_TRUE(other.err.starts_with(
        fmt::format("fixproof step: 1 line unmodelled, such as {};", instruction)))
        << other.err;
    EXPECT_EQ(other.status, 0) << instruction;
  }
}

}  // namespace

// Tests the output of `fixproof step` against states worked out by hand.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tests/cli/command.hpp"

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
  const auto run = command::fixproof(fmt::format("step --cpu {}", cpu), fmt::format("{}\n", line));
  EXPECT_EQ(run.out, answer + '\n') << line;
  EXPECT_EQ(run.err, "") << line;
  EXPECT_EQ(run.status, 0) << line;
}

/// Expects a state on both processors. `before` and `after` are arguments of state().
void expect_step(std::string_view instruction, std::string_view before, std::string_view after,
                 std::string_view undefined = "-") {
  for (const std::string_view cpu : {"8088", "386"}) {
    expect_answer(cpu, fmt::format("{} | {}", instruction, state(before)),
                  fmt::format("{} undef={}", state(after), undefined));
  }
}

void expect_step_386(std::string_view instruction, std::string_view before, std::string_view after,
                     std::string_view undefined = "-") {
  expect_answer("386", fmt::format("{} | {}", instruction, state(before)),
                fmt::format("{} undef={}", state(after), undefined));
}

TEST(StepCommand, CarryIntoAnAddition) {
  // ffff + 0 + 1 = 0 sets CF, AF (carry from the low digit), ZF, and PF because no bit is set.
  expect_step("adc bx, dx", "bx=ffff sp=fffe fl=0001", "bx=0000 sp=fffe fl=0055");
}

TEST(StepCommand, SignedOverflow) {
  expect_step("add ax, cx", "ax=7fff cx=0001", "ax=8000 cx=0001 fl=0894");
  expect_step("sub ax, cx", "ax=8000 cx=0001", "ax=7fff cx=0001 fl=0814");
  expect_step("neg ax", "ax=8000", "ax=8000 fl=0885");
}

TEST(StepCommand, ParityLooksAtTheLowByteAlone) {
  expect_step("add ax, 0", "ax=0100", "ax=0100 fl=0004");
  expect_step("add ax, 0", "ax=0301", "ax=0301");
}

TEST(StepCommand, CompareChangesFlagsOnly) {
  expect_step("cmp bx, 3600", "bx=0e10", "bx=0e10 fl=0044");
  expect_step("cmp bx, 3600", "bx=0e0f", "bx=0e0f fl=0085");
}

TEST(StepCommand, IncrementAndDecrementKeepTheCarry) {
  expect_step("inc cx", "cx=ffff fl=0001", "fl=0055");
  expect_step("inc cx", "cx=ffff fl=0000", "fl=0054");
  expect_step("dec cx", "cx=0000 fl=0001", "cx=ffff fl=0095");
  expect_step("dec cx", "cx=0000 fl=0000", "cx=ffff fl=0094");
}

TEST(StepCommand, LogicClearsCarryAndOverflow) {
  expect_step("and ax, bx", "ax=ff00 bx=8001 fl=0811", "ax=8000 bx=8001 fl=0084", "AF");
  expect_step("xor cx, 1", "cx=0001 fl=0801", "fl=0044", "AF");
}

TEST(StepCommand, OtherBitsOfTheFlagsPassThrough) {
  // f72a has none of the six flags.
  expect_step("mov ax, bx", "bx=1234 fl=f72a", "ax=1234 bx=1234 fl=f72a");
  expect_step("sub cx, cx", "cx=1234 fl=f72a", "fl=f76e");
  expect_step("mov ax, bx", "fl=ffff", "fl=ffff");
}

TEST(StepCommand, MultiplyLeavesFourFlagsUndefined) {
  expect_step("mul bx", "ax=ffff bx=ffff", "ax=0001 bx=ffff dx=fffe fl=0801", "PF,AF,ZF,SF");
  expect_step("mul bx", "ax=00ff bx=00ff dx=1234 fl=0801", "ax=fe01 bx=00ff", "PF,AF,ZF,SF");
  expect_step_386("imul ebx", "eax=ffffffff ebx=00000002 edx=00000000",
                  "eax=fffffffe ebx=00000002 edx=ffffffff", "PF,AF,ZF,SF");
  expect_step_386("imul ebx", "eax=80000000 ebx=ffffffff edx=00000000",
                  "eax=80000000 ebx=ffffffff edx=00000000 fl=0801", "PF,AF,ZF,SF");
}

TEST(StepCommand, DivideLeavesAllSixUndefined) {
  expect_step("div bx", "ax=0007 bx=0002 fl=08d5", "ax=0003 bx=0002 dx=0001", "CF,PF,AF,ZF,SF,OF");
  // -7 / 2 truncates to -3, and the remainder has the sign of the dividend.
  expect_step_386("idiv ebx", "eax=fffffff9 ebx=00000002 edx=ffffffff",
                  "eax=fffffffd ebx=00000002 edx=ffffffff", "CF,PF,AF,ZF,SF,OF");
}

TEST(StepCommand, DivideErrors) {
  for (const std::string_view cpu : {"8088", "386"}) {
    expect_answer(cpu, "div bx | " + state("ax=0001"), "DE");
    expect_answer(cpu, "div bx | " + state("bx=0001 dx=0001"), "DE");
    expect_answer(cpu, "div dx | " + state("dx=0001"), "DE");
  }
  // A quotient of 2^31 does not fit; -2^31 does.
  expect_answer("386", "idiv ebx | " + state("eax=80000000 ebx=00000001 edx=00000000"), "DE");
  expect_step_386("idiv ebx", "eax=80000000 ebx=00000001 edx=ffffffff",
                  "eax=80000000 ebx=00000001 edx=00000000", "CF,PF,AF,ZF,SF,OF");
}

TEST(StepCommand, ShiftsByOneDefineTheOverflow) {
  expect_step("shl bx, 1", "bx=4000", "bx=8000 fl=0884", "AF");
  expect_step("shl bx, 1", "bx=c000", "bx=8000 fl=0085", "AF");
  expect_step("shr bx, 1", "bx=8001", "bx=4000 fl=0805", "AF");
}

TEST(StepCommand, ShiftsByMoreDoNot) {
  expect_step_386("shl bx, 2", "bx=4000", "fl=0045", "AF,OF");
  expect_step_386("sar edx, 16", "edx=80008000", "edx=ffff8000 fl=0085", "AF,OF");
  expect_step_386("shrd eax, edx, 16", "eax=12345678 edx=9abcdef0",
                  "eax=def01234 edx=9abcdef0 fl=0080", "AF,OF");
  expect_step_386("shld edx, eax, 16", "eax=12345678 edx=9abcdef0",
                  "eax=12345678 edx=def01234 fl=0080", "AF,OF");
}

TEST(StepCommand, ShiftsByTheWholeWidthLeaveTheCarryUndefined) {
  expect_step_386("shl bx, 16", "bx=ffff", "fl=0044", "CF,AF,OF");
  expect_step_386("shl bx, 15", "bx=ffff", "bx=8000 fl=0085", "AF,OF");
}

TEST(StepCommand, CountsAreTakenModulo32) {
  expect_step_386("shl bx, 0", "bx=8000 fl=08d5", "bx=8000 fl=08d5");
  expect_step_386("shl bx, 32", "bx=8000 fl=08d5", "bx=8000 fl=08d5");
  expect_step_386("shl bx, 33", "bx=8000", "fl=0845", "AF");
  expect_step_386("rol eax, 255", "eax=00000002", "eax=00000001 fl=0001", "OF");
}

TEST(StepCommand, RotationTouchesCarryAndOverflowAlone) {
  expect_step_386("rol eax, 16", "eax=00018000 fl=08d4", "eax=80000001 fl=00d5", "OF");
  expect_step_386("rol eax, 33", "eax=40000000 fl=00d5", "eax=80000000 fl=08d4");
}

TEST(StepCommand, PushMovesTheStackPointer) {
  expect_step("push cx", "cx=1234 sp=0000 fl=08d5", "cx=1234 sp=fffe fl=08d5");
}

TEST(StepCommand, JumpsAreNotTaken) {
  expect_step("jns FDP1", "fl=0000", "fl=0000");
  expect_step("jmp .FixedDivDone", "fl=08d5", "fl=08d5");
}

TEST(StepCommand, WordsLeaveTheUpperHalfAlone) {
  expect_step_386("add ax, bx", "eax=1234ffff ebx=56780001", "eax=12340000 ebx=56780001 fl=0055");
  expect_step_386("mul bx", "eax=1234ffff bx=0002 edx=56780000",
                  "eax=1234fffe bx=0002 edx=56780001 fl=0801", "PF,AF,ZF,SF");
}

TEST(StepCommand, EachRegisterComesBackAsItWasGiven) {
  expect_step_386("mov ax, bx", "eax=00000000 bx=0001 edx=00000007",
                  "eax=00000001 bx=0001 edx=00000007");
  // A register given as ax returns as eax if its upper half is no longer zero.
  expect_step_386("neg eax", "ax=0001", "eax=ffffffff fl=0095");
  expect_step_386("add eax, ebx", "ax=0001 bx=0001", "ax=0002 bx=0001");
}

TEST(StepCommand, The8088HasNoShiftByTwoAndNo32BitRegisters) {
  const auto run = command::fixproof(
      "step --cpu 8088", fmt::format("shl bx, 2 | {0}\nshl bx, 1 | {0}\nadd eax, ebx | {0}\n"
                                     "imul bx | {0}\n",
                                     zeros));
  EXPECT_EQ(run.out,
            fmt::format("unmodelled\n{} undef=AF\nunmodelled\nunmodelled\n", state("fl=0044")));
  EXPECT_EQ(run.err, "fixproof step: 3 lines unmodelled\n");
  EXPECT_EQ(run.status, 0);
}

TEST(StepCommand, WhatNoRoutineHasIsUnmodelled) {
  for (const std::string_view instruction :
       {"or ax, bx", "add al, bl", "mov ax, [bx]", "add word [bp+4], 1", "pop ax", "ret",
        "call FixedMul", "mov ds, ax", "nop", "rol eax, 1", "mov ax, 5", "lodsw"}) {
    const auto run =
        command::fixproof("step --cpu 386", fmt::format("{} | {}\n", instruction, zeros));
    EXPECT_EQ(run.out, "unmodelled\n") << instruction;
    EXPECT_EQ(run.err, "fixproof step: 1 line unmodelled\n") << instruction;
    EXPECT_EQ(run.status, 0) << instruction;
  }
}

}  // namespace

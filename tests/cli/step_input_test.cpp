// Tests the input of `fixproof step`: lines that it skips, and lines that it rejects by number.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tests/cli/command.hpp"

namespace {

using namespace std::string_literals;

constexpr std::string_view registers =
    "ax=0000 bx=0000 cx=0000 dx=0000 si=0000 di=0000 bp=0000 sp=0000 fl=0000";

/// A line with the instruction and registers that are all 0, then `more`.
std::string line(std::string_view instruction, std::string_view more = "") {
  return fmt::format("{} | {}{}", instruction, registers, more);
}
std::string good(std::string_view more = "") { return line("mov ax, bx", more); }

const std::string& first_answer() {
  static const std::string text = fmt::format("{} undef=-", registers);
  return text;
}

/// Puts `bad` after one valid line. Expects that answer, then an error with its line number.
void expect_refused(const std::string& bad, std::string_view part, std::string_view cpu = "386") {
  const auto run = command::fixproof(fmt::format("step --cpu {}", cpu),
                                     fmt::format("{}\n{}\n{}\n", good(), bad, good()));
  EXPECT_EQ(run.status, 2) << bad;
  EXPECT_EQ(run.out, first_answer() + '\n') << bad;
  EXPECT_EQ(run.err.rfind("fixproof: line 2: ", 0), 0) << run.err;
  EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
  EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
  EXPECT_LT(run.err.size(), 200);
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(StepInput, PassesOverBlankLinesAndComments) {
  const auto run =
      command::fixproof("step --cpu 8088", fmt::format("# {0}\n\n{0}\n  \n{0}", good()));
  EXPECT_EQ(run.out, fmt::format("{0}\n{0}\n", first_answer()));
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.status, 0);
}

TEST(StepInput, AnswersBeforeTheNextLineIsAsked) {
  command::Process process(command::command("step --cpu 8088"));
  process.write(good("\n"));
  ASSERT_EQ(process.read_line(), first_answer());
  process.write(line("hlt") + '\n');
  ASSERT_EQ(process.read_line(), "unmodelled");
  EXPECT_EQ(process.finish().status, 0);
}

TEST(StepInput, RegistersComeInAnyOrder) {
  const auto run = command::fixproof(
      "step --cpu 8088",
      "inc cx|fl=0000   sp=0000 bp=0000 di=0000 si=0000 dx=0000 cx=0000 bx=0000 ax=0000\n");
  EXPECT_EQ(run.out, replaced(std::string(registers), "cx=0000", "cx=0001") + " undef=-\n");
}

TEST(StepInput, RefusesALineWithoutItsParts) {
  expect_refused("mov ax, bx", "'|'");
  expect_refused(line(""), "no instruction");
  expect_refused("mov ax, bx |", "ax is missing");
  expect_refused(replaced(good(), " fl=0000", ""), "fl is missing");
  for (const std::string_view name : {"bx", "cx", "dx", "si", "di", "bp", "sp"}) {
    expect_refused(replaced(good(), fmt::format(" {}=0000", name), ""),
                   fmt::format("{} is missing", name));
  }
}

TEST(StepInput, RefusesRegistersGivenTwice) {
  expect_refused(good(" ax=0000"), "'ax' is given twice");
  expect_refused(good(" eax=00000000"), "both ax and eax are given");
  expect_refused(good(" fl=0000"), "'fl' is given twice");
}

TEST(StepInput, RefusesWhatIsNoRegister) {
  expect_refused(good(" al=00"), "'al' is not a register of this processor");
  expect_refused(good(" ip=0000"), "'ip' is not a register of this processor");
  expect_refused(good(" AX=0000"), "'AX' is not a register of this processor");
  expect_refused(good(" ax"), "'ax' is not a register as NAME=DIGITS");
  expect_refused(good(" | "), "'|' is not a register as NAME=DIGITS");
}

TEST(StepInput, RefusesWideRegistersOnThe8088) {
  expect_refused(replaced(good(), "ax=0000", "eax=00000000"), "ax is missing", "8088");
  expect_refused(good(" eax=00000000"), "'eax' is not a register of this processor", "8088");
}

TEST(StepInput, RefusesOtherDigits) {
  expect_refused(replaced(good(), "ax=0000", "ax=000"), "3 hex digits instead of 4");
  expect_refused(replaced(good(), "ax=0000", "ax=00000"), "5 hex digits instead of 4");
  expect_refused(replaced(good(), "ax=0000", "eax=0000"), "4 hex digits instead of 8");
  expect_refused(replaced(good(), "ax=0000", "ax="), "0 hex digits instead of 4");
  expect_refused(replaced(good(), "ax=0000", "ax=00FF"), "lower-case hex");
  expect_refused(replaced(good(), "ax=0000", "ax=0x00"), "lower-case hex");
  expect_refused(replaced(good(), "fl=0000", "fl=00000000"), "8 hex digits instead of 4");
  expect_refused(good("\r "), "lower-case hex");
}

TEST(StepInput, RefusesWhatIsNoInstruction) {
  const auto expect_bad = [](const std::string& instruction, std::string_view part) {
    expect_refused(line(instruction), part);
  };
  expect_bad("MOV ax, bx", "'MOV' is no mnemonic");
  expect_bad("mov AX, bx", "'AX' is no operand");
  expect_bad("mov ax bx", "'ax bx' is no operand");
  expect_bad("mov ax,", "an operand is missing");
  expect_bad("mov , bx", "an operand is missing");
  expect_bad("mov ax, bx, cx, dx", "more than three operands");
  expect_bad("add ax, 0x", "'0x' is no operand");
  expect_bad("add ax, 8000h", "'8000h' is no operand");
  expect_bad("add ax, --1", "'--1' is no operand");
}

TEST(StepInput, RefusesImmediatesThatDoNotFit) {
  const auto expect_bad = [](const std::string& instruction) {
    expect_refused(line(instruction), "does not fit the operand");
  };
  expect_bad("add ax, 0x10000");
  expect_bad("add ax, -32769");
  expect_bad("add eax, -2147483649");
  expect_bad("shl bx, 256");
  expect_bad("shl bx, -1");
  // The limits themselves fit.
  for (const std::string_view fits :
       {"add ax, 0xffff", "add ax, -32768", "add eax, -2147483648", "shl bx, 255"}) {
    EXPECT_EQ(command::fixproof("step", line(fits)).status, 0) << fits;
  }
}

TEST(StepInput, RefusesNoiseAndEndlessLines) {
  expect_refused("\0\0\0"s, "'|'");
  expect_refused(line("\0"s), "is no mnemonic");
  expect_refused(command::repeated(4'000, 'a'), "'|'");
  expect_refused(line(command::repeated(3'000, 'A')), "is no mnemonic");
  expect_refused(line("mov ax, " + command::repeated(3'000, 'A')), "is no operand");
  expect_refused(command::repeated(10'000'000, 'a'), "longer than 4096 characters");
  expect_refused(line("\x1b[31mmov"), "is no mnemonic");
}

TEST(StepInput, OutputThatCannotBeWritten) {
  for (const command::Output output :
       {command::Output::full_device, command::Output::reader_gone}) {
    const auto run = command::fixproof("step --cpu 8088", good(), output);
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.err, "fixproof: cannot write standard output\n");
  }
}

}  // namespace

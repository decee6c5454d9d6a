// Tests the input of `fixproof step`: lines that it skips, and lines that it rejects by number.
#include <fmt/format.h>

#include "tests/support/command.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace std::string_literals;

constexpr std::string_view registers =
    "ax=0000 bx=0000 cx=0000 dx=0000 si=0000 di=0000 bp=0000 sp=0000 fl=0000";

/// A line with the instruction and registers that are all 0, then `more`.
std::string line(std::string_view instruction, std::string_view more = "") {
  return fmt::format("{} | {}{}", instruction, registers, more);
}
std::string valid_case(std::string_view more = "") { return line("mov ax, bx", more); }

const std::string& first_answer() {
  static const std::string text = fmt::format("{} undef=-", registers);
  return text;
}

/// Puts `bad` after one valid line. Expects that answer, then an error with its line number.
void expect_step_refused(const std::string& bad, std::string_view part,
                         std::string_view cpu = "386") {
  const auto run = command::fixproof(fmt::format("step --cpu {}", cpu),
                                     fmt::format("{}\n{}\n{}\n", valid_case(), bad, valid_case()));
  EXPECT_EQ(run.out, first_answer() + '\n') << bad;
  command::expect_usage_error(run, part);
  EXPECT_TRUE(run.err.starts_with("fixproof: line 2: ")) << run.err;
  EXPECT_LT(run.err.size(), 200);
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(StepInput, PassesOverBlankLinesAndComments) {
  EXPECT_EQ(
      command::output_of("step --cpu 8088", fmt::format("# {0}\n\n{0}\n  \n{0}", valid_case())),
      fmt::format("{0}\n{0}\n", first_answer()));
}

TEST(StepInput, AnswersBeforeTheNextLineIsAsked) {
  command::Process process(command::command("step --cpu 8088"));
  process.write(valid_case("\n"));
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
  expect_step_refused("mov ax, bx", "'|'");
  expect_step_refused(line(""), "no instruction");
  expect_step_refused("mov ax, bx |", "ax is missing");
  expect_step_refused(replaced(valid_case(), " fl=0000", ""), "fl is missing");
  for (const std::string_view name : {"bx", "cx", "dx", "si", "di", "bp", "sp"}) {
    expect_step_refused(replaced(valid_case(), fmt::format(" {}=0000", name), ""),
                        fmt::format("{} is missing", name));
  }
}

TEST(StepInput, RefusesRegistersGivenTwice) {
  expect_step_refused(valid_case(" ax=0000"), "'ax' is given twice");
  expect_step_refused(valid_case(" eax=00000000"), "both ax and eax are given");
  expect_step_refused(valid_case(" fl=0000"), "'fl' is given twice");
}

TEST(StepInput, RefusesWhatIsNoRegister) {
  expect_step_refused(valid_case(" al=00"), "'al' is not a register of this processor");
  expect_step_refused(valid_case(" ip=0000"), "'ip' is not a register of this processor");
  expect_step_refused(valid_case(" AX=0000"), "'AX' is not a register of this processor");
  expect_step_refused(valid_case(" ax"), "'ax' is not a register as NAME=DIGITS");
  expect_step_refused(valid_case(" | "), "'|' is not a register as NAME=DIGITS");
}

TEST(StepInput, RefusesWideRegistersOnThe8088) {
  expect_step_refused(replaced(valid_case(), "ax=0000", "eax=00000000"), "ax is missing", "8088");
  expect_step_refused(valid_case(" eax=00000000"), "'eax' is not a register of this processor",
                      "8088");
}

TEST(StepInput, RefusesOtherDigits) {
  expect_step_refused(replaced(valid_case(), "ax=0000", "ax=000"), "3 hex digits instead of 4");
  expect_step_refused(replaced(valid_case(), "ax=0000", "ax=00000"), "5 hex digits instead of 4");
  expect_step_refused(replaced(valid_case(), "ax=0000", "eax=0000"), "4 hex digits instead of 8");
  expect_step_refused(replaced(valid_case(), "ax=0000", "ax="), "0 hex digits instead of 4");
  expect_step_refused(replaced(valid_case(), "ax=0000", "ax=00FF"), "lower-case hex");
  expect_step_refused(replaced(valid_case(), "ax=0000", "ax=0x00"), "lower-case hex");
  expect_step_refused(replaced(valid_case(), "fl=0000", "fl=00000000"),
                      "8 hex digits instead of 4");
  expect_step_refused(valid_case("\r "), "lower-case hex");
}

TEST(StepInput, RefusesWhatIsNoInstruction) {
  for (const auto& [instruction, part] : std::initializer_list<std::array<const char*, 2>>{
           {"MOV ax, bx", "'MOV' is not a mnemonic"},
           {"mov AX, bx", "'AX' is not an operand"},
           {"mov ax bx", "'ax bx' is not an operand"},
           {"mov ax,", "an operand is missing"},
           {"mov , bx", "an operand is missing"},
           {"mov ax, bx, cx, dx", "more than three operands"},
           {"add ax, 0x", "'0x' is not an operand"},
           {"add ax, 8000h", "'8000h' is not an operand"},
           {"add ax, --1", "'--1' is not an operand"},
           {"add ax, 0x10000", "does not fit the operand"},
           {"add ax, -32769", "does not fit the operand"},
           {"add eax, -2147483649", "does not fit the operand"},
           {"shl bx, 256", "does not fit the operand"},
           {"shl bx, -1", "does not fit the operand"}}) {
    expect_step_refused(line(instruction), part);
  }
  // The limits themselves fit.
  for (const std::string_view fits :
       {"add ax, 0xffff", "add ax, -32768", "add eax, -2147483648", "shl bx, 255"}) {
    EXPECT_EQ(command::fixproof("step", line(fits)).status, 0) << fits;
  }
}

TEST(StepInput, RefusesNoiseAndEndlessLines) {
  expect_step_refused("\0\0\0"s, "'|'");
  expect_step_refused(line("\0"s), "is not a mnemonic");
  expect_step_refused(std::string(4'000, 'a'), "'|'");
  expect_step_refused(line(std::string(3'000, 'A')), "is not a mnemonic");
  expect_step_refused(line("mov ax, " + std::string(3'000, 'A')), "is not an operand");
  expect_step_refused(std::string(10'000'000, 'a'), "longer than 4096 characters");
  expect_step_refused(line("\x1b[31mmov"), "is not a mnemonic");
}

TEST(StepInput, OutputThatCannotBeWritten) {
  command::expect_output_needed("step --cpu 8088", valid_case());
}

}  // namespace

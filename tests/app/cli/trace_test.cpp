// Tests the output of `fixproof trace` against lines worked out by hand. The stack addresses are
// the model's.
#include <fmt/format.h>

#include "tests/support/command.hpp"
#include "tests/support/test.hpp"

namespace {

using command::expect_contains;

std::vector<std::string> trace(std::string_view arguments) {
  auto lines = command::split(command::output_of(fmt::format("trace {}", arguments)), '\n');
  EXPECT_EQ(lines.back(), "");
  lines.pop_back();
  return lines;
}

/// The line of instruction `text` from its flags on; empty if it was not executed.
std::string after(const std::vector<std::string>& lines, const std::string& text) {
  for (const std::string& line : lines) {
    if (line.substr(6, text.size() + 1) == text + ' ') return line.substr(37);
  }
  return "";
}

TEST(Trace, HeadingNamesTheColumns) {
  EXPECT_EQ(trace("mul 00000000 00000000").front(),
            "   #  FixedMul                       CF PF AF ZF SF OF  changes");
}

TEST(Trace, MultiplyOnThe386) {
  // -1.5 * 2.5: the product is fffffffc40000000; plus half a unit it is fffffffc40008000.
  const auto lines = trace("mul fffe8000 00028000");
  ASSERT_EQ(lines.size(), 11);
  EXPECT_EQ(lines[3].substr(0, 4), "   2");
  EXPECT_EQ(after(lines, "mov eax, [bp+4]"), " ?  ?  ?  ?  ?  ?  eax=fffe8000");
  EXPECT_EQ(after(lines, "imul dword [bp+8]"), " 1  ?  ?  ?  ?  1  eax=40000000 edx=fffffffc");
  EXPECT_EQ(after(lines, "add eax, 0x8000"), " 0  1  0  0  0  0  eax=40008000");
  EXPECT_EQ(after(lines, "adc edx, 0"), " 0  1  0  0  1  0");
  EXPECT_EQ(after(lines, "shr eax, 16"), " 1  1  ?  0  0  ?  eax=00004000");
  EXPECT_EQ(lines.back(), "9 instructions; result fffc4000 (-3.75)");
}

TEST(Trace, MultiplyWithoutRoundingAddsNothing) {
  const auto lines = trace("mul ffffffff 00008000 --round off");
  EXPECT_EQ(after(lines, "add eax, 0x8000"), "");
  EXPECT_EQ(lines.back(), "7 instructions; result ffffffff (-1.52587890625e-05)");
}

TEST(Trace, MultiplyOnThe8088) {
  // 1.5 * 2.5: high parts 1 and 2, low parts 8000h and 8000h.
  const auto lines = trace("mul 00018000 00028000 --target i8088");
  EXPECT_EQ(after(lines, "mov si, [bp+4]"), " 0  1  0  1  0  0  si=8000");
  EXPECT_EQ(after(lines, "neg si"), "");
  EXPECT_EQ(after(lines, "add ax, 0x8000"), " 0  1  0  0  1  0  ax=8000");
  EXPECT_EQ(after(lines, "mov dx, cx"), " 0  1  0  0  0  0  dx=0003");
  expect_contains(lines.back(), "result 0003c000 (3.75)");
}

TEST(Trace, DivideError) {
  const auto lines = trace("div 00010000 00008000 --target i8088");
  EXPECT_EQ(lines.back(),
            "  19  div bx                          0  1  0  1  0  0  #DE: divide error");
}

TEST(Trace, DivideShowsTheArgumentsItClobbers) {
  const auto lines = trace("div ffffc000 00028000 --target i8088");
  EXPECT_EQ(after(lines, "neg word [bp+4]"), " 1  1  0  0  0  0  [0058]=4000");
}

TEST(Trace, AsScannedStopsAtTheUndefinedCarry) {
  const auto lines = trace("div 00018000 00028000 --target i8088 --round off --as-scanned");
  EXPECT_EQ(lines.back(),
            "  23  adc cx, 0                       ?  ?  ?  ?  ?  ?  "
            "reads a flag that Intel leaves undefined");
  // With rounding, the same instruction reads a defined carry.
  expect_contains(trace("div 00018000 00028000 --target i8088 --as-scanned").back(),
                  "result 0000c000 (0.75)");
}

TEST(Trace, ResultsInMemory) {
  expect_contains(trace("cossin 0384").back(), "result 00000000 (0) 00010000 (1)");
  std::string point = "xformvec";
  for (int i = 0; i < 15; ++i) point += i % 5 == 0 ? " 00010000" : " 00000000";
  expect_contains(trace(point).back(), "result 00000000 (0) 00000000 (0) 00000000 (0)");
}

TEST(Trace, TakesNumbersAsPeopleWriteThem) {
  const auto words = trace("mul 00018000 fffd8000");
  for (const char* numbers : {"1.5 -2.5", "0x18000 -0x28000", "1.5e0 FFFD8000"})
    EXPECT_EQ(trace(fmt::format("mul {}", numbers)), words) << numbers;
  EXPECT_EQ(trace("cossin 450"), trace("cossin 01c2"));
  EXPECT_EQ(trace("gouraud-byte 3 32 1.5"), trace("gouraud-byte 00000003 00002000 00000180"));
}

TEST(Trace, LinesEndWithoutSpaces) {
  for (const std::string& line : trace("div 00018000 00028000 --target i8088")) {
    EXPECT_NE(line.back(), ' ') << line;
  }
}

/// The last two lines of a mutant's trace. Mutant `number` must have that change.
std::string end_of_mutant(const std::string& arguments, int number, std::string_view change) {
  const auto lines = trace(fmt::format("{} --mutant {}", arguments, number));
  EXPECT_EQ(lines.front(), fmt::format("mutant {}: {}", number, change));
  return lines.at(lines.size() - 2) + '\n' + lines.back();
}

TEST(Trace, SaysWhatAMutantDoesNotKeep) {
  const std::string mul = "mul 00018000 00028000";
  // The caller's BP is popped into SI. Both registers are lost, although the result is right.
  EXPECT_EQ(end_of_mutant(mul, 50, "7 pop bp -> pop si"),
            trace(mul).back() + "\ndoes not preserve si, bp");
  // The caller's DI is popped into BP, which is restored later.
  const std::string on_8088 = mul + " --target i8088";
  EXPECT_EQ(end_of_mutant(on_8088, 277, "46 pop di -> pop bp"),
            trace(on_8088).back() + "\ndoes not preserve di");
  // Writes to the transform instead of reading it.
  std::string point = "xformvec";
  for (int i = 0; i < 15; ++i) point += " 00010000";
  expect_contains(end_of_mutant(point, 44, "7 mov eax, [si] -> mov [si], eax"),
                  "\ndoes not preserve operand 1");
  // A mutant that only rounds down instead of up preserves all registers.
  EXPECT_EQ(
      end_of_mutant(mul, 27, "4 add eax, 0x8000 -> sub eax, 0x8000").find("does not preserve"),
      std::string::npos);
}

TEST(Trace, CountsAndChecksItsWords) {
  command::expect_refused("trace mul 00018000", "mul takes 2 words, not 1");
  command::expect_refused("trace mul 00018000 00028000 00000000", "mul takes 2 words, not 3");
  command::expect_refused("trace cossin 00000384", "'00000384': a word has 4 hexadecimal digits");
  command::expect_refused("trace mul 1800A 00028000", "'1800A': a word has 8 hexadecimal digits");
}

}  // namespace

// Tests `fixproof step --clocks` against Intel's tables, with multiplies and divides by hand.
#include <fmt/format.h>

#include "tests/support/command.hpp"
#include "tests/support/test.hpp"

namespace {

/// The output after the state of `instruction`, run with these AX, BX and DX.
std::string clocks_of(std::string_view cpu, std::string_view clocks, std::string_view instruction,
                      std::string_view ax_bx_dx = "ax=0001 bx=0002 dx=0000") {
  const auto run =
      command::fixproof(fmt::format("step --cpu {} --clocks {}", cpu, clocks),
                        fmt::format("{} | {} cx=0000 si=0000 di=0000 bp=0000 sp=fffe fl=0000\n",
                                    instruction, ax_bx_dx));
  EXPECT_EQ(run.status, 0) << run.err;
  const auto at = run.out.find(" clocks=");
  return at == std::string::npos ? run.out : run.out.substr(at + 8, run.out.size() - at - 9);
}

struct Row {
  std::string_view instruction;
  std::array<std::string_view, 4> clocks;
};

void expect_clocks(const std::vector<Row>& rows) {
  constexpr std::array<std::string_view, 4> cpus{"8088", "286", "386", "486"};
  std::string lines;
  for (const Row& row : rows) {
    lines += fmt::format(
        "{} | ax=0001 bx=0002 dx=0000 cx=0000 si=0000 di=0000 bp=0000 sp=fffe fl=0000\n",
        row.instruction);
  }
  for (std::size_t i = 0; i < cpus.size(); ++i) {
    const auto run =
        command::fixproof(fmt::format("step --cpu 386 --clocks {}", cpus.at(i)), lines);
    EXPECT_EQ(run.status, 0) << run.err;
    const auto answers = command::split(run.out, '\n');
    ASSERT_EQ(answers.size(), rows.size() + 1);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const auto at = answers[k].find(" clocks=");
      ASSERT_NE(at, std::string::npos) << answers[k];
      EXPECT_EQ(answers[k].substr(at + 8), rows[k].clocks.at(i))
          << rows[k].instruction << " on " << cpus.at(i);
    }
  }
}

TEST(StepClocks, AreThoseOfTheTables) {
  expect_clocks({
      {"adc bx, dx", {"3", "2", "2", "1"}},
      {"add ax, 0x8000", {"4", "3", "2", "1"}},
      {"mov ax, bx", {"2", "2", "2", "1"}},
      {"inc bx", {"2", "2", "2", "1"}},
      {"neg bx", {"3", "2", "2", "1"}},
      {"shl bx, 1", {"2", "2", "3", "3"}},
      // Jumps not taken; JMP is 7 plus its target's 1 to 4 bytes on a 286, 1 to 5 components on a
      // 386.
      {"jz .There", {"4", "3", "3", "1"}},
      {"jmp .There", {"15", "8-12", "8-12", "3"}},
      // AX has one 1 bit, and DX becomes 0. A 386 and a 486 count at least 3 bits of the
      // multiplier.
      {"mul bx", {"119", "21", "9", "13"}},
      // 0000 0001h / 2: no step subtracts.
      {"div bx", {"144", "22", "22", "24"}},
      // Only on a 386.
      {"imul ebx", {"-", "-", "9", "13-14"}},
      {"idiv ebx", {"-", "-", "43", "43-44"}},
      {"div ebx", {"-", "-", "38", "40-41"}},
      {"shld edx, eax, 16", {"-", "-", "3", "2-3"}},
  });
}

TEST(StepClocks, OfMultipliesAndDividesDependOnTheOperands) {
  // AX has sixteen 1 bits, and FFFFh * FFFFh leaves DX nonzero.
  EXPECT_EQ(clocks_of("8088", "8088", "mul bx", "ax=ffff bx=ffff dx=0000"), "133");
  // Every step subtracts: 17 + 15 * 9 + 10.
  EXPECT_EQ(clocks_of("8088", "8088", "div bx", "ax=ffff bx=0001 dx=0000"), "162");
  EXPECT_EQ(clocks_of("386", "386", "mul bx", "ax=0001 bx=8000 dx=0000"), "21");
  // 2^15: 10 + 15.
  EXPECT_EQ(clocks_of("386", "486", "mul bx", "ax=0001 bx=8000 dx=0000"), "25");
}

TEST(StepClocks, LinesWithoutAStateStayAsTheyAre) {
  EXPECT_EQ(clocks_of("8088", "8088", "div bx", "ax=0001 bx=0000 dx=0000"), "DE\n");
  EXPECT_EQ(clocks_of("8088", "8088", "ret"), "unmodelled\n");
}

TEST(StepClocks, IsNotForFiles) {
  const auto run = command::fixproof("step --clocks 286 --singlestep some.json");
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("--clocks"), std::string::npos) << run.err;
  EXPECT_EQ(command::fixproof("step --clocks 186").status, 2);
}

}  // namespace

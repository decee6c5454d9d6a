// Tests the sources as text: a conversion in C, and an opcode that the processor does not have.
#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"
#include "x86model/forms.hpp"
#include "x86model/parse.hpp"
#include "x86model/text.hpp"

namespace {

namespace x86 = x86model;

/// The published conversion: adds half a unit, then truncates as C does.
std::int32_t add_half_and_truncate(double x) {
  // NOLINTNEXTLINE(bugprone-incorrect-roundings): which is the point
  return static_cast<std::int32_t>(x * 65536 + 0.5);
}

TEST(Defects, DoubleToFixed) {
  EXPECT_EQ(add_half_and_truncate(-1.0), -65535);  // ffff0001h, not ffff0000h
  EXPECT_EQ(fixproof::q16_16(-1.0).raw(), -65536);
  // Every negative number of the format is wrong, although none needs rounding.
  for (std::int32_t raw = -200'000; raw < 200'000; ++raw) {
    const double exact = raw / 65536.0;
    EXPECT_EQ(add_half_and_truncate(exact), raw < 0 ? raw + 1 : raw);
    EXPECT_EQ(fixproof::q16_16(exact).raw(), raw);
  }
  // Between them it is wrong too, except for exact halves and above minus half a unit.
  EXPECT_EQ(add_half_and_truncate(-2.75 / 65536), -2);
  EXPECT_EQ(add_half_and_truncate(-2.25 / 65536), -1);
  EXPECT_EQ(add_half_and_truncate(-2.5 / 65536), -2);
  EXPECT_EQ(add_half_and_truncate(-0.25 / 65536), 0);
  EXPECT_EQ(fixproof::q16_16(-2.75 / 65536).raw(), -3);
  EXPECT_EQ(fixproof::q16_16(-2.25 / 65536).raw(), -2);
  EXPECT_EQ(fixproof::q16_16(-2.5 / 65536).raw(), -2);
  EXPECT_EQ(fixproof::q16_16(-0.25 / 65536).raw(), 0);
}

TEST(Defects, NotAn8088Instruction) {
  const auto by_two = x86::parse("shl bx, 2");
  const auto by_one = x86::parse("shl bx, 1");
  ASSERT_TRUE(by_two && by_one);
  EXPECT_FALSE(x86::is_modelled(*by_two, x86::Target::i8088));
  EXPECT_TRUE(x86::is_modelled(*by_one, x86::Target::i8088));
  EXPECT_TRUE(x86::is_modelled(*by_two, x86::Target::i386));

  // In each quadrant the 386 listing shifts once by two, the 8088 listing twice by one.
  const auto count = [](x86::Target target, const std::string& instruction,
                        const x86::Build& build = {}) {
    const x86::Program program = x86::assemble(x86::listing(x86::Routine::cossin, target), build);
    int found = 0;
    for (const x86::Instruction& i : program.instructions()) {
      if (x86::text_of(i) == instruction) ++found;
    }
    return found;
  };
  EXPECT_EQ(count(x86::Target::i386, "shl bx, 2"), 4);
  EXPECT_EQ(count(x86::Target::i386, "shl bx, 1"), 0);
  EXPECT_EQ(count(x86::Target::i8088, "shl bx, 2"), 0);
  EXPECT_EQ(count(x86::Target::i8088, "shl bx, 1"), 8);
  const x86::Build printed{.shl_as_printed = true};
  EXPECT_EQ(count(x86::Target::i8088, "shl bx, 2", printed), 4);
  EXPECT_EQ(count(x86::Target::i8088, "shl bx, 1", printed), 0);
}

}  // namespace

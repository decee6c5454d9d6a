#include "x86model/machine.hpp"

#include "tests/support/test.hpp"
#include "x86model/assemble.hpp"
#include "x86model/notation.hpp"
#include "x86model/run.hpp"

namespace {

using namespace x86model;
using namespace x86model::notation;

using Wide = Machine<16, WordMemory<16, 32>>;

TEST(Registers, ViewsShareTheirBits) {
  Registers<16> r;
  r.write(Register::cx, Size::dword, 0x12345678);
  EXPECT_EQ(r.read(Register::cx, Size::word), 0x5678U);
  EXPECT_EQ(r.read(Register::cx, Size::byte), 0x78U);
  EXPECT_EQ(r.read(Register::bp, Size::byte), 0x56U) << "CH has the number of BP";
  r.write(Register::cx, Size::word, 0x9ABC);
  EXPECT_EQ(r.read(Register::cx, Size::dword), 0x12349ABCU) << "the upper half stays";
}

TEST(Registers, AtHalfWidthTheDwordIsSixteenBits) {
  Registers<8> r;
  r.write(Register::ax, Size::dword, 0x12345678);
  EXPECT_EQ(r.read(Register::ax, Size::dword), 0x5678U);
  EXPECT_EQ(r.read(Register::ax, Size::word), 0x78U);
}

TEST(WordMemory, HasOnlyAlignedWordsInside) {
  WordMemory<16, 4> memory;
  std::uint32_t value = 0;
  EXPECT_TRUE(memory.write(6, 0x1FFFF));
  EXPECT_TRUE(memory.read(6, value));
  EXPECT_EQ(value, 0xFFFFU);
  EXPECT_FALSE(memory.write(8, 0));
  EXPECT_FALSE(memory.read(1, value));
  EXPECT_FALSE(memory.read(0xFFFE, value));
}

Ending run_rows(Wide& m, std::initializer_list<Instruction> rows) {
  const Program program = assemble(Listing(rows), {});
  m.registers.write(Register::sp, Size::word, 0x20);
  m.push(return_to_caller<16>);
  return run(program.instructions(), m);
}

TEST(Run, ReportsTheReadOfAnUndefinedFlag) {
  Wide m;
  EXPECT_EQ(run_rows(m, {adc(ax, 0), ret()}).outcome, Outcome::undefined_flag) << "at entry";
  m = {};
  EXPECT_EQ(run_rows(m, {mul(bx), adc(ax, 0), ret()}).outcome, Outcome::returned)
      << "MUL defines CF";
  m = {};
  EXPECT_EQ(run_rows(m, {mul(bx), jz("end"), label("end"), ret()}).outcome, Outcome::undefined_flag)
      << "but not ZF";
  m = {};
  EXPECT_EQ(run_rows(m, {sub(ax, ax), inc(ax), adc(ax, 0), ret()}).outcome, Outcome::returned)
      << "INC keeps CF";
  m = {};
  EXPECT_EQ(run_rows(m, {inc(ax), adc(ax, 0), ret()}).outcome, Outcome::undefined_flag)
      << "INC keeps an undefined CF too";
}

TEST(Run, ADivideErrorChangesNothing) {
  Wide m;
  m.registers.write(Register::ax, Size::word, 7);
  const Ending ending = run_rows(m, {inc(ax), div(bx), ret()});
  EXPECT_EQ(ending.outcome, Outcome::divide_error);
  EXPECT_EQ(ending.position, 1U);
  EXPECT_EQ(m.registers.read(Register::ax, Size::word), 8U);
}

TEST(Run, EndsWhatDoesNotEnd) {
  Wide m;
  EXPECT_EQ(run_rows(m, {label("again"), jmp("again")}).outcome, Outcome::step_limit);
  m = {};
  EXPECT_EQ(run_rows(m, {mov(ax, word[bp + 0x100]), ret()}).outcome, Outcome::bad_address);
  m = {};
  EXPECT_EQ(run_rows(m, {pop(ax), ret()}).outcome, Outcome::bad_address) << "the stack is empty";
  m = {};
  EXPECT_EQ(run_rows(m, {inc(ax)}).outcome, Outcome::bad_address) << "no RET";
}

TEST(Run, CallsReturnBehindTheCall) {
  Wide m;
  const Ending ending = run_rows(
      m, {call("callee"), add(ax, 1), ret(), proc("callee"), mov(ax, bx), add(ax, 40), ret()});
  EXPECT_EQ(ending.outcome, Outcome::returned);
  EXPECT_EQ(ending.steps, 6U);
  EXPECT_EQ(m.registers.read(Register::ax, Size::word), 41U);
  EXPECT_EQ(m.registers.read(Register::sp, Size::word), 0x20U);
}

}  // namespace

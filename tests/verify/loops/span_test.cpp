// Tests whole spans of every form and length against the source's meaning in plain integers.
#include "tests/verify/loops/span.hpp"

#include "tests/support/test.hpp"
#include "x86model/compiled.hpp"

namespace {

using namespace loops_test;
using x86::Counting;
using x86::Loop;
using x86::LoopCall;
using x86::LoopForm;
using x86::LoopMachine;
using x86::Outcome;
using x86::Register;
using x86::Size;

/// Runs a span, part by part, and checks that it makes the expected changes and no others.
void expect_drawn(const LoopForm& form, const LoopCall& span, Memory before, Random& random) {
  Memory memory = before;
  LoopMachine m = machine(memory, random);
  const std::uint32_t ebx = m.registers.read(Register::bx, Size::dword);
  for (const x86::LoopPart& part : x86::parts_of(form, span)) {
    const auto code = x86::code_of(part.form);
    const x86::Ending ending = x86::call_loop(part.form, code, m, part.call);
    ASSERT_EQ(ending.outcome, Outcome::returned) << text(form) << ", pixels " << span.pixels;
    const std::uint32_t place = part.call.place + part.call.pixels;
    ASSERT_EQ(m.registers.read(Register::di, Size::dword), place) << text(form);
    ASSERT_EQ(m.registers.read(Register::sp, Size::word), 0x60U) << text(form);
    ASSERT_EQ(m.registers.read(Register::bp, Size::dword), span.step) << text(form);
    if (form.counting != Counting::unrolled) {
      ASSERT_EQ(m.registers.read(Register::cx, Size::dword), 0U) << text(form);
    }
  }
  take_frame(memory, before);
  ASSERT_EQ(memory, drawn(form.loop, span, before, form.as_printed, ebx))
      << text(form) << ", pixels " << span.pixels << ", place " << span.place;
}

TEST(Span, EveryFormDrawsEveryLength) {
  Random random(320);
  int forms = 0;
  for (const LoopForm& form : x86::all_loop_forms()) {
    ++forms;
    const Memory before = noise(random);
    for (std::uint32_t pixels = 1; pixels <= most; ++pixels) {
      expect_drawn(form, draw_call(form.loop, pixels, random), before, random);
      if (HasFatalFailure()) return;
    }
  }
  // 386: four loops with three ways to count, less the unrolled depth test, which exists as printed
  // and repaired. 8088: three loops with three ways to count.
  EXPECT_EQ(forms, 3 + 3 + 2 + 2 + 3 + 9);
}

TEST(Span, AnUnrolledLoopDrawsNothingToo) {
  Random random(0);
  for (const Loop loop : {Loop::gouraud_byte, Loop::gouraud_word, Loop::texture}) {
    const LoopForm form{loop, Counting::unrolled};
    Memory memory = noise(random);
    Memory before = memory;
    LoopMachine m = machine(memory, random);
    const auto call = draw_call(loop, 0, random);
    const auto ending = x86::call_loop(form, x86::code_of(form), m, call);
    EXPECT_EQ(ending.outcome, Outcome::returned);
    EXPECT_EQ(ending.steps, 2U) << "the jump, and RET";
    take_frame(memory, before);
    EXPECT_EQ(memory, before);
  }
}

TEST(Span, TheSourceAndTheExtraSegmentMayBeTwo) {
  Random random(2);
  Memory data = noise(random);
  const Memory data_before = data;
  Memory row(8);
  Memory stack(0x60);
  LoopMachine m{.registers = {}, .memory = x86::ByteMemory(data, row, stack)};
  const LoopForm form{Loop::texture, Counting::unrolled};
  const LoopCall call{.pixels = 8, .value = 0xFE00, .step = 0x80, .row = 0xFF00, .row_step = 0x100};
  ASSERT_EQ(x86::call_loop(form, x86::code_of(form), m, call).outcome, Outcome::returned);
  for (std::uint32_t i = 0; i < 8; ++i) {
    const std::uint32_t texel =
        (0xFF00 + i * 0x100) % 65536 / 256 * 256 + (0xFE00 + i * 0x80) % 65536 / 256;
    EXPECT_EQ(row[i], data[(texture_at + texel) % 65536]) << i;
  }
  Memory kept = data_before;
  for (std::uint32_t at = inc_j_at; at < inc_j_at + 4; ++at) kept[at] = data[at];
  EXPECT_EQ(data, kept);
}

TEST(Span, EndsWhereTheSegmentDoes) {
  Memory data(0x80);
  Memory row(3);
  Memory stack(0x60);
  LoopMachine m{.registers = {}, .memory = x86::ByteMemory(data, row, stack)};
  const LoopForm bytes{Loop::gouraud_byte};
  auto ending = x86::call_loop(bytes, x86::code_of(bytes), m, {.pixels = 4});
  EXPECT_EQ(ending.outcome, Outcome::bad_address);
  EXPECT_EQ(m.registers.read(Register::di, Size::word), 3U);
  const LoopForm words{Loop::gouraud_word};
  ending = x86::call_loop(words, x86::code_of(words), m, {.pixels = 4});
  EXPECT_EQ(ending.outcome, Outcome::bad_address) << "a word that begins inside and ends outside";
  EXPECT_EQ(m.registers.read(Register::di, Size::word), 2U);
}

/// A jump can only reach the first byte of an instruction.
TEST(Span, AJumpIntoAnInstructionLeadsNowhere) {
  Random random(1);
  const LoopForm form{Loop::gouraud_byte, Counting::unrolled};
  const auto code = x86::code_of(form);
  for (const std::uint32_t off : {1U, 3U}) {
    Memory memory = noise(random);
    LoopMachine m = machine(memory, random);
    x86::enter_loop(form, m, {.pixels = 1, .place = row_at});
    m.registers.write(Register::bx, Size::word, m.registers.read(Register::bx, Size::word) + off);
    EXPECT_EQ(x86::run(code, m).outcome, Outcome::bad_address) << off;
  }
}

/// Runs every counted loop, unrolled at compile time, against the interpreter.
template <Loop loop, Counting counting, x86::Target target, bool as_printed>
void expect_compiled_is_the_same(Random& random) {
  constexpr LoopForm form{loop, counting, target, as_printed};
  static constexpr x86::Program program = x86::assemble(x86::listing(form), {});
  for (std::uint32_t pixels = 2; pixels <= most; pixels += 106) {
    Memory stepwise = noise(random);
    Memory compiled = stepwise;
    const auto call = draw_call(loop, pixels, random);
    LoopMachine m = machine(stepwise, random);
    LoopMachine n{.registers = m.registers,
                  .memory = x86::ByteMemory(compiled, compiled, compiled)};
    x86::call_loop(form, program.instructions(), m, call);
    x86::enter_loop(form, n, call);
    EXPECT_EQ(x86::run_compiled<program>(n), Outcome::returned) << text(form);
    EXPECT_EQ(n.registers, m.registers) << text(form);
    EXPECT_EQ(n.flags, m.flags) << text(form);
    EXPECT_EQ(compiled, stepwise) << text(form);
  }
}

TEST(Span, CompiledIsTheSame) {
  using enum x86::Target;
  Random random(16);
  const auto both = [&]<Loop loop, x86::Target target, bool as_printed = false>() {
    expect_compiled_is_the_same<loop, Counting::loop, target, as_printed>(random);
    expect_compiled_is_the_same<loop, Counting::dec_jnz, target, as_printed>(random);
  };
  both.operator()<Loop::gouraud_byte, i386>();
  both.operator()<Loop::gouraud_word, i386>();
  both.operator()<Loop::texture, i386>();
  both.operator()<Loop::depth_test, i386>();
  both.operator()<Loop::depth_test, i386, true>();
  both.operator()<Loop::gouraud_word, i8088>();
}

}  // namespace

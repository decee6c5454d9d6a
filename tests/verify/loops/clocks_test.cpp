// Tests the clocks per pixel of every loop against hand sums from Intel's tables.
#include "measure/clocks/span_clocks.hpp"
#include "tests/support/test.hpp"
#include "x86model/notation.hpp"

namespace {

using namespace fixproof;
using x86model::Counting;
using x86model::Cpu;
using x86model::Loop;
using x86model::LoopForm;
using x86model::Target;

void expect(const LoopForm& form, Cpu cpu, double min, double max,
            measure::Pixels pixels = measure::Pixels::drawn) {
  const auto clocks = measure::pixel_clocks(form, pixels, cpu);
  ASSERT_TRUE(clocks) << name_of(cpu);
  EXPECT_DOUBLE_EQ(clocks->table.min, min) << name_of(cpu);
  EXPECT_DOUBLE_EQ(clocks->table.max, max) << name_of(cpu);
}

// mov al,dh  add dx,bp  stosb: 2 3 11 on an 8088, 2 2 3 on a 286, 2 2 4 on a 386, 1 1 5 on a 486.
TEST(LoopClocks, GouraudBytes) {
  LoopForm form{Loop::gouraud_byte, Counting::loop, Target::i8088};
  expect(form, Cpu::i8088, 2 + 3 + 11 + 17, 33);
  // The jump target is MOV, which has 2 bytes.
  expect(form, Cpu::i286, 2 + 2 + 3 + (8 + 2), 17);
  expect(form, Cpu::i386, 2 + 2 + 4 + (11 + 2), 21);
  expect(form, Cpu::i486, 1 + 1 + 5 + 7, 14);
  form.counting = Counting::dec_jnz;
  expect(form, Cpu::i8088, 16 + 2 + 16, 34);
  expect(form, Cpu::i286, 7 + 2 + (7 + 2), 18);
  expect(form, Cpu::i386, 8 + 2 + (7 + 2), 19);
  expect(form, Cpu::i486, 7 + 1 + 3, 11);
  // DEC ECX has a prefix.
  expect({Loop::gouraud_byte, Counting::dec_jnz}, Cpu::i486, 11, 12);
  form.counting = Counting::unrolled;
  expect(form, Cpu::i8088, 16, 16);
  expect(form, Cpu::i286, 7, 7);
  expect(form, Cpu::i386, 8, 8);
  expect(form, Cpu::i486, 7, 7);
}

// Two MOVs, two ADDs and STOSW for two pixels. On an 8088 the second byte takes 4 clocks.
TEST(LoopClocks, GouraudWords) {
  expect({Loop::gouraud_word, Counting::unrolled, Target::i8088}, Cpu::i8088, 25 / 2.0, 12.5);
  expect({Loop::gouraud_word, Counting::unrolled, Target::i8088}, Cpu::i286, 11 / 2.0, 5.5);
  expect({Loop::gouraud_word, Counting::unrolled}, Cpu::i386, 12 / 2.0, 6);
  expect({Loop::gouraud_word, Counting::unrolled}, Cpu::i486, 9 / 2.0, 11 / 2.0);
  expect({Loop::gouraud_word, Counting::loop}, Cpu::i386, (12 + 11 + 2) / 2.0, 12.5);
}

TEST(LoopClocks, DepthTest) {
  const LoopForm form{Loop::depth_test};
  // Hidden: shld 3, add 2, cmp 6, jg not taken 3, inc 2, loop 11 plus the five components of SHLD.
  expect(form, Cpu::i386, 3 + 2 + 6 + 3 + 2 + (11 + 5), 32, measure::Pixels::hidden);
  // Drawn: jg taken to MOV (prefix, opcode, ModR/M, displacement), two MOVs to memory, inc, loop.
  expect(form, Cpu::i386, 3 + 2 + 6 + (7 + 4) + 2 + 2 + 2 + (11 + 5), 44);
  // 486: shld 2, add 1, cmp 2, jg 1, inc 1, loop 7; four prefixes, and 1 for the scaled index.
  expect(form, Cpu::i486, 2 + 1 + 2 + 1 + 1 + 7, 14 + 4 + 1, measure::Pixels::hidden);
}

// An 8088's bus bytes from ndisasm's listing. MOV 2, ADD 2, STOSB 1 and the stored byte; LOOP and
// JNZ 2, DEC 1. Words: 9 bytes of code and two stored for two pixels. Texture: 2 + 2 + 4 + 1 + 2 +
// 4 + 1 + 2 bytes of code, a byte read, a byte stored, a word read.
TEST(LoopClocks, BusOfAn8088) {
  const auto bus = [](Loop loop, Counting counting) {
    return measure::pixel_clocks({loop, counting, Target::i8088}, measure::Pixels::drawn,
                                 Cpu::i8088)
        ->bus;
  };
  EXPECT_DOUBLE_EQ(bus(Loop::gouraud_byte, Counting::unrolled), 4 * (5 + 1));
  EXPECT_DOUBLE_EQ(bus(Loop::gouraud_byte, Counting::loop), 4 * (7 + 1));
  EXPECT_DOUBLE_EQ(bus(Loop::gouraud_byte, Counting::dec_jnz), 4 * (8 + 1));
  EXPECT_DOUBLE_EQ(bus(Loop::gouraud_word, Counting::unrolled), 4 * (9 + 2) / 2.0);
  EXPECT_DOUBLE_EQ(bus(Loop::texture, Counting::dec_jnz), 4 * (18 + 4));
  EXPECT_EQ(measure::pixel_clocks({Loop::texture}, measure::Pixels::drawn, Cpu::i386)->bus, 0);
}

// mov bx,si  mov bl,dh  mov al,[Texture+bx]  stosb  add dx,bp  add si,[IncJ]
TEST(LoopClocks, Texture) {
  LoopForm form{Loop::texture, Counting::loop, Target::i8088};
  // [bx+disp] takes 9 address clocks, [disp] 6, and a word from memory 4 more.
  expect(form, Cpu::i8088, 2 + 2 + (8 + 9) + 11 + 3 + (9 + 6 + 4) + 17, 71);
  expect(form, Cpu::i286, 2 + 2 + 5 + 3 + 2 + 7 + (8 + 2), 31);
  expect(form, Cpu::i386, 2 + 2 + 4 + 4 + 2 + 6 + (11 + 2), 33);
  form.counting = Counting::unrolled;
  expect(form, Cpu::i8088, 2 + 2 + 17 + 11 + 3 + 3, 38);
  expect({Loop::texture, Counting::unrolled}, Cpu::i386, 2 + 2 + 4 + 4 + 2 + 2, 16);
  // The address waits for BX because the previous instruction writes BL. Two prefixes.
  expect({Loop::texture, Counting::unrolled}, Cpu::i486, 1 + 1 + (1 + 1) + 5 + 1 + 1, 11 + 2);
}

TEST(LoopClocks, The8088CannotRunWhatIsForThe386) {
  EXPECT_FALSE(measure::pixel_clocks({Loop::gouraud_word}, measure::Pixels::drawn, Cpu::i286));
  EXPECT_FALSE(measure::pixel_clocks({Loop::depth_test}, measure::Pixels::drawn, Cpu::i8088));
}

const measure::LoopGain* gain_of(const measure::LoopClaim& claim, const std::string& where) {
  for (const measure::LoopGain& gain : claim.gains) {
    if (gain.where == where) return &gain;
  }
  return nullptr;
}

TEST(LoopClocks, TheClaims) {
  const auto claims = measure::loop_claims();
  ASSERT_EQ(claims.size(), 3U);
  const auto* words = gain_of(claims[0], "gouraud-byte, unrolled to gouraud-word, on a 386");
  ASSERT_NE(words, nullptr);
  EXPECT_DOUBLE_EQ(words->min, 8.0 / 6);
  const auto* on_8088 = gain_of(claims[1], "gouraud-byte, loop to dec-jnz, on an 8088");
  ASSERT_NE(on_8088, nullptr);
  EXPECT_DOUBLE_EQ(on_8088->max, 33.0 / 34);
  const auto* on_386 = gain_of(claims[1], "gouraud-byte, loop to dec-jnz, on a 386");
  ASSERT_NE(on_386, nullptr);
  EXPECT_DOUBLE_EQ(on_386->min, 21.0 / 19);
  // 36 clocks by the bus over 33 by the table.
  const auto* with_bus =
      gain_of(claims[1], "gouraud-byte, loop to dec-jnz, on an 8088 with its bus");
  ASSERT_NE(with_bus, nullptr);
  EXPECT_DOUBLE_EQ(with_bus->max, 33.0 / 36);
  const auto* unrolled = gain_of(claims[2], "gouraud-byte, dec-jnz to unrolled, on a 386");
  ASSERT_NE(unrolled, nullptr);
  EXPECT_DOUBLE_EQ(unrolled->min, 19.0 / 8);
}

}  // namespace

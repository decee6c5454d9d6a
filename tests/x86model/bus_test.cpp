// Tests the bytes on an 8088's bus against hand counts from ndisasm listings of NASM's output.
#include "x86model/bus.hpp"

#include "tests/support/test.hpp"
#include "x86model/count_clocks.hpp"
#include "x86model/notation.hpp"

namespace {

using namespace x86model;
using namespace x86model::notation;

// FixedMul has 98 bytes, 00h to 61h. 1.0 * 1.0 jumps from 11h to 19h, from 23h to 2Dh and from 57h
// to 5Eh, which skips 8, 10 and 7 bytes. Data: PUSH and POP of BP, SI, DI, CX and AX, four argument
// words, the return address.
TEST(Bus, OfFixedMul) {
  const Program program = assemble(listing(Routine::mul, Target::i8088), {});
  const auto counted = count_clocks<Routine::mul>(program.instructions(),
                                                  std::array{0x10000U, 0x10000U}, Cpu::i8088);
  EXPECT_EQ(counted.bus.code, 98U - 8 - 10 - 7);
  EXPECT_EQ(counted.bus.data, 5U * 2 + 5 * 2 + 4 * 2 + 2);
  EXPECT_EQ(counted.bus.clocks(), 4U * (73 + 30));
}

// FixedDiv has 81 bytes, 00h to 50h. -1.0 / 2.0 jumps only from 1Ch to 27h. Data: BP and CX pushed
// and popped, three argument words read, one negated in memory, the return address.
TEST(Bus, OfFixedDiv) {
  const Program program = assemble(listing(Routine::div, Target::i8088), {});
  const auto counted = count_clocks<Routine::div>(program.instructions(),
                                                  std::array{0xFFFF0000U, 0x20000U}, Cpu::i8088);
  EXPECT_EQ(counted.bus.code, 81U - 11);
  EXPECT_EQ(counted.bus.data, 2U * 2 + 2 * 2 + 3 * 2 + 2 * 2 + 2);
}

TEST(Bus, OfSingleInstructions) {
  const auto expect = [](const Instruction& i, std::uint64_t code, std::uint64_t data) {
    EXPECT_EQ(bus_bytes(i), (BusBytes{code, data}));
  };
  expect(mov(bp, sp), 2, 0);                  // 89 E5
  expect(mov(ax, word[bp + 6]), 3, 2);        // 8B 46 06
  expect(mov(word[bx + 4], cx), 3, 2);        // 89 4F 04
  expect(push(word[si + 2]), 3, 4);           // FF 74 02: memory read, then pushed
  expect(neg(word[bp + 4]), 3, 4);            // F7 5E 04: read and written
  expect(add(cx, word[si + 12]), 3, 2);       // 03 4C 0C
  expect(cmp(bx, 3600), 4, 0);                // 81 FB 10 0E
  expect(mul(bx), 2, 0);                      // F7 E3
  expect(call("FixedMul"), 3, 2);             // E8 xx xx: the return address
  expect(jz("near"), 2, 0);                   // 74 xx
  expect(ret(), 1, 2);                        // C3
  expect(stosb(), 1, 1);                      // AA
  expect(stosw(), 1, 2);                      // AB
  expect(mov(al, byte[Texture + bx]), 4, 1);  // 8A 87 iw
}

TEST(Bus, OtherProcessorsHaveNone) {
  const Program program = assemble(listing(Routine::mul, Target::i8088), {});
  const std::array in{0x10000U, 0x10000U};
  for (const Cpu cpu : {Cpu::i286, Cpu::i386, Cpu::i486}) {
    EXPECT_EQ(count_clocks<Routine::mul>(program.instructions(), in, cpu).bus, BusBytes{});
  }
}

}  // namespace

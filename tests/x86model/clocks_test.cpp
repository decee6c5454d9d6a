// Tests clock counts against hand sums from Intel's tables, instruction by instruction.
#include "x86model/clocks.hpp"

#include "tests/support/test.hpp"
#include "tests/x86model/cases.hpp"
#include "x86model/count_clocks.hpp"
#include "x86model/notation.hpp"
#include "x86model/text.hpp"

namespace x86model {

// GoogleTest finds this function by its name.
// NOLINTNEXTLINE(readability-identifier-naming)
void PrintTo(const Range& r, std::ostream* out) { *out << r.min << " to " << r.max; }

}  // namespace x86model

namespace {

using namespace x86model;
using namespace x86model::notation;

constexpr std::array cpus{Cpu::i8088, Cpu::i286, Cpu::i386, Cpu::i486};

template <std::size_t Cpus>
struct Step {
  const char* text;
  std::array<Range, Cpus> clocks;
};

constexpr Range exactly(std::uint32_t n) { return {n, n}; }
/// Clocks on 8088, 286 and 386, and the range on a 486.
constexpr std::array<Range, 4> on(std::uint32_t i8088, std::uint32_t i286, std::uint32_t i386,
                                  std::uint32_t i486, std::uint32_t i486_max = 0) {
  return {exactly(i8088), exactly(i286), exactly(i386), {i486, std::max(i486, i486_max)}};
}
constexpr std::array<Range, 2> on_386(std::uint32_t i386, std::uint32_t i486,
                                      std::uint32_t i486_max) {
  return {exactly(i386), {i486, i486_max}};
}

/// Records every instruction and the clocks that the counter adds for it.
struct Recorder {
  Recorder(std::span<const Instruction> program, Cpu cpu) : code(program), counter(program, cpu) {}

  template <class M>
  void before(std::size_t at, const M& m) {
    counter.before(at, m);
  }
  template <class M>
  void operator()(std::size_t at, const M& m) {
    const Range so_far = counter.total();
    counter(at, m);
    texts.push_back(text_of(code[at]));
    clocks.push_back({counter.total().min - so_far.min, counter.total().max - so_far.max});
  }

  std::vector<std::string> texts;
  std::vector<Range> clocks;
  std::span<const Instruction> code;
  ClockCounter counter;
};

template <Routine routine, std::size_t Cpus>
void expect_steps(Target target, std::vector<std::uint32_t> in,
                  const std::vector<Step<Cpus>>& steps) {
  const Program program = assemble(listing(routine, target), {});
  for (std::size_t c = 0; c < Cpus; ++c) {
    const Cpu cpu = cpus.at(cpus.size() - Cpus + c);
    Recorder recorder(program.instructions(), cpu);
    std::array<std::uint32_t, 12> out{};
    call<routine, 16>(program.instructions(), in, out, recorder);
    ASSERT_EQ(recorder.texts.size(), steps.size());
    Range sum;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      EXPECT_EQ(recorder.texts[i], steps[i].text);
      EXPECT_EQ(recorder.clocks[i], steps[i].clocks.at(c)) << name_of(cpu) << ' ' << steps[i].text;
      sum += steps[i].clocks.at(c);
    }
    EXPECT_EQ((count_clocks<routine>(program.instructions(), in, cpu).clocks), sum);
  }
}

// 1.0 * 3.0. IMUL: 3 * 2^16 lies between 2^17 and 2^18, so 18 + 6, plus 3 for the memory operand.
// RET is 10 + 3 because the caller's ADD SP,8 has three components. On a 486 the address waits one
// clock for BP, and IMUL takes 10 + 17 to 10 + 18. Sums: 59; 41 to 50.
TEST(Clocks, FixedMulOfThe386) {
  expect_steps<Routine::mul, 2>(Target::i386, {0x00010000, 0x00030000},
                                {{"push bp", on_386(2, 1, 1)},
                                 {"mov bp, sp", on_386(2, 1, 1)},
                                 {"mov eax, [bp+4]", on_386(4, 2, 3)},
                                 {"imul dword [bp+8]", on_386(27, 27, 29)},
                                 {"add eax, 0x8000", on_386(2, 1, 2)},
                                 {"adc edx, 0", on_386(2, 1, 2)},
                                 {"shr eax, 16", on_386(3, 2, 3)},
                                 {"pop bp", on_386(4, 1, 4)},
                                 {"ret", on_386(13, 5, 5)}});
  const Program program = assemble(listing(Routine::mul, Target::i386), {});
  const std::array<std::uint32_t, 2> in{0x00010000, 0x00030000};
  const auto sum = [&](Cpu cpu) {
    return count_clocks<Routine::mul>(program.instructions(), in, cpu).clocks;
  };
  EXPECT_EQ(sum(Cpu::i386), exactly(59));
  EXPECT_EQ(sum(Cpu::i486), (Range{41, 50}));
}

// 1.0 / 2.0. The jump targets are SUB (66 29 D2: 3 components), DIV (66 F7 F3: 3) and SHLD (66 0F
// A4 C2 10: 5). SUB separates the write of BP from the first address, so a 486 does not wait.
TEST(Clocks, FixedDivOfThe386) {
  expect_steps<Routine::div, 2>(
      Target::i386, {0x00010000, 0x00020000},
      {{"push bp", on_386(2, 1, 1)},         {"mov bp, sp", on_386(2, 1, 1)},
       {"sub cx, cx", on_386(2, 1, 1)},      {"mov eax, [bp+4]", on_386(4, 1, 2)},
       {"and eax, eax", on_386(2, 1, 2)},    {"jns .FDP1", on_386(7 + 3, 3, 3)},
       {"sub edx, edx", on_386(2, 1, 2)},    {"rol eax, 16", on_386(3, 2, 3)},
       {"mov dx, ax", on_386(2, 1, 1)},      {"sub ax, ax", on_386(2, 1, 1)},
       {"mov ebx, [bp+8]", on_386(4, 1, 2)}, {"and ebx, ebx", on_386(2, 1, 2)},
       {"jns .FDP2", on_386(7 + 3, 3, 3)},   {"div ebx", on_386(38, 40, 41)},
       {"shr ebx, 1", on_386(3, 3, 4)},      {"adc ebx, 0", on_386(2, 1, 2)},
       {"dec ebx", on_386(2, 1, 2)},         {"cmp ebx, edx", on_386(2, 1, 2)},
       {"adc eax, 0", on_386(2, 1, 2)},      {"and cx, cx", on_386(2, 1, 1)},
       {"jz .FDP3", on_386(7 + 5, 3, 3)},    {"shld edx, eax, 16", on_386(3, 2, 3)},
       {"pop bp", on_386(4, 1, 4)},          {"ret", on_386(13, 5, 5)}});
}

// 1.0 * 1.0 on all four. On an 8088, [BP+n] takes 9 address clocks and a word operand 4 more. The
// jump targets are MOV BX,[BP+10] (8B 5E 0A: 3 bytes, 3 components), PUSH and POP (1 byte).
TEST(Clocks, FixedMulOfThe8088) {
  expect_steps<Routine::mul, 4>(
      Target::i8088, {0x00010000, 0x00010000},
      {{"push bp", on(11 + 4, 3, 2, 1)},
       {"mov bp, sp", on(2, 2, 2, 1)},
       {"push si", on(11 + 4, 3, 2, 1)},
       {"push di", on(11 + 4, 3, 2, 1)},
       {"sub cx, cx", on(3, 2, 2, 1)},
       {"mov ax, [bp+6]", on(8 + 9 + 4, 5, 4, 1)},
       {"mov si, [bp+4]", on(8 + 9 + 4, 5, 4, 1)},
       {"and ax, ax", on(3, 2, 2, 1)},
       {"jns .CheckSecondOperand", on(16, 7 + 3, 7 + 3, 3)},
       {"mov bx, [bp+10]", on(8 + 9 + 4, 5, 4, 1)},
       {"mov di, [bp+8]", on(8 + 9 + 4, 5, 4, 1)},
       {"and bx, bx", on(3, 2, 2, 1)},
       {"jns .SaveSignStatus", on(16, 7 + 1, 7 + 1, 3)},
       {"push cx", on(11 + 4, 3, 2, 1)},
       {"push ax", on(11 + 4, 3, 2, 1)},
       {"mul bx", on(117 + 1 + 1, 21, 3 + 6, 13)},  // 1 * 1: AX has one 1 bit, DX becomes 0
       {"mov cx, ax", on(2, 2, 2, 1)},
       {"mov ax, si", on(2, 2, 2, 1)},
       {"mul bx", on(117 + 0 + 1, 21, 3 + 6, 13)},  // 0 * 1
       {"mov bx, ax", on(2, 2, 2, 1)},
       {"add cx, dx", on(3, 2, 2, 1)},
       {"pop ax", on(8 + 4, 5, 4, 1, 4)},
       {"mul di", on(117 + 1 + 1, 21, 9, 13)},  // 1 * 0
       {"add bx, ax", on(3, 2, 2, 1)},
       {"adc cx, dx", on(3, 2, 2, 1)},
       {"mov ax, si", on(2, 2, 2, 1)},
       {"mul di", on(117 + 0 + 1, 21, 9, 13)},  // 0 * 0
       {"add ax, 0x8000", on(4, 3, 2, 1)},
       {"adc bx, dx", on(3, 2, 2, 1)},
       {"adc cx, 0", on(4, 3, 2, 1)},
       {"mov dx, cx", on(2, 2, 2, 1)},
       {"mov ax, bx", on(2, 2, 2, 1)},
       {"pop cx", on(8 + 4, 5, 4, 1, 4)},
       {"and cx, cx", on(3, 2, 2, 1)},
       {"jz .FixedMulDone", on(16, 7 + 1, 7 + 1, 3)},
       {"pop di", on(8 + 4, 5, 4, 1, 4)},
       {"pop si", on(8 + 4, 5, 4, 1, 4)},
       {"pop bp", on(8 + 4, 5, 4, 1, 4)},
       {"ret", on(16 + 4, 11 + 3, 10 + 3, 5)}});
}

TEST(Clocks, OtherForms) {
  const Instruction pushes = push(bp);
  const Instruction adds = add(sp, bytes(8));
  const auto expect = [](const Execution& e, const std::array<Range, 4>& all) {
    for (std::size_t c = 0; c < cpus.size(); ++c) {
      EXPECT_EQ(clocks(cpus.at(c), e), all.at(c))
          << name_of(cpus.at(c)) << ' ' << text_of(e.instruction);
    }
  };
  expect({push(word[si + 2])}, on(16 + 9 + 8, 5, 5, 4));
  expect({push(word[si])}, on(16 + 5 + 8, 5, 5, 4));
  expect({neg(word[bp + 4])}, on(16 + 9 + 8, 7, 6, 3));
  expect({neg(dx)}, on(3, 2, 2, 1));
  expect({mov(word[bx], ax)}, on(9 + 5 + 4, 3, 2, 1));
  expect({add(cx, word[si + 12])}, on(9 + 9 + 4, 7, 6, 2));
  expect({mov(ax, word[CosTable + bx])}, on(8 + 9 + 4, 5, 4, 1));
  // The segment override takes 2 clocks on an 8088, up to 1 on a 486.
  expect({mov(ax, word[cs(CosTable + bx)])}, on(8 + 9 + 2 + 4, 5, 4, 1, 2));
  expect({inc(cx)}, on(2, 2, 2, 1));
  expect({dec(bx)}, on(2, 2, 2, 1));
  expect({shl(bx, 1)}, on(2, 2, 3, 3));
  expect({xor_(cx, 1)}, on(4, 3, 2, 1));
  expect({sbb(dx, 0)}, on(4, 3, 2, 1));
  expect({cmp(bx, 3600)}, on(4, 3, 2, 1));
  expect({cmp(bx, ax)}, on(3, 2, 2, 1));
  expect({cmp(bx, word[si])}, on(9 + 5 + 4, 6, 6, 2));
  expect({.instruction = div(bx), .low = 7, .operand = 2}, on(17 + 14 * 8 + 9 + 10, 22, 22, 24));
  expect({ja("far")}, on(4, 3, 3, 1));
  expect({.instruction = jmp("far"), .taken = true, .next = &pushes}, on(15, 7 + 1, 7 + 1, 3));
  expect({.instruction = call("far"), .taken = true, .next = &pushes}, on(19 + 4, 8, 8, 3));
  expect({.instruction = ret(), .taken = true, .next = &adds}, on(16 + 4, 11 + 3, 10 + 3, 5));
}

// The manual says 7, the reverse of its ADD and AND; other tables say 6 as for those.
TEST(Clocks, TheSourcesDifferOnSubtractAndXorFromMemoryOnA386) {
  for (const Mnemonic mnemonic : {Mnemonic::sub, Mnemonic::sbb, Mnemonic::xor_}) {
    Instruction i = sub(ax, word[bx]);
    i.mnemonic = mnemonic;
    EXPECT_EQ(clocks(Cpu::i8088, {i}), exactly(9 + 5 + 4)) << text_of(i);
    EXPECT_EQ(clocks(Cpu::i286, {i}), exactly(7)) << text_of(i);
    EXPECT_EQ(clocks(Cpu::i386, {i}), (Range{6, 7})) << text_of(i);
    EXPECT_EQ(clocks(Cpu::i486, {i}), exactly(2)) << text_of(i);
  }
  EXPECT_EQ(clocks(Cpu::i386, {and_(ax, word[bx])}), exactly(6));
}

TEST(Clocks, MultipliesAndDividesThatNoListingHasHaveNoEntry) {
  for (const Cpu cpu : cpus) {
    EXPECT_EQ(clocks(cpu, {imul(bx)}), std::nullopt);
    EXPECT_EQ(clocks(cpu, {idiv(bx)}), std::nullopt);
    EXPECT_EQ(clocks(cpu, {div(word[bp + 4])}), std::nullopt);
  }
}

TEST(Clocks, OtherFormsThatNoListingHasAreInTheTable) {
  constexpr std::array<Range, 4> add_to_memory = on(16 + 9 + 2 * 4, 7, 7, 3);
  constexpr std::array<Range, 3> shift_of_286 = {exactly(5 + 2), exactly(3), exactly(2)};
  for (std::size_t i = 0; i < cpus.size(); ++i) {
    EXPECT_EQ(clocks(cpus.at(i), {add(word[bp + 4], ax)}), add_to_memory.at(i));
    if (i == 0) continue;
    EXPECT_EQ(clocks(cpus.at(i), {shl(bx, 2)}), shift_of_286.at(i - 1));
  }
  EXPECT_EQ(clocks(Cpu::i8088, {shl(bx, 2)}), std::nullopt);
}

TEST(Clocks, OtherFormsOfThe386) {
  const auto expect = [](const Execution& e, const std::array<Range, 2>& both) {
    EXPECT_EQ(clocks(Cpu::i8088, e), std::nullopt) << text_of(e.instruction);
    EXPECT_EQ(clocks(Cpu::i286, e), std::nullopt) << text_of(e.instruction);
    EXPECT_EQ(clocks(Cpu::i386, e), both[0]) << text_of(e.instruction);
    EXPECT_EQ(clocks(Cpu::i486, e), both[1]) << text_of(e.instruction);
  };
  expect({add(ecx, dword[si + 12])}, on_386(6, 2, 3));
  expect({mov(dword[di], ecx)}, on_386(2, 1, 2));
  expect({shrd(eax, edx, word_bits)}, on_386(3, 2, 3));
  expect({sar(edx, word_bits)}, on_386(3, 2, 3));
  expect({neg(eax)}, on_386(2, 1, 2));
  expect({idiv(dword[bp + 8])}, on_386(46, 44, 45));
  expect({idiv(ebx)}, on_386(43, 43, 44));
}

std::optional<Range> mul_on_8088(std::uint32_t ax_before, std::uint32_t operand) {
  return clocks(Cpu::i8088, {.instruction = mul(bx), .low = ax_before, .operand = operand});
}

TEST(Clocks, MulOfThe8088CountsTheOnesInAx) {
  EXPECT_EQ(mul_on_8088(0, 0xFFFF), exactly(118)) << "none, and DX becomes 0";
  EXPECT_EQ(mul_on_8088(0xFFFF, 0xFFFF), exactly(133)) << "16; the product is FFFE0001h";
  EXPECT_EQ(mul_on_8088(0xFFFF, 1), exactly(134)) << "16, and DX becomes 0";
  EXPECT_EQ(mul_on_8088(0x8000, 2), exactly(118)) << "1; DX becomes 1";
  EXPECT_EQ(mul_on_8088(0x5555, 0x8000), exactly(125)) << "8; DX becomes 2AAAh";
}

std::optional<Range> div_on_8088(std::uint32_t dx_ax, std::uint32_t divisor) {
  return clocks(
      Cpu::i8088,
      {.instruction = div(bx), .low = dx_ax & 0xFFFFU, .high = dx_ax >> 16U, .operand = divisor});
}

TEST(Clocks, DivOfThe8088FollowsTheRestoringDivision) {
  // No step subtracts: 15 * 8 + 7, the minimum in Intel's table.
  EXPECT_EQ(div_on_8088(0, 1), exactly(17 + 15 * 8 + 7));
  // Every step brings down a 1 and subtracts: 15 * 9 + 10, the maximum in Intel's table.
  EXPECT_EQ(div_on_8088(0x0000FFFF, 1), exactly(17 + 15 * 9 + 10));
  // 7 / 2 = 3: 1 < 2, then 11b - 2 leaves 1, then 11b - 2 in the last step.
  EXPECT_EQ(div_on_8088(7, 2), exactly(17 + 14 * 8 + 9 + 10));
  // 6 / 2 = 3: 1 < 2, then 11b - 2 leaves 1, then 10b - 2 in the last step.
  EXPECT_EQ(div_on_8088(6, 2), exactly(17 + 14 * 8 + 9 + 10));
  // 4 / 2 = 2: 10b - 2 leaves 0 in the second to last step, then 0 < 2.
  EXPECT_EQ(div_on_8088(4, 2), exactly(17 + 14 * 8 + 9 + 7));
  // Write the remainder as FFFFh - e: a step doubles e and subtracts the bit it brings down. From e
  // = 1, ones keep e at 1, so every step carries.
  EXPECT_EQ(div_on_8088(0xFFFEFFFF, 0xFFFF), exactly(17 + 15 * 8 + 9));
  // With zeros, steps 1 to 15 carry (e at most 4000h). Step 16, from 7FFFh to FFFEh, does neither.
  EXPECT_EQ(div_on_8088(0xFFFE0000, 0xFFFF), exactly(17 + 15 * 8 + 7));
  // After step k the remainder is 8001h - 2^k. Step 1 carries, from 8000h to 10000h. Steps 2 to 15
  // subtract, from at least 4001h. Step 16, from 1 to 2, does not.
  EXPECT_EQ(div_on_8088(0x80000000, 0x8001), exactly(17 + 8 + 14 * 9 + 7));
}

std::optional<Range> multiply_on_386(const Instruction& i, std::uint32_t multiplier) {
  return clocks(Cpu::i386, {.instruction = i, .operand = multiplier});
}

// 6 plus log2 of the multiplier, rounded up and at least 3.
TEST(Clocks, MultiplyOfThe386StopsAtTheHighestBit) {
  EXPECT_EQ(multiply_on_386(mul(bx), 0), exactly(9));
  EXPECT_EQ(multiply_on_386(mul(bx), 1), exactly(9));
  EXPECT_EQ(multiply_on_386(mul(bx), 8), exactly(9));
  EXPECT_EQ(multiply_on_386(mul(bx), 9), exactly(10));
  EXPECT_EQ(multiply_on_386(mul(bx), 0x8000), exactly(21));
  EXPECT_EQ(multiply_on_386(mul(bx), 0xFFFF), exactly(22)) << "the most in the table";
  const Instruction by_memory = imul(dword[bp + 8]);
  EXPECT_EQ(multiply_on_386(by_memory, 0), exactly(12));
  EXPECT_EQ(multiply_on_386(by_memory, 0xFFFFFFFF), exactly(12)) << "the magnitude of -1";
  EXPECT_EQ(multiply_on_386(by_memory, 0xFFFF0000), exactly(25)) << "2^16";
  EXPECT_EQ(multiply_on_386(by_memory, 0x7FFFFFFF), exactly(40));
  EXPECT_EQ(multiply_on_386(by_memory, 0x80000000), exactly(40)) << "2^31";
}

std::optional<Range> multiply_on_486(const Instruction& i, std::uint32_t multiplier) {
  return clocks(Cpu::i486, {.instruction = i, .operand = multiplier});
}

// 10 plus log2 of the multiplier, between rounded down and rounded up, and at least 3, or at least
// 5 for a negative multiplier. The prefix of a dword instruction may take one more clock.
TEST(Clocks, MultiplyOfThe486FollowsTheManualsRule) {
  EXPECT_EQ(multiply_on_486(mul(bx), 0), exactly(13)) << "the least in the table";
  EXPECT_EQ(multiply_on_486(mul(bx), 1), exactly(13));
  EXPECT_EQ(multiply_on_486(mul(bx), 8), exactly(13));
  EXPECT_EQ(multiply_on_486(mul(bx), 9), (Range{13, 14}));
  EXPECT_EQ(multiply_on_486(mul(bx), 0x8000), exactly(25)) << "MUL has no negative multiplier";
  EXPECT_EQ(multiply_on_486(mul(bx), 0xFFFF), (Range{25, 26})) << "the most in the table";
  EXPECT_EQ(multiply_on_486(mul(ebx), 0xFFFFFFFF), (Range{41, 42 + 1})) << "the most in the table";
  const Instruction by_memory = imul(dword[bp + 8]);
  EXPECT_EQ(multiply_on_486(by_memory, 0), (Range{13, 13 + 1}));
  EXPECT_EQ(multiply_on_486(by_memory, 0xFFFFFFFF), (Range{15, 15 + 1})) << "-1";
  EXPECT_EQ(multiply_on_486(by_memory, 0xFFFFFFE0), (Range{15, 15 + 1})) << "-32";
  EXPECT_EQ(multiply_on_486(by_memory, 0xFFFFFFDF), (Range{15, 16 + 1})) << "-33";
  EXPECT_EQ(multiply_on_486(by_memory, 33), (Range{15, 16 + 1}));
  EXPECT_EQ(multiply_on_486(by_memory, 0x7FFFFFFF), (Range{40, 41 + 1}));
  EXPECT_EQ(multiply_on_486(by_memory, 0x80000000), (Range{41, 41 + 1})) << "-2^31";
}

/// The extra clocks of an instruction on a 486 because of the instruction before it.
Range wait_after(const Instruction& before, const Instruction& i) {
  const Range alone = clocks(Cpu::i486, {i}).value();
  const Range after = clocks(Cpu::i486, {.instruction = i, .previous = &before}).value();
  EXPECT_EQ(clocks(Cpu::i386, {.instruction = i, .previous = &before}), clocks(Cpu::i386, {i}));
  return {after.min - alone.min, after.max - alone.max};
}

TEST(Clocks, The486WaitsForABaseRegisterJustWritten) {
  const Instruction load = mov(ax, word[bx]);
  for (const Instruction& writes_bx :
       {mov(bx, si), mov(bl, dh), pop(bx), shl(bx, 2), neg(bx), add(bx, ax)}) {
    EXPECT_EQ(wait_after(writes_bx, load), exactly(1)) << text_of(writes_bx);
    EXPECT_EQ(wait_after(writes_bx, mov(word[bx], ax)), exactly(1)) << text_of(writes_bx);
  }
  for (const Instruction& leaves_bx : {mov(si, bx), mov(dh, bl), push(bx), cmp(bx, ax), mul(bx),
                                       div(bx), jmp(bx), mov(word[bx], ax), stosb(), ret()}) {
    EXPECT_EQ(wait_after(leaves_bx, load), exactly(0)) << text_of(leaves_bx);
  }
  EXPECT_EQ(wait_after(mov(ah, dh), mov(byte[Screen + eax], bl)), exactly(1));
  EXPECT_EQ(wait_after(mov(dh, bl), mov(ax, word[si])), exactly(0)) << "DH is no part of SI";
  EXPECT_EQ(wait_after(mov(bx, si), mov(ax, bx)), exactly(0)) << "no address";
  EXPECT_EQ(wait_after(mov(ax, si), mov(ax, word[IncJ])), exactly(0)) << "no register in it";
}

TEST(Clocks, The486WaitsForRegistersWrittenUnnamed) {
  for (const Instruction& i : {mul(bx), div(bx)}) {
    EXPECT_EQ(wait_after(i, mov(byte[Screen + eax], bl)), exactly(1)) << text_of(i);
    EXPECT_EQ(wait_after(i, mov(byte[Screen + edx], bl)), exactly(1)) << text_of(i);
  }
  EXPECT_EQ(wait_after(stosb(), mov(byte[Screen + edi], bl)), exactly(1));
  EXPECT_EQ(wait_after(loop("Pixel"), mov(byte[Screen + ecx], bl)), exactly(1));
}

// The manual states its rule only for the base register.
TEST(Clocks, The486MayWaitForAScaledIndex) {
  EXPECT_EQ(wait_after(inc(edi), cmp(bx, word[ZBuff + twice(edi)])), (Range{0, 1}));
  EXPECT_EQ(wait_after(inc(esi), cmp(bx, word[ZBuff + twice(edi)])), exactly(0));
}

TEST(Clocks, The486WaitsForAStackPointerWrittenByName) {
  const Instruction moves_sp = add(sp, bytes(8));
  for (const Instruction& i : {push(cx), pop(cx), call("far"), ret()}) {
    EXPECT_EQ(wait_after(moves_sp, i), exactly(1)) << text_of(i);
    for (const Instruction& stacks : {push(si), pop(si), call("far"), ret(), mov(bp, sp)}) {
      EXPECT_EQ(wait_after(stacks, i), exactly(0)) << text_of(stacks) << "; " << text_of(i);
    }
  }
  EXPECT_EQ(wait_after(moves_sp, mov(ax, word[bx])), exactly(0));
}

TEST(Clocks, EveryFormOfEveryListingHasAnEntry) {
  test::each_routine([]<Routine routine, Target target>() {
    for (const Build& build : test::builds) {
      const Program program = assemble(listing(routine, target), build);
      for (const Instruction& i : program.instructions()) {
        for (const Cpu cpu : cpus) {
          if (target == Target::i386 && cpu < Cpu::i386) continue;
          EXPECT_TRUE(clocks(cpu, {.instruction = i, .operand = 1}))
              << name_of(cpu) << ' ' << text_of(i);
        }
      }
    }
  });
}

TEST(Clocks, AProcessorIsNotCountedForCodeItCannotRun) {
  test::each_routine([]<Routine routine, Target target>() {
    if (target == Target::i8088) return;
    const Program program = assemble(listing(routine, target), {});
    const auto words = test::cases(routine);
    const auto in = std::span(words).first(static_cast<std::size_t>(arity(routine).in));
    for (const Cpu cpu : {Cpu::i8088, Cpu::i286}) {
      EXPECT_THROW(count_clocks<routine>(program.instructions(), in, cpu), std::invalid_argument);
    }
  });
}

TEST(Clocks, EachProcessorNeedsFewerThanTheOneBefore) {
  test::each_routine([]<Routine routine, Target target>() {
    const Program program = assemble(listing(routine, target), {});
    const auto words = test::cases(routine);
    const auto in = static_cast<std::size_t>(arity(routine).in);
    for (std::size_t i = 0; i + in <= words.size(); i += in) {
      std::array<std::uint32_t, 12> out{};
      const auto operands = std::span(words).subspan(i, in);
      const Ending ending = call<routine, 16>(program.instructions(), operands, out);
      Range before{1'000'000, 1'000'000};
      for (const Cpu cpu : cpus) {
        if (target == Target::i386 && cpu < Cpu::i386) continue;
        const auto [counted, clocks, bus] =
            count_clocks<routine>(program.instructions(), operands, cpu);
        ASSERT_EQ(counted.outcome, ending.outcome);
        ASSERT_EQ(counted.steps, ending.steps);
        ASSERT_EQ(bus == BusBytes{}, cpu != Cpu::i8088);
        ASSERT_LE(clocks.min, clocks.max);
        ASSERT_LT(clocks.min, before.min) << name_of(routine) << name_of(cpu) << " case " << i / in;
        // In the worst case, a 486 is no faster than a 386.
        if (cpu != Cpu::i486) {
          ASSERT_LT(clocks.max, before.max) << name_of(routine) << name_of(cpu) << ' ' << i / in;
        }
        before = clocks;
      }
    }
  });
}

/// Adds up the clocks without a memory of what it has looked up.
struct EachTime {
  std::span<const Instruction> code;
  Cpu cpu;
  const Instruction* previous = nullptr;
  Range pending{};
  Range total{};

  template <class M>
  void before(std::size_t at, const M& m) {
    Execution execution = detail::execution_at(code, at, m);
    execution.previous = previous;
    previous = &code[at];
    pending = clocks(cpu, execution).value();
  }
  template <class M>
  void operator()(std::size_t /*at*/, const M& /*m*/) {
    total += pending;
  }
};

/// Counts calls with copies of one counter, and expects the clocks of each call.
template <Routine routine>
void expect_clocks_of_each_call(const Program& program, const std::vector<std::uint32_t>& words,
                                Cpu cpu) {
  const auto in = static_cast<std::size_t>(arity(routine).in);
  const auto out_words = static_cast<std::size_t>(arity(routine).out);
  const ClockCounter fresh(program.instructions(), cpu);
  for (std::size_t i = 0; i + in <= words.size(); i += in) {
    const auto operands = std::span(words).subspan(i, in);
    std::array<std::uint32_t, 12> out{};
    ClockCounter used = fresh;
    call<routine, 16>(program.instructions(), operands, std::span(out).first(out_words), used);
    EachTime expected{program.instructions(), cpu};
    call<routine, 16>(program.instructions(), operands, std::span(out).first(out_words), expected);
    ASSERT_EQ(used.total(), expected.total) << name_of(routine) << name_of(cpu) << i / in;
    ASSERT_EQ(used.bus(), count_clocks<routine>(program.instructions(), operands, cpu).bus);
  }
}

TEST(Clocks, AreThoseOfEachCallWhateverWasCountedBefore) {
  test::each_routine([]<Routine routine, Target target>() {
    for (const Cpu cpu : cpus) {
      if (target == Target::i386 && cpu < Cpu::i386) continue;
      expect_clocks_of_each_call<routine>(assemble(listing(routine, target), {}),
                                          test::cases(routine), cpu);
    }
  });
}

// A 486 waits for BP unless the jump is taken. The length behind each call counts on a 286 and 386.
TEST(Clocks, DependOnTheInstructionsBeforeAndBehind) {
  const Program program =
      assemble({push(bp), mov(bp, sp), mov(ax, word[bp + 4]), and_(ax, ax), jz("same"), mov(bp, sp),
                label("same"), mov(dx, word[bp + 6]), call("sub"), mov(dx, word[bp + 6]),
                call("sub"), dec(ax), pop(bp), ret(), label("sub"), inc(ax), ret()},
               {});
  for (const Cpu cpu : cpus) {
    expect_clocks_of_each_call<Routine::mul>(program, {1, 1, 0, 1, 2, 1, 0, 0}, cpu);
  }
}

TEST(Clocks, AFaultAddsNone) {
  const Program program = assemble(listing(Routine::div, Target::i386), {});
  const std::array<std::uint32_t, 2> in{0x00010000, 0};
  const auto [ending, clocks, bus] =
      count_clocks<Routine::div>(program.instructions(), in, Cpu::i386);
  EXPECT_EQ(ending.outcome, Outcome::divide_error);
  EXPECT_EQ(bus, BusBytes{});
  EXPECT_EQ(clocks, exactly(2 + 2 + 2 + 4 + 2 + 10 + 2 + 3 + 2 + 2 + 4 + 2 + 10));
}

}  // namespace

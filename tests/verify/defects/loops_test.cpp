// Tests the inner loops against the claims of their source.
#include "tests/support/test.hpp"
#include "x86model/call_loop.hpp"

namespace {

namespace x86 = x86model;
using x86::Counting;
using x86::Loop;
using x86::LoopForm;
using x86::LoopMachine;
using x86::Outcome;
using x86::Register;
using x86::Size;

constexpr std::size_t screen = 0x100;
constexpr std::size_t depths = 0x500;

/// One segment for all data, and its contents after a loop.
struct Drawn {
  std::vector<std::uint8_t> memory = std::vector<std::uint8_t>(0x10000);
  x86::Ending ending{};
  LoopMachine machine{.registers = {}, .memory = x86::ByteMemory(memory, memory, memory)};

  Drawn(const LoopForm& form, const x86::LoopCall& call, std::uint32_t ebx = 0,
        std::uint64_t limit = 1'000'000) {
    machine.registers.write(Register::bx, Size::dword, ebx);
    ending = x86::call_loop(
        form, x86::code_of(form), machine, call, [](std::size_t, const LoopMachine&) {}, limit);
  }
  [[nodiscard]] int depth(std::size_t i) const {
    return memory.at(depths + 2 * i) + 256 * memory.at(depths + 2 * i + 1);
  }
};

LoopForm depth_test(bool as_printed) {
  return {.loop = Loop::depth_test, .as_printed = as_printed};
}

TEST(Defects, ShrdForShld) {
  const x86::LoopCall call{.pixels = 1, .value = 0x1234, .colour = 7};
  const Drawn meant(depth_test(false), call);
  EXPECT_EQ(meant.depth(0), 0x12);
  // The low byte of the depth, its fraction, above EBX's old top byte.
  const Drawn printed(depth_test(true), call, 0xAB000000);
  EXPECT_EQ(printed.depth(0), 0x34AB);
  // Bits 23 to 16 of one pixel's depth end up below the fraction of the next.
  const Drawn second(depth_test(true), {.pixels = 2, .value = 0x00560078, .step = 2});
  EXPECT_EQ(second.depth(0), 0x7800);
  EXPECT_EQ(second.depth(1), 0x7A56);
  // A depth of 2 exceeds the 0 in the buffer, but is not drawn because its fraction is 0.
  const x86::LoopCall two{.pixels = 1, .value = 0x0200, .colour = 7};
  EXPECT_EQ(Drawn(depth_test(true), two).memory.at(screen), 0);
  EXPECT_EQ(Drawn(depth_test(false), two).memory.at(screen), 7);
}

TEST(Defects, NoPixels) {
  const LoopForm loop{Loop::gouraud_byte};
  std::vector<std::uint8_t> extra(0x10000, 1);
  std::vector<std::uint8_t> data(0x100);
  LoopMachine m{.registers = {}, .memory = x86::ByteMemory(data, extra, data)};
  const auto ending = x86::call_loop(
      loop, x86::code_of(loop), m, {.pixels = 0}, [](std::size_t, const LoopMachine&) {},
      1'000'000);
  EXPECT_EQ(ending.outcome, Outcome::returned);
  EXPECT_EQ(std::count(extra.begin(), extra.end(), 0), 65536);
  EXPECT_EQ(ending.steps, 4 * 65536 + 1);
  // DEC ECX differs: it runs four instructions and JNZ 2^32 times.
  const LoopForm dec{Loop::gouraud_byte, Counting::dec_jnz};
  EXPECT_EQ(Drawn(dec, {.pixels = 0, .place = 0x8000}).ending.outcome, Outcome::step_limit);
  // It also differs for a count with bits in its upper half, which LOOP ignores.
  EXPECT_EQ(Drawn(loop, {.pixels = 0x10001}).ending.steps, 5U);
  EXPECT_EQ(Drawn(dec, {.pixels = 0x10001, .place = 0x8000}, 0, 1000).ending.outcome,
            Outcome::step_limit);
}

TEST(Defects, OddPixel) {
  const LoopForm words{Loop::gouraud_word};
  constexpr std::uint32_t row = 0x2800;
  const Drawn seven(words, {.pixels = 7, .place = row, .value = 0x100});
  EXPECT_EQ(std::count(seven.memory.begin() + row, seven.memory.begin() + row + 7, 1), 6);
  EXPECT_EQ(seven.machine.registers.read(Register::di, Size::word), row + 6);
  // One pixel is zero pairs, which the loop takes for 65,536.
  std::vector<std::uint8_t> extra(0x10000, 1);
  std::vector<std::uint8_t> data(0x100);
  LoopMachine m{.registers = {}, .memory = x86::ByteMemory(data, extra, data)};
  x86::call_loop(
      words, x86::code_of(words), m, {.pixels = 1}, [](std::size_t, const LoopMachine&) {},
      1'000'000);
  EXPECT_EQ(std::count(extra.begin(), extra.end(), 0), 65536);
}

TEST(Defects, DepthTestWords) {
  const auto is_drawn = [](std::int32_t depth, std::uint16_t buffer) {
    std::vector<std::uint8_t> memory(0x10000);
    memory.at(depths) = static_cast<std::uint8_t>(buffer);
    memory.at(depths + 1) = static_cast<std::uint8_t>(buffer >> 8U);
    LoopMachine m{.registers = {}, .memory = x86::ByteMemory(memory, memory, memory)};
    const LoopForm form = depth_test(false);
    x86::call_loop(form, x86::code_of(form), m,
                   {.pixels = 1, .value = static_cast<std::uint32_t>(depth) << 8U, .colour = 7});
    return memory.at(screen) == 7;
  };
  // The text keeps the pixel of greater depth. The code draws only pixels of greater depth.
  EXPECT_TRUE(is_drawn(1, 0));
  EXPECT_FALSE(is_drawn(0, 0));
  EXPECT_FALSE(is_drawn(-1, 0));
  // Every depth greater than minus infinity, the smallest word, is drawn, whatever its sign.
  constexpr std::uint16_t minus_infinity = 0x8000;
  for (std::int32_t depth = -32767; depth <= 32767; ++depth) {
    ASSERT_TRUE(is_drawn(depth, minus_infinity)) << depth;
  }
  EXPECT_FALSE(is_drawn(-32768, minus_infinity));
}

TEST(Defects, BufferBeyondSegment) {
  // A buffer at offset 0 of its segment; the index wraps at 32 bits.
  const auto reached = [](std::uint32_t pixel) {
    const auto index = pixel - static_cast<std::uint32_t>(depths) / 2;
    return Drawn(depth_test(false), {.pixels = 1, .place = index}).ending.outcome;
  };
  constexpr std::uint32_t first_beyond = 65536 / 2;
  EXPECT_EQ(reached(first_beyond - 1), Outcome::returned);
  EXPECT_EQ(reached(first_beyond), Outcome::bad_address);
  EXPECT_EQ(reached(320 * 200 - 1), Outcome::bad_address);
  EXPECT_EQ(first_beyond / 320, 102U);
}

TEST(Defects, StepBeforeFetch) {
  // A texel of row 0 is its column number.
  const auto drawn = [](x86::Counting counting, std::uint32_t pixels) {
    std::vector<std::uint8_t> data(0x10000);
    std::vector<std::uint8_t> row(0x10000);
    const auto texture = static_cast<std::size_t>(x86::address_of(x86::Symbol::texture));
    for (std::size_t column = 0; column < 256; ++column) {
      data.at(texture + column) = static_cast<std::uint8_t>(column);
    }
    const LoopForm form{Loop::texture, counting};
    LoopMachine m{.registers = {}, .memory = x86::ByteMemory(data, row, data)};
    x86::call_loop(form, x86::code_of(form), m,
                   {.pixels = pixels, .value = 1U << 8U, .step = 1U << 8U});
    row.resize(pixels);
    return row;
  };
  using Texels = std::vector<std::uint8_t>;
  for (const auto counting : {Counting::loop, Counting::dec_jnz, Counting::unrolled}) {
    EXPECT_EQ(drawn(counting, 1), Texels{1});
    // Stepping before the fetch, as the pseudo-code does, would give 2, 3 and 4.
    EXPECT_EQ(drawn(counting, 3), (Texels{1, 2, 3}));
  }
}

}  // namespace

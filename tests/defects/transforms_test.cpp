// Transforms: one translation too many, one element too many, one vector too few.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "oracle/exact.hpp"
#include "tests/defects/routine.hpp"

namespace {

namespace x86 = x86model;
using defects::ask;
using defects::Words;
using enum x86model::Routine;
using enum x86model::Target;

constexpr std::uint32_t one = 0x10000;

/// The identity with a translation, in units of 1.0.
Words move(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return {one, 0, 0, x * one, 0, one, 0, y * one, 0, 0, one, z * one};
}

Words both(Words first, const Words& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

// Moving by (4, 5, 6), then by (1, 2, 3), is moving by (5, 7, 9).
TEST(Defects, TranslationInEveryColumn) {
  const Words moves = both(move(1, 2, 3), move(4, 5, 6));
  for (const auto target : defects::targets) {
    EXPECT_EQ(ask<concat>(target, defects::rounded, moves), defects::values(move(5, 7, 9)));
  }
  Words spoiled = move(5, 7, 9);
  for (std::size_t i = 0; i < spoiled.size(); ++i) {
    if (i % 4 != 3) spoiled[i] += static_cast<std::uint32_t>(i / 4 + 1) * one;
  }
  const x86::Build chapter_52{.chapter_52 = true};
  EXPECT_EQ(ask<concat>(i386, chapter_52, moves), defects::values(spoiled));
  // Not to be seen where the first translation is zero.
  EXPECT_EQ(ask<concat>(i386, chapter_52, both(move(0, 0, 0), move(4, 5, 6))),
            defects::values(move(4, 5, 6)));
  const auto exact = [&](oracle::TranslationColumn column) {
    const std::span<const std::uint32_t, 24> in(moves.data(), 24);
    const auto product =
        oracle::concat(in.first<12>(), in.last<12>(), oracle::Rounding::half_up, column, 16);
    return Words(product.begin(), product.end());
  };
  EXPECT_EQ(exact(oracle::TranslationColumn::fourth), move(5, 7, 9));
  EXPECT_EQ(exact(oracle::TranslationColumn::every), spoiled);
}

// A transform is three rows of four: 12 doublewords. Row 3, column 3 would be the 16th.
TEST(Defects, OutOfBounds) {
  constexpr std::uint32_t bytes_of_element = 4;
  const auto address = [](std::uint32_t row, std::uint32_t column) {
    return bytes_of_element * (4 * row + column);
  };
  x86::WordMemory<16, 24> transform;
  EXPECT_TRUE(transform.write(address(2, 3), 0));
  EXPECT_TRUE(transform.write(address(2, 3) + 2, 1));
  EXPECT_FALSE(transform.write(address(3, 3), 0));
  EXPECT_FALSE(transform.write(address(3, 3) + 2, 1));
  // The same store in C++ that looks at its index.
  std::array<std::array<std::int32_t, 4>, 3> rows{};
  EXPECT_THROW(rows.at(3).at(3) = 1, std::out_of_range);
  EXPECT_EQ(x86::arity(xformvec).in, 12 + 3);
  // Where a second transform follows it is that one's row 0, column 3.
  constexpr std::uint32_t bytes_of_transform = 12 * bytes_of_element;
  EXPECT_EQ(address(3, 3), bytes_of_transform + address(0, 3));
  x86::WordMemory<16, 48> two;
  EXPECT_TRUE(two.write(address(3, 3), 0));
}

/// ConcatXforms with DestXform made to point at one of its sources, 0 or 1, and what stands there
/// afterwards.
Words concat_in_place(x86::Target target, const Words& in, std::uint32_t which) {
  x86::CallMachine<concat, 16> machine;
  x86::enter<concat>(machine, in);
  // Above the return address: SourceXform1, SourceXform2, DestXform.
  const std::uint32_t sp = machine.registers.read(x86::Register::sp, x86::Size::word);
  std::uint32_t source = 0;
  EXPECT_TRUE(machine.memory.read(sp + 2 + 2 * which, source));
  EXPECT_TRUE(machine.memory.write(sp + 6, source));
  const x86::Program program = x86::assemble(x86::listing(concat, target), defects::rounded);
  EXPECT_EQ(x86::run(program.instructions(), machine).outcome, x86::Outcome::returned);
  Words transform;
  for (std::uint32_t at = source; at < source + 48; at += 4) {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    EXPECT_TRUE(machine.memory.read(at, low));
    EXPECT_TRUE(machine.memory.read(at + 2, high));
    transform.push_back(high << 16U | low);
  }
  return transform;
}

/// XformVec with DestVec made to point at the source vector, and what stands there afterwards.
Words transform_in_place(x86::Target target, const Words& in) {
  x86::CallMachine<xformvec, 16> machine;
  x86::enter<xformvec>(machine, in);
  // Above the return address: WorkingXform, SourceVec, DestVec.
  const std::uint32_t sp = machine.registers.read(x86::Register::sp, x86::Size::word);
  std::uint32_t source = 0;
  EXPECT_TRUE(machine.memory.read(sp + 4, source));
  EXPECT_TRUE(machine.memory.write(sp + 6, source));
  const x86::Program program = x86::assemble(x86::listing(xformvec, target), defects::rounded);
  EXPECT_EQ(x86::run(program.instructions(), machine).outcome, x86::Outcome::returned);
  Words vector;
  for (std::uint32_t at = source; at < source + 12; at += 4) {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    EXPECT_TRUE(machine.memory.read(at, low));
    EXPECT_TRUE(machine.memory.read(at + 2, high));
    vector.push_back(high << 16U | low);
  }
  return vector;
}

// The transform that swaps x and y, on (1, 2, 3): the new x is taken for the old one.
TEST(Defects, InPlace) {
  const Words swap{0, one, 0, 0, one, 0, 0, 0, 0, 0, one, 0};
  const Words in = both(swap, {one, 2 * one, 3 * one});
  for (const auto target : defects::targets) {
    EXPECT_EQ(ask<xformvec>(target, defects::rounded, in),
              defects::values({2 * one, one, 3 * one}));
    EXPECT_EQ(transform_in_place(target, in), (Words{2 * one, 2 * one, 3 * one}));
  }
  // The swap times itself: each element is taken for the old one as soon as it is written.
  const Words twice = both(swap, swap);
  for (const auto target : defects::targets) {
    EXPECT_EQ(ask<concat>(target, defects::rounded, twice), defects::values(move(0, 0, 0)));
    EXPECT_EQ(concat_in_place(target, twice, 0), (Words{one, one, 0, 0, 0, 0, 0, 0, 0, 0, one, 0}));
    EXPECT_EQ(concat_in_place(target, twice, 1), (Words{one, 0, 0, 0, one, 0, 0, 0, 0, 0, one, 0}));
  }
}

}  // namespace

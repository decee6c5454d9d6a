// Tests rounding: a switch with inverted meaning, halves, and a wrong comment.
#include "app/cli/options.hpp"
#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"
#include "tests/verify/defects/routine.hpp"
#include "verify/parties/party.hpp"

namespace {

using defects::ask;
using defects::value;
using enum x86model::Routine;
using enum x86model::Target;

std::uint32_t divide_as_printed(fixproof::cases::Target target, std::uint32_t n, std::uint32_t d) {
  fixproof::cli::VariantOptions options;
  options.targets = {target};
  options.as_printed = true;
  const fixproof::cases::Variant variant = options.choose(fixproof::cases::Operation::div);
  const std::array in{n, d};
  std::array<std::uint32_t, 1> out{};
  std::array<fixproof::parties::Ending, 1> ending{};
  fixproof::parties::party_named("model").answer(variant, {in, out, ending});
  EXPECT_EQ(ending[0], fixproof::parties::Ending::value);
  return out[0];
}

// Two thirds is 43690 2/3 units. The switch is printed off for both processors.
TEST(Defects, InvertedSwitch) {
  EXPECT_EQ(divide_as_printed(fixproof::cases::Target::i386, 0x20000, 0x30000), 0xAAAA);
  EXPECT_EQ(divide_as_printed(fixproof::cases::Target::i8088, 0x20000, 0x30000), 0xAAAB);
  // Both processors obey an explicit rounding option.
  for (const auto target : defects::targets) {
    EXPECT_EQ(ask<div>(target, defects::unrounded, {0x20000, 0x30000}), value(0xAAAA));
    EXPECT_EQ(ask<div>(target, defects::rounded, {0x20000, 0x30000}), value(0xAAAB));
  }
  // The type's name states its rounding.
  const auto two_thirds = []<class Number>(Number) { return (Number(2) / Number(3)).raw(); };
  EXPECT_EQ(two_thirds(fixproof::q16_16_i386_mul_rounded()), 0xAAAA);
  EXPECT_EQ(two_thirds(fixproof::q16_16_i8088_mul_rounded()), 0xAAAA);
  EXPECT_EQ(two_thirds(fixproof::q16_16_i8088()), 0xAAAB);
}

TEST(Defects, Ties) {
  const defects::Words minus_half{0xFFFFFFFF, 0x8000};
  EXPECT_EQ(ask<mul>(i386, defects::rounded, minus_half), value(0));
  EXPECT_EQ(ask<mul>(i8088, defects::rounded, minus_half), value(0xFFFFFFFF));
  EXPECT_EQ(ask<mul>(i386, defects::unrounded, minus_half), value(0xFFFFFFFF));
  EXPECT_EQ(ask<mul>(i8088, defects::unrounded, minus_half), value(0));
  // A point at x = -1 unit, in a scene of half the size, gets two different places.
  defects::Words half_size_and_point(15, 0);
  half_size_and_point[0] = half_size_and_point[5] = half_size_and_point[10] = 0x8000;
  half_size_and_point[12] = 0xFFFFFFFF;
  EXPECT_EQ(ask<xformvec>(i386, defects::rounded, half_size_and_point), defects::values({0, 0, 0}));
  EXPECT_EQ(ask<xformvec>(i8088, defects::rounded, half_size_and_point),
            defects::values({0xFFFFFFFF, 0, 0}));

  const auto product = []<class Number>(Number) {
    return (Number::from_raw(-1) * Number::from_raw(0x8000)).raw();
  };
  EXPECT_EQ(product(fixproof::q16_16()), 0);
  EXPECT_EQ(product(fixproof::q16_16_i386()), 0);
  EXPECT_EQ(product(fixproof::q16_16_i8088()), -1);
  EXPECT_EQ(product(fixproof::q16_16_i386_unrounded()), -1);
  EXPECT_EQ(product(fixproof::q16_16_i8088_unrounded()), 0);
}

// Rounding adds 2^-17: products of 2^-17 and more become a unit, smaller ones 0. If it added 2^-16,
// as one comment says, every product above zero would become a unit.
TEST(Defects, Comments) {
  for (const auto target : defects::targets) {
    EXPECT_EQ(ask<mul>(target, defects::rounded, {1, 0x8000}), value(1));
    EXPECT_EQ(ask<mul>(target, defects::rounded, {1, 0x7FFF}), value(0));
  }
  EXPECT_EQ((fixproof::q16_16::from_raw(1) * fixproof::q16_16::from_raw(0x8000)).raw(), 1);
  EXPECT_EQ((fixproof::q16_16::from_raw(1) * fixproof::q16_16::from_raw(0x7FFF)).raw(), 0);
}

}  // namespace

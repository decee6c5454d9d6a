// Tests FixedDiv: vanishing faults, half of the divisor range, an undefined carry, and lost
// arguments.
#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"
#include "tests/verify/defects/routine.hpp"
#include "x86model/notation.hpp"

namespace {

namespace x86 = x86model;
using defects::ask;
using defects::value;
using enum x86model::Routine;
using enum x86model::Target;

// 8001h units / 1 unit: the quotient is 8001h 0000h units, just above 2^31.
TEST(Defects, VanishingFault) {
  EXPECT_EQ(ask<div>(i386, defects::rounded, {0x8001, 1}), value(0x80010000));
  EXPECT_EQ(ask<div>(i386, defects::rounded, {0x8001, 0xFFFFFFFF}), value(0x7FFF0000));
  EXPECT_EQ(ask<div>(i386, defects::unrounded, {0x8001, 1}), defects::divide_error);
  EXPECT_EQ(ask<div>(i386, defects::unrounded, {0x8001, 0xFFFFFFFF}), defects::divide_error);
  // From 2^32 on, both fault.
  EXPECT_EQ(ask<div>(i386, defects::rounded, {0x10000, 1}), defects::divide_error);

  const auto quotient = []<class Number>(Number) {
    return fixproof::try_divide(Number::from_raw(0x8001), Number::from_raw(1));
  };
  EXPECT_EQ(quotient(fixproof::q16_16_i386())->raw(), static_cast<std::int32_t>(0x80010000));
  EXPECT_FALSE(quotient(fixproof::q16_16_i386_mul_rounded()));
  EXPECT_FALSE(quotient(fixproof::q16_16_trapping()));
  EXPECT_EQ(quotient(fixproof::q16_16_saturating())->raw(), 0x7FFFFFFF);
}

constexpr double pixels_of_unit_slope = 320;

/// The error of x / z * -320 in pixels, in the type's arithmetic.
template <class Number>
double pixels_off(std::int32_t x, std::int32_t z) {
  const Number projected = Number::from_raw(x) / Number::from_raw(z) * Number(-320);
  return std::abs(static_cast<double>(projected) + pixels_of_unit_slope * x / z);
}

/// The largest error at the screen's edge (x = z / 2), at the last depth before a whole distance,
/// where the divisor drops almost one. One of the `distance` points has the worst rounding.
template <class Number>
double pixels_off_before(int distance) {
  const std::int32_t z = distance * 65536 - 1;
  double most = 0;
  for (std::int32_t x = z / 2; x > z / 2 - distance; --x) {
    most = std::max(most, pixels_off<Number>(x, z));
  }
  return most;
}

// The 8088 divides by the whole part of z, which enlarges the picture by z / floor(z), at the edge
// by 160 (z / floor(z) - 1) pixels. Half a unit of the quotient adds 160 / 65536 = 0.00244. The sum
// reaches half a pixel for depths up to 322: 160 / 322 + 0.00244 = 0.4993.
TEST(Defects, HalfRangeDivisor) {
  EXPECT_EQ(ask<div>(i8088, defects::rounded, {0x10000, 0xFFFF}), defects::divide_error);
  EXPECT_EQ(ask<div>(i8088, defects::rounded, {0xFFFF, 0x1FFFF}), value(0xFFFF));
  EXPECT_EQ(ask<div>(i386, defects::rounded, {0xFFFF, 0x1FFFF}), value(0x8000));

  using On8088 = fixproof::q16_16_i8088;
  EXPECT_NEAR(pixels_off_before<On8088>(2), 160, 0.01);
  EXPECT_NEAR(pixels_off_before<On8088>(3), 80, 0.01);
  EXPECT_NEAR(pixels_off_before<On8088>(11), 16, 0.01);
  EXPECT_NEAR(pixels_off_before<On8088>(5), 40, 0.01);
  EXPECT_NEAR(pixels_off_before<On8088>(101), 1.6, 0.01);
  EXPECT_NEAR(pixels_off_before<On8088>(320), 0.504, 0.0001);
  EXPECT_NEAR(pixels_off_before<On8088>(321), 0.5024, 0.0001);
  EXPECT_NEAR(pixels_off_before<On8088>(322), 0.5009, 0.0001);
  EXPECT_NEAR(pixels_off_before<On8088>(323), 0.4993, 0.0001);
  for (int distance = 2; distance <= 322; ++distance) {
    EXPECT_GT(pixels_off_before<On8088>(distance), 0.5) << distance;
  }
  // From 323 on, 160 / 322 + 160 / 65536 bounds all errors.
  for (int distance = 323; distance <= 1000; ++distance) {
    EXPECT_LT(pixels_off_before<On8088>(distance), 0.5) << distance;
  }
  // With the whole divisor, the error is at most half a unit of the quotient, 320 / 131072 pixels.
  for (int distance = 2; distance <= 1000; ++distance) {
    EXPECT_LE(pixels_off_before<fixproof::q16_16>(distance), 320.0 / 131072) << distance;
    EXPECT_LE(pixels_off_before<fixproof::q16_16_i386>(distance), 320.0 / 131072) << distance;
  }
}

// The unrounded divide with its last ADC outside the conditional assembly. 2.5 / 2 = 1.25.
TEST(Defects, AdcAfterEndif) {
  const defects::Words operands{0x28000, 0x20000};
  x86::Build scanned = defects::unrounded;
  scanned.endif_as_scanned = true;
  EXPECT_EQ(ask<div>(i8088, scanned, operands), defects::undefined_flag);
  EXPECT_EQ(ask<div>(i8088, defects::unrounded, operands), value(0x14000));
  // With rounding, both readings contain the ADC, and it adds the carry of the CMP and ADC.
  scanned.div_rounding = true;
  EXPECT_EQ(ask<div>(i8088, scanned, operands), value(0x14000));

  // On a real 8086, DIV leaves the complement of the quotient's top bit in the carry flag, so
  // quotients with a fraction below 1/2 become one too large.
  const auto on_8086 = [](std::uint32_t n, std::uint32_t d) {
    using namespace x86::notation;
    x86::Program program =
        x86::assemble(x86::listing(div, i8088),
                      {.mul_rounding = false, .div_rounding = false, .endif_as_scanned = true});
    for (std::size_t i = 0; i < program.size; ++i) {
      const bool is_adc = program.code.at(i).mnemonic == x86::Mnemonic::adc;
      const std::uint32_t low_quotient = n / (d >> 16U) & 0xFFFFU;
      if (is_adc) program.code.at(i) = add(cx, low_quotient < 0x8000 ? 1 : 0);
    }
    return ask<div>(program, {n, d});
  };
  EXPECT_EQ(on_8086(0x28000, 0x20000), value(0x24000));  // 1.25 becomes 2.25
  EXPECT_EQ(on_8086(0x30000, 0x20000), value(0x18000));  // 1.5 does not change
}

/// The caller's arguments after a divide: low and high words of the dividend, then of the divisor.
defects::Words arguments_after(x86::Target target, const defects::Words& in) {
  x86::CallMachine<div, 16> machine;
  x86::enter<div>(machine, in);
  const std::uint32_t first = machine.registers.read(x86::Register::sp, x86::Size::word) + 2;
  const x86::Program program = x86::assemble(x86::listing(div, target), defects::rounded);
  EXPECT_EQ(x86::run(program.instructions(), machine).outcome, x86::Outcome::returned);
  defects::Words words(4);
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(machine.memory.read(first + 2 * i, words[i]));
  }
  return words;
}

// -0.25 / -2.75: the low words are c000h and 4000h.
TEST(Defects, ClobberedArguments) {
  const defects::Words operands{0xFFFFC000, 0xFFFD4000};
  EXPECT_EQ(arguments_after(i8088, operands), (defects::Words{0x4000, 0xFFFF, 0xC000, 0xFFFD}));
  EXPECT_EQ(arguments_after(i386, operands), (defects::Words{0xC000, 0xFFFF, 0x4000, 0xFFFD}));
  EXPECT_EQ(arguments_after(i8088, {0x4000, 0x2C000}), (defects::Words{0x4000, 0, 0xC000, 0x0002}));
  // The type works on its own copies of the operands.
  const auto n = fixproof::q16_16_i8088::from_raw(-0x4000);
  const auto d = fixproof::q16_16_i8088::from_raw(-0x2C000);
  EXPECT_EQ((n / d).raw(), 0x2000);
  EXPECT_EQ(n.raw(), -0x4000);
  EXPECT_EQ(d.raw(), -0x2C000);
}

}  // namespace

/// Tests sine and cosine in radians against 50-digit arithmetic.
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "fixed/fixed.hpp"
#include "tests/fixed/exact.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using real = boost::multiprecision::cpp_bin_float_50;

/// The integer nearest to x in units of 2^-bits. No tie occurs; see fixed/detail/radian.hpp.
std::int32_t nearest(const real& x, int bits) {
  return floor(ldexp(x, bits) + real(0.5)).convert_to<std::int32_t>();
}

template <class Number>
void expect_nearest(Number angle) {
  constexpr int bits = Number::fraction_bits;
  const real exact = ldexp(real(angle.raw()), -bits);
  EXPECT_EQ(fixproof::sin(angle).raw(), nearest(sin(exact), bits)) << angle.raw();
  EXPECT_EQ(fixproof::cos(angle).raw(), nearest(cos(exact), bits)) << angle.raw();
}

/// Some of the angles whose sine or cosine lies within 2^-43 of a half, from an exhaustive search.
constexpr std::int32_t hard_angles[]{
    0x01faf7eb, 0x046936f4, 0x06772dbb, 0x0c54eeec, 0x0cc9a52c, 0x0cd31bf4, 0x0d518b65, 0x0db520b1,
    0x10e4c31e, 0x112256a7, 0x11776e51, 0x12a821f9, 0x138e71de, 0x13c02e71, 0x1d0d85b5, 0x24f7478a,
    0x26e5159d, 0x307d4dca, 0x378b3a20, 0x4162745d, 0x490df2e2, 0x4a5eabdf, 0x57e413ee, 0x60cf72d8,
    0x6c6b7c74, 0x6f29ca6b, 0x6ff9118d, 0x734c79ae, 0x776c1f1d, 0x7b11621d, 0x7d40e938, 0x7eb7204d};

TEST(Radian, HardAngles) {
  for (const std::int32_t raw : hard_angles) {
    expect_nearest(q16_16::from_raw(raw));
    expect_nearest(q16_16::from_raw(-raw));
  }
}

TEST(Radian, Edges) {
  for (const q16_16 angle : exact::edges<q16_16>()) expect_nearest(angle);
}

TEST(Radian, BesideMultiplesOfAQuarterTurn) {
  const double quarter = std::ldexp(std::acos(0.0), 16);
  for (int k = -20861; k <= 20861; k += 23) {
    const auto raw = static_cast<std::int32_t>(std::lround(k * quarter));
    for (const int beside : {-1, 0, 1}) expect_nearest(q16_16::from_raw(raw + beside));
  }
}

TEST(Radian, RandomAngles) {
  std::mt19937 random(8);
  for (int i = 0; i < 8'000; ++i) {
    const auto word = static_cast<std::int32_t>(random());
    expect_nearest(q16_16::from_raw(word >> (random() % 32)));
  }
}

/// Double arithmetic suffices: its error is below 2^-50, and no result comes that near to a half.
TEST(Radian, EveryAngleOf8_8) {
  const auto expected = [](double exact) {
    const double units = exact * 256;
    EXPECT_GT(std::fabs(std::fabs(units - std::floor(units)) - 0.5), 1e-9);
    return std::lround(units);
  };
  for (int raw = INT16_MIN; raw <= INT16_MAX; ++raw) {
    const q8_8 angle = q8_8::from_raw(static_cast<std::int16_t>(raw));
    ASSERT_EQ(fixproof::sin(angle).raw(), expected(std::sin(raw / 256.0))) << raw;
    ASSERT_EQ(fixproof::cos(angle).raw(), expected(std::cos(raw / 256.0))) << raw;
  }
}

TEST(Radian, OddAndEven) {
  for (std::int64_t raw = 0; raw <= INT32_MAX; raw += 40'961) {
    const q16_16 angle = q16_16::from_raw(static_cast<std::int32_t>(raw));
    ASSERT_EQ(fixproof::sin(-angle), -fixproof::sin(angle)) << raw;
    ASSERT_EQ(fixproof::cos(-angle), fixproof::cos(angle)) << raw;
  }
}

TEST(Radian, MonotoneUpToAQuarterTurnAndNoStepIsLeftOut) {
  const auto quarter = static_cast<std::int32_t>(std::ldexp(std::acos(0.0), 16));
  for (std::int32_t raw = 0; raw < quarter; ++raw) {
    const q16_16 here = q16_16::from_raw(raw);
    const q16_16 next = q16_16::from_raw(raw + 1);
    const std::int32_t up = fixproof::sin(next).raw() - fixproof::sin(here).raw();
    const std::int32_t down = fixproof::cos(here).raw() - fixproof::cos(next).raw();
    ASSERT_TRUE(up == 0 || up == 1) << raw;
    ASSERT_TRUE(down == 0 || down == 1) << raw;
  }
}

template <class Number>
void expect_as_q16_16() {
  for (const q16_16 angle : exact::edges<q16_16>()) {
    const Number same = Number::from_raw(angle.raw());
    ASSERT_EQ(fixproof::sin(same).raw(), fixproof::sin(angle).raw());
    ASSERT_EQ(fixproof::cos(same).raw(), fixproof::cos(angle).raw());
    const sin_and_cos<Number> both = fixproof::sin_cos(same);
    ASSERT_EQ(both, (sin_and_cos<Number>{fixproof::sin(same), fixproof::cos(same)}));
  }
}

TEST(Radian, TheSameUnderEveryPolicy) {
  expect_as_q16_16<q16_16>();
  expect_as_q16_16<q16_16_saturating>();
  expect_as_q16_16<q16_16_trapping>();
  expect_as_q16_16<q16_16_i386_unrounded>();
  expect_as_q16_16<q16_16_i8088_unrounded>();
}

// The examples of fixed/sine.hpp and other known values.
static_assert(noexcept(sin(q16_16_trapping())) && noexcept(sin_cos(q8_8())));
static_assert(sin(q16_16(1)) == q16_16(0.84147098480789650665));
static_assert(sin(q16_16(-32768)).raw() == -60808);  // -60807.99
static_assert(cos(q16_16()) == q16_16(1) && cos(q16_16(-2)) == cos(q16_16(2)));
static_assert(sin(q16_16()) == q16_16());
static_assert(sin(q8_8(1)).raw() == 215);  // 215.42
// An integer argument is in tenths of a degree and needs the type; a number is in radians.
static_assert(sin_of_tenths<q16_16>(900) == q16_16(1) &&
              sin(q16_16(900)).raw() == 65392);  // 65392.04

}  // namespace

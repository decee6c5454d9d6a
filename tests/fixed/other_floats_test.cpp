/// Conversions from long double and the types of 16 bits, against those from double and powers of
/// two that only a long double has.
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"

namespace fixproof {
namespace {

using long_even =
    number<std::int64_t, 63, policy{.multiply = rounding::half_even, .range = overflow::saturate}>;
using long_floor = with_policy<q16_16, policy{.multiply = rounding::floor}>;
using long_limits = std::numeric_limits<long double>;

static_assert(q16_16(1.5L).raw() == 0x18000 && q16_16(-1.5L).raw() == -0x18000);
static_assert(q32_32(0.1L).raw() == 429496730);  // 429496729.6
static_assert(q16_16(long_limits::quiet_NaN()) == 0 &&
              q16_16(long_limits::infinity()).raw() == 0x7fffffff);
static_assert(q16_16(-long_limits::infinity()) == -32768 && q16_16(long_limits::max()) == 0);
static_assert(u0_64(long_limits::infinity()).raw() == ~std::uint64_t{0});
static_assert(q16_16_saturating(-long_limits::max()) == -32768 &&
              q16_16(long_limits::denorm_min()) == 0);
static_assert(long_floor(-long_limits::denorm_min()).raw() == -1 && long_floor(-0.0L).raw() == 0);
static_assert(static_cast<long double>(q16_16(-1.25)) == -1.25L);
static_assert(static_cast<long double>(q1_63(-1)) == -1 &&
              static_cast<long double>(u0_64(0.5)) == 0.5L);

/// What a double cannot have: 64 digits. Where a long double is a double, they are rounded.
TEST(OtherFloats, KeepTheDigitsOfALongDouble) {
  if (long_limits::digits < 64) GTEST_SKIP() << "a long double has the digits of a double";
  const auto unit = std::numeric_limits<long double>::epsilon();
  EXPECT_EQ(long_even(0.5L + 0x1p-63L).raw(), 0x4000000000000001);
  EXPECT_EQ(long_even(-0.5L - 0x1p-63L).raw(), -0x4000000000000001);
  EXPECT_EQ(q2_30(1 + 0x1p-31L - unit).raw(), 0x40000000);
  EXPECT_EQ(q2_30(1 + 0x1p-31L).raw(), 0x40000001);  // a tie goes up
  EXPECT_EQ(q2_30(-1 - 0x1p-31L).raw(), -0x40000000);
  EXPECT_EQ(q2_30(-1 - 0x1p-31L - unit).raw(), -0x40000001);
  const number<std::int64_t, 0> odd(0x7fffffffffffffffL);
  EXPECT_EQ(odd.raw(), 0x7fffffffffffffff);
  EXPECT_EQ(static_cast<long double>(odd), 0x7fffffffffffffffp0L);
  EXPECT_EQ(static_cast<long double>(u0_64::from_raw(~std::uint64_t{0})), 0xffffffffffffffffp-64L);
}

template <class Number>
void expect_equal_to_double(double x) {
  ASSERT_EQ(Number(static_cast<long double>(x)), Number(x)) << x;
  ASSERT_EQ(static_cast<long double>(Number(x)),
            static_cast<long double>(static_cast<double>(Number(x))))
      << x;
}

TEST(OtherFloats, EveryDoubleConvertsAsItself) {
  std::mt19937_64 random(1994);
  for (int i = 0; i < 200'000; ++i) {
    std::uint64_t bits = random();
    // Half of them near the ranges.
    if (i % 2 != 0) bits = (bits & 0x800fffffffffffff) | (983 + (bits >> 52) % 120) << 52;
    double x = 0;
    std::memcpy(&x, &bits, sizeof(x));
    expect_equal_to_double<q16_16>(x);
    expect_equal_to_double<q16_16_saturating>(x);
    expect_equal_to_double<q8_8_i386_unrounded>(x);
    expect_equal_to_double<with_policy<u8_8, policy{.multiply = rounding::truncate}>>(x);
    ASSERT_EQ(long_even(static_cast<long double>(x)), long_even(x)) << x;
    ASSERT_EQ(q32_32(static_cast<long double>(x)), q32_32(x)) << x;
  }
}

#if defined(FIXED_HAS_FLOAT16)
TEST(OtherFloats, EveryHalfConvertsAsADouble) {
  __extension__ using half = _Float16;
  for (std::uint32_t i = 0; i <= 0xffff; ++i) {
    const auto bits = static_cast<std::uint16_t>(i);
    half x{};
    std::memcpy(&x, &bits, sizeof(x));
    ASSERT_EQ(q8_24(x), q8_24(static_cast<double>(x))) << i;
    ASSERT_EQ(long_floor(x), long_floor(static_cast<double>(x))) << i;
  }
}
#endif

TEST(OtherFloats, AnErrorNamesTheOperand) {
  try {
    (void)q16_16_trapping(40000.5L);
    FAIL();
  } catch (const overflow_error& error) {
    EXPECT_STREQ(error.what(), "fixed-point overflow: conversion(40000.5)");
  }
  EXPECT_THROW((void)q16_16_trapping(long_limits::quiet_NaN()), domain_error);
}

}  // namespace
}  // namespace fixproof

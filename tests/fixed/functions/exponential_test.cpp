/// Tests the limits of exponentials and logarithms, and the error bounds of their parts.
#include "fixed/exponential.hpp"

#include "fixed/fixed.hpp"
#include "fixed/literals.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;

TEST(Exponentials, TiesFollowThePolicy) {
  using even = number<std::int16_t, 8, policy{.multiply = rounding::half_even}>;
  using down = number<std::int16_t, 8, policy{.multiply = rounding::floor}>;
  EXPECT_EQ(exp2(q8_8(-9)).raw(), 1);
  EXPECT_EQ(exp2(even(-9)).raw(), 0);
  EXPECT_EQ(exp2(down(-9)).raw(), 1);
  EXPECT_EQ(exp2(even::from_raw(-9 * 256 + 1)).raw(), 1);
}

TEST(Exponentials, RangeAndDomainFollowThePolicy) {
  EXPECT_EQ(exp(q16_16(11)), std::numeric_limits<q16_16>::max());
  EXPECT_EQ(exp(q16_16(-32768)), q16_16());
  EXPECT_EQ(exp2(q1_31()), std::numeric_limits<q1_31>::max());
  EXPECT_EQ(log(q16_16()), std::numeric_limits<q16_16>::lowest());
  EXPECT_EQ(log2(q16_16(-1)), std::numeric_limits<q16_16>::lowest());
  EXPECT_EQ(log(u16_16::from_raw(1)), u16_16());
  EXPECT_EQ(log2(q2_30::from_raw(1)), std::numeric_limits<q2_30>::lowest());
  EXPECT_EQ(expm1(q16_16(-32768)), q16_16(-1));
  EXPECT_EQ(log1p(q16_16(-1)), std::numeric_limits<q16_16>::lowest());
  EXPECT_EQ(sinh(q16_16(-32768)), std::numeric_limits<q16_16>::lowest());
  EXPECT_EQ(cosh(q16_16(-32768)), std::numeric_limits<q16_16>::max());
  EXPECT_EQ(tanh(q16_16(-32768)), q16_16(-1));
  EXPECT_THROW((void)exp(q16_16_trapping(11)), overflow_error);
  EXPECT_THROW((void)log1p(q16_16_trapping(-1)), domain_error);
  EXPECT_THROW((void)sinh(q16_16_trapping(12)), overflow_error);
  EXPECT_THROW((void)log10(q16_16_trapping()), domain_error);
  EXPECT_THROW((void)log(number<std::uint32_t, 16, policies::trapping>::from_raw(1)),
               overflow_error);
}

TEST(Exponentials, PowersHaveTheirError) {
  std::mt19937_64 random(1994);
  for (int i = 0; i < 20'000; ++i) {
    std::uint64_t x = random();
    // Next to the places where the table steps, too.
    if (i % 4 == 0) x = (x & ~std::uint64_t{0} << 59) + x % 16;
    if (i % 4 == 1) x = (x | ~std::uint64_t{0} >> 5) - x % 16;
    const detail::real precise = detail::precise_power(detail::real{x} << (detail::real_bits - 64));
    const auto exact = static_cast<std::uint64_t>(precise >> (detail::real_bits - 63));
    const std::uint64_t below = exact - detail::power_of_two<detail::power_terms>(x);
    ASSERT_LE(below, 15U) << x;
    ASSERT_LE(exact - detail::power_of_two<detail::quick_power_terms>(x), 4194304U) << x;
  }
}

TEST(Exponentials, LogarithmsHaveTheirError) {
  std::mt19937_64 random(1994);
  for (int i = 0; i < 20'000; ++i) {
    std::uint64_t m = random() >> 31 | std::uint64_t{1} << 32;
    if (i % 4 == 0) m = (m & 0x1fc000000) + m % 16;
    if (i % 4 == 1) m = (m | 0x3ffffff) - m % 16;
    const detail::real precise = detail::precise_logarithm(m);
    const auto exact = static_cast<std::uint64_t>(precise >> (detail::real_bits - 64));
    const auto off = [&](std::uint64_t logarithm) {
      return std::abs(static_cast<std::int64_t>(logarithm - exact));
    };
    ASSERT_LE(off(detail::binary_logarithm<detail::logarithm_terms>(m)), 5) << m;
    ASSERT_LE(off(detail::binary_logarithm<4>(m)), detail::logarithm_error<4>) << m;
    ASSERT_LE(off(detail::binary_logarithm<6>(m)), detail::logarithm_error<6>) << m;
  }
}

TEST(Exponentials, AreConstantExpressions) {
  using namespace literals;
  static_assert(tanh(q16_16()) == 0 && sinh(q16_16()) == 0 && cosh(q16_16()) == 1);
  static_assert(expm1(q16_16()) == 0 && log1p(q16_16()) == 0 && exp2(q16_16()) == 1);
  static_assert(exp(1_q8_24).raw() == 45605201);     // 45605201.4
  static_assert(log(1.5_q2_30).raw() == 435364845);  // 435364844.7
  static_assert(log10(u16_16(1000)) == 3 && log2(q24_8(1 << 20)) == 20);
}

}  // namespace

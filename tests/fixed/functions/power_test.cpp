/// Tests the limits of powers, roots, reciprocals and lengths.
#include "fixed/power.hpp"

#include <array>

#include "fixed/fixed.hpp"
#include "oracle/format.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using oracle::Integer;

TEST(Powers, TiesFollowThePolicy) {
  using even = number<std::int32_t, 8, policy{.multiply = rounding::half_even}>;
  using away = number<std::int32_t, 8, policy{.multiply = rounding::half_away}>;
  // 2^-9 is half a unit.
  EXPECT_EQ(rsqrt(q24_8(1 << 18)).raw(), 1);
  EXPECT_EQ(rsqrt(even(1 << 18)).raw(), 0);
  EXPECT_EQ(reciprocal(q24_8(512)).raw(), 1);
  EXPECT_EQ(reciprocal(q24_8(-512)).raw(), 0);
  EXPECT_EQ(reciprocal(away(-512)).raw(), -1);
  EXPECT_EQ(reciprocal(even(512)).raw(), 0);
  EXPECT_EQ(reciprocal(even(-512)).raw(), 0);
  // 3^3 / 2^9 is 13.5 units.
  EXPECT_EQ(pow(q24_8(0.375), q24_8(3)).raw(), 14);
  EXPECT_EQ(pow(q24_8(-0.375), q24_8(3)).raw(), -13);
  EXPECT_EQ(pow(away(-0.375), away(3)).raw(), -14);
  EXPECT_EQ(pow(even(-0.375), even(3)).raw(), -14);
}

TEST(Powers, RangeAndDomainFollowThePolicy) {
  using trapping = q16_16_trapping;
  EXPECT_EQ(pow(q16_16(), q16_16()), 1);
  EXPECT_EQ(pow(q16_16(), q16_16(3)), 0);
  EXPECT_EQ(pow(q16_16(), q16_16(-3)), std::numeric_limits<q16_16>::max());
  EXPECT_EQ(pow(q16_16(-2), q16_16(0.5)), 0);
  EXPECT_EQ(pow(q16_16(-2), q16_16(15)), -32768);
  EXPECT_EQ(pow(q16_16(-3), q16_16(15)), std::numeric_limits<q16_16>::lowest());
  EXPECT_EQ(pow(q16_16(-1), q16_16(-32768)), 1);
  EXPECT_EQ(pow(std::numeric_limits<q32_0>::lowest(), q32_0(1)),
            std::numeric_limits<q32_0>::lowest());
  EXPECT_EQ(rsqrt(q16_16()), std::numeric_limits<q16_16>::max());
  EXPECT_EQ(reciprocal(q16_16()), std::numeric_limits<q16_16>::max());
  EXPECT_EQ(hypot(std::numeric_limits<q16_16>::lowest(), q16_16()),
            std::numeric_limits<q16_16>::max());
  EXPECT_THROW((void)pow(trapping(-2), trapping(0.5)), domain_error);
  EXPECT_THROW((void)pow(trapping(), trapping(-1)), domain_error);
  EXPECT_THROW((void)pow(trapping(2), trapping(15)), overflow_error);
  EXPECT_THROW((void)rsqrt(trapping()), domain_error);
  EXPECT_THROW((void)reciprocal(trapping()), domain_error);
  EXPECT_THROW((void)hypot(trapping(30000), trapping(30000)), overflow_error);
}

TEST(Powers, OfMagnitudesWhoseNegativesRoundHalfUp) {
  // 15.625 and 13.5 ulps: only the tie goes down.
  EXPECT_EQ(detail::rational_power<rounding::floor>(10, 24, 3).ulps, 16);
  EXPECT_EQ(detail::rational_power<rounding::floor>(96, 768, 8).ulps, 13);
}

/// Reciprocals of roots in constant expressions, which take integers in place of doubles.
template <class N>
constexpr auto constant_roots = [] {
  std::array<std::int64_t, 31> roots{};
  for (std::size_t i = 0; i < roots.size(); ++i) {
    roots[i] = rsqrt(N::from_raw((std::int32_t{1} << i) + 1)).raw();
  }
  return roots;
}();

template <class N>
void expect_constant_roots_are_nearest() {
  for (std::size_t i = 0; i < constant_roots<N>.size(); ++i) {
    const Integer root = constant_roots<N>[i];
    if (root == std::numeric_limits<std::int32_t>::max()) continue;
    const Integer raw = (Integer(1) << i) + 1;
    const Integer exact = Integer(4) << (3 * N::fraction_bits);
    const Integer below = root > 0 ? Integer(2 * root - 1) : Integer(0);
    EXPECT_LE(below * below * raw, exact) << raw;
    EXPECT_LT(exact, (2 * root + 1) * (2 * root + 1) * raw) << raw;
  }
}

TEST(Powers, ConstantReciprocalsOfRootsAreNearest) {
  expect_constant_roots_are_nearest<q16_16>();
  // From 22 fraction bits on, the integers are wider.
  expect_constant_roots_are_nearest<number<std::int32_t, 21>>();
  expect_constant_roots_are_nearest<number<std::int32_t, 22>>();
}

template <class N>
class PowerLengths : public testing::Test {};
using LengthFormats = testing::Types<q8_0, q8_8, u0_16, q1_31, u32_32, q16_16, u0_32, q32_32, q1_63,
                                     u0_64, number<std::int16_t, 16>, number<std::int32_t, 32>>;
TYPED_TEST_SUITE(PowerLengths, LengthFormats);

TYPED_TEST(PowerLengths, AndReciprocalsOfEveryWidthAreNearest) {
  using N = TypeParam;
  using raw = typename N::raw_type;
  std::mt19937_64 random(1994);
  const Integer lowest = std::numeric_limits<raw>::min();
  const Integer highest = std::numeric_limits<raw>::max();
  const auto limited = [&](const Integer& x) {
    return x < lowest ? lowest : x > highest ? highest : x;
  };
  for (int i = 0; i < 300; ++i) {
    const auto word = [&]() -> raw {
      if (i == 0) return std::numeric_limits<raw>::min();
      if (i == 1) return std::numeric_limits<raw>::max();
      return static_cast<raw>(random() >> random() % 60);
    };
    const raw x = word();
    const raw y = word();
    const raw z = word();
    const auto integer = [](raw value) { return Integer(value); };
    const Integer squares = integer(x) * x + integer(y) * y;
    const auto root = [](const Integer& n) {
      const Integer below = sqrt(n);
      return Integer(n - below * below > below ? below + 1 : below);
    };
    const N a = N::from_raw(x);
    const N b = N::from_raw(y);
    ASSERT_EQ(integer(hypot(a, b).raw()), limited(root(squares)));
    ASSERT_EQ(integer(hypot(a, b, N::from_raw(z)).raw()), limited(root(squares + integer(z) * z)));
    if (x == 0) continue;
    const Integer one = Integer(1) << (2 * N::fraction_bits);
    ASSERT_EQ(integer(reciprocal(a).raw()),
              limited(oracle::rounded(one, x, oracle::Rounding::half_up)));
  }
}

}  // namespace

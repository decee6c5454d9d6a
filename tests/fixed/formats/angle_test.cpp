/// Tests the limits of angles, their hardest pair, and the error bounds of their parts.
#include "fixed/angle.hpp"

#include "fixed/constants.hpp"
#include "fixed/fixed.hpp"
#include "oracle/function.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;

void expect_nearest(q16_16 y, q16_16 x) {
  const auto want =
      oracle::nearest(oracle::Function::atan2, y.raw(), x.raw(), 16, oracle::Rounding::half_up);
  ASSERT_EQ(atan2(y, x).raw(), static_cast<std::int32_t>(want.value()))
      << y.raw() << ' ' << x.raw();
}

// Of all pairs of 16.16 this one has the angle nearest to a tie, 2^-60.2 ulps from it: the fraction
// of words nearest to the tangent of a midpoint between two results.
TEST(Angles, TheHardestPair) {
  for (const int y_sign : {-1, 1}) {
    for (const int x_sign : {-1, 1}) {
      expect_nearest(q16_16::from_raw(y_sign * 460672751), q16_16::from_raw(x_sign * 935870233));
      expect_nearest(q16_16::from_raw(y_sign * 935870233), q16_16::from_raw(x_sign * 460672751));
    }
  }
}

TEST(Angles, RangeFollowsThePolicy) {
  using trapping = number<std::int32_t, 30, policies::trapping>;
  EXPECT_EQ(atan2(q2_30(1), q2_30(-1)), std::numeric_limits<q2_30>::max());
  EXPECT_EQ(atan2(q2_30(-1), q2_30(-1)), std::numeric_limits<q2_30>::lowest());
  EXPECT_THROW((void)atan2(trapping(1), trapping(-1)), overflow_error);
  EXPECT_THROW((void)acos(q16_16_trapping::from_raw(65537)), domain_error);
  EXPECT_EQ(asin(q16_16::from_raw(65537)), q16_16());
  EXPECT_EQ(acos(q2_30(-1)), std::numeric_limits<q2_30>::max());
  EXPECT_EQ(atan2(q16_16(), q16_16()), q16_16());
  EXPECT_EQ(atan2(q16_16(), q16_16(-1)), pi_v<q16_16>);
  EXPECT_EQ(atan(std::numeric_limits<q16_16>::max()).raw(), half_pi_v<q16_16>.raw() - 2);
}

TEST(Angles, PartsHaveTheirError) {
  std::mt19937_64 random(1994);
  for (int i = 0; i < 5000; ++i) {
    // Up to 2^57, of which those below 2^32 are divided in two steps.
    const std::uint64_t d = (random() >> (7 + random() % 45)) + 1;
    std::uint64_t n = random() % (d + 1);
    if (i % 3 == 0) n = d / 64 * (random() % 65);
    const auto exact = static_cast<std::int64_t>(
        detail::precise_arctangent(detail::ratio(detail::real{n}, detail::real{d})) >>
        (detail::real_bits - 58));
    ASSERT_LE(std::abs(detail::arctangent(n, d) - exact), 6) << n << ' ' << d;
  }
}

}  // namespace

/// Tests angles of vectors against the oracle, and the error bounds of their parts.
#include "fixed/arctangent.hpp"

#include "fixed/constants.hpp"
#include "fixed/fixed.hpp"
#include "oracle/angle.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using oracle::Integer;

/// The oracle's angle as the word of a type that saturates.
template <class N>
N expected(const Integer& y, const Integer& x) {
  using raw = typename N::raw_type;
  constexpr raw lowest = std::numeric_limits<raw>::min();
  constexpr raw highest = std::numeric_limits<raw>::max();
  const Integer ulps = oracle::nearest_angle(y, x, N::fraction_bits);
  if (ulps < lowest) return N::from_raw(lowest);
  return N::from_raw(ulps > highest ? highest : static_cast<raw>(ulps));
}

template <class N>
void expect_nearest(N y, N x) {
  ASSERT_EQ(atan2(y, x), (expected<N>(y.raw(), x.raw()))) << +y.raw() << ' ' << +x.raw();
  const Integer one = Integer(1) << N::fraction_bits;
  ASSERT_EQ(atan(y), (expected<N>(y.raw(), one))) << +y.raw();
}

template <class N>
class Angles : public testing::Test {};
using Formats = testing::Types<q8_0, q1_7, u4_4, q8_8, u8_8, u0_16, q32_0, q24_8, q16_16, q8_24,
                               q2_30, q1_31, u24_8, u16_16, u1_31, u0_32>;
TYPED_TEST_SUITE(Angles, Formats);

TYPED_TEST(Angles, AreNearest) {
  using raw = typename TypeParam::raw_type;
  std::mt19937_64 random(1994);
  // Words of every length.
  const auto word = [&] {
    const auto bits = static_cast<std::int64_t>(random());
    return static_cast<raw>(bits >> (32 + random() % 32));
  };
  for (int i = 0; i < 1000; ++i) {
    const raw y = word();
    raw x = word();
    // Next to a diagonal, and to the places where the table steps.
    if (i % 4 == 0) x = static_cast<raw>(y + static_cast<raw>(random() % 3));
    if (i % 4 == 1) {
      x = static_cast<raw>(std::int64_t{y} * 64 / static_cast<std::int64_t>(random() % 64 + 1));
    }
    expect_nearest(TypeParam::from_raw(y), TypeParam::from_raw(x));
  }
  constexpr std::array edges{std::numeric_limits<raw>::min(), raw{0}, raw{1},
                             std::numeric_limits<raw>::max(), static_cast<raw>(-1)};
  for (const raw y : edges) {
    for (const raw x : edges) expect_nearest(TypeParam::from_raw(y), TypeParam::from_raw(x));
  }
}

TEST(Angles, EveryPairOfBytes) {
  for (int y = -128; y < 128; y += 3) {
    for (int x = -128; x < 128; ++x) {
      expect_nearest(q4_4::from_raw(static_cast<std::int8_t>(y)),
                     q4_4::from_raw(static_cast<std::int8_t>(x)));
    }
  }
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
  EXPECT_EQ(atan2(q16_16(), q16_16()), q16_16());
  EXPECT_EQ(atan2(q16_16(), q16_16(-1)), pi_v<q16_16>);
  EXPECT_EQ(atan(std::numeric_limits<q16_16>::max()).raw(), half_pi_v<q16_16>.raw() - 2);
}

TEST(Angles, PartsHaveTheirError) {
  std::mt19937_64 random(1994);
  for (int i = 0; i < 5000; ++i) {
    const std::uint64_t d = (random() >> (32 + random() % 20)) + 1;
    std::uint64_t n = random() % (d + 1);
    if (i % 3 == 0) n = d * (random() % 65) / 64;
    const auto exact =
        static_cast<std::int64_t>(detail::precise_arctangent(n, d) >> (detail::real_bits - 58));
    ASSERT_LE(std::abs(detail::arctangent(n, d) - exact), 6) << n << ' ' << d;
  }
}

TEST(Angles, PreciseOnesAreNearest) {
  for (std::uint64_t d = 1; d < 60; ++d) {
    for (std::uint64_t n = 0; n <= d; ++n) {
      const detail::real precise = detail::precise_arctangent(n, d) + (detail::real_one >> 31);
      EXPECT_EQ(static_cast<std::int64_t>(precise >> (detail::real_bits - 30)),
                static_cast<std::int64_t>(oracle::nearest_angle(n, d, 30)))
          << n << ' ' << d;
    }
  }
}

}  // namespace

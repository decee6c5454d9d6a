/// Tests the limits of sines and tangents, and the error bounds of their parts.
#include "fixed/constants.hpp"
#include "fixed/fixed.hpp"
#include "fixed/trigonometry.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using detail::angle_unit;

template <angle_unit Unit>
void expect_parts_have_their_error() {
  std::mt19937_64 random(1994);
  for (int i = 0; i < 5000; ++i) {
    const auto raw = static_cast<std::int64_t>(random()) >> (32 + i % 30);
    const int bits = static_cast<int>(random() % 33);
    const std::uint64_t phase = detail::phase_of<Unit>(raw, bits);
    const auto precise = detail::precise_phase_of<Unit>(raw, bits);
    // A quarter turn is 2^62 units.
    const detail::real quarter = product(precise.rest, detail::real_from(detail::real_2_over_pi)) >>
                                 (detail::real_bits - 62);
    const std::uint64_t exact =
        (std::uint64_t{precise.quarters} << 62) + static_cast<std::uint64_t>(quarter);
    const auto off = static_cast<std::int64_t>(phase - exact);
    ASSERT_LE(std::abs(off), 1) << raw << " with " << bits;

    const auto both = detail::precise_sine_of(precise.rest);
    const detail::real sine = precise.quarters % 2 == 0 ? both.sine : both.cosine;
    const auto exact_sine = static_cast<std::int64_t>(sine >> (detail::real_bits - 62));
    ASSERT_LT(std::abs(detail::sine_of_phase(phase) - exact_sine), 64) << raw << " with " << bits;

    // The tangent n / d crosswise: n / d = N / D if n D = N d. Each is at most 1, off by 8 units.
    const auto tangent = detail::tangent_of_phase(phase);
    const bool is_reciprocal = (precise.quarters % 2 != 0) != tangent.is_steep;
    const detail::real n = detail::real{tangent.n} << (detail::real_bits - 62);
    const detail::real d = detail::real{tangent.d} << (detail::real_bits - 62);
    const detail::real difference = product(n, is_reciprocal ? both.sine : both.cosine) -
                                    product(d, is_reciprocal ? both.cosine : both.sine);
    const auto units = static_cast<std::int64_t>(difference >> (detail::real_bits - 62));
    ASSERT_LE(std::abs(units), 16) << raw << " with " << bits;
  }
}

TEST(Phases, PartsHaveTheirError) {
  expect_parts_have_their_error<angle_unit::radian>();
  expect_parts_have_their_error<angle_unit::degree>();
  expect_parts_have_their_error<angle_unit::turn>();
}

TEST(Phases, TiesFollowThePolicy) {
  using even = number<std::int32_t, 0, policy{.multiply = rounding::half_even}>;
  using away = number<std::int32_t, 0, policy{.multiply = rounding::half_away}>;
  EXPECT_EQ(sin_of_degrees(q32_0(30)), 1);
  EXPECT_EQ(sin_of_degrees(q32_0(-30)), 0);
  EXPECT_EQ(cos_of_degrees(q32_0(120)), 0);
  EXPECT_EQ(sin_of_degrees(even(30)), 0);
  EXPECT_EQ(sin_of_degrees(away(-30)), -1);
}

static_assert(sin_cos(q2_30(0.5)).sin.raw() == 514779252);  // 514779252.3
static_assert(sin_cos(q2_30(0.5)).cos.raw() == 942297101);  // 942297100.7

TEST(Phases, SineAndCosineTogether) {
  const auto radians = sin_cos(q8_24(2));
  EXPECT_EQ(radians.cos.raw(), -6981785);  // -6981785.4
  EXPECT_EQ(radians.sin.raw(), 15255479);  // 15255479.3
  const auto degrees = sin_cos_of_degrees(q16_16(150));
  EXPECT_EQ(degrees.cos.raw(), -56756);  // -56755.8
  EXPECT_EQ(degrees.sin, q16_16(0.5));
  const auto turns = sin_cos_of_turns(q16_16(-0.25));
  EXPECT_EQ(turns.cos, 0);
  EXPECT_EQ(turns.sin, -1);
  // A cosine of 1 is out of range.
  EXPECT_EQ(sin_cos(q1_31()).cos, std::numeric_limits<q1_31>::max());
  EXPECT_THROW((void)sin_cos_of_turns(number<std::int32_t, 31, policies::trapping>()),
               overflow_error);
}

TEST(Phases, RangeAndDomainFollowThePolicy) {
  EXPECT_EQ(tan_of_degrees(q16_16(90)), std::numeric_limits<q16_16>::max());
  EXPECT_EQ(tan_of_turns(q16_16(-0.25)), std::numeric_limits<q16_16>::max());
  EXPECT_EQ(tan_of_degrees(q16_16::from_raw(90 * 65536 + 1)).raw(),
            std::numeric_limits<std::int32_t>::min());
  EXPECT_EQ(sin_of_degrees(u16_16(270)), 0);
  EXPECT_EQ(sin(q1_31(0.75)).raw(), 1463808091);  // 1463808090.6
  EXPECT_THROW((void)tan_of_degrees(q16_16_trapping(90)), domain_error);
  EXPECT_THROW((void)tan_of_degrees(q16_16_trapping::from_raw(90 * 65536 + 1)), overflow_error);
  EXPECT_THROW((void)sin_of_degrees(number<std::uint32_t, 16, policies::trapping>(270)),
               overflow_error);
}

}  // namespace

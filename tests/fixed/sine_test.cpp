/// Tests sine and cosine against 50-digit arithmetic, and the angle reduction of CosSin.
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>

#include "fixed/detail/cosine_table.hpp"
#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using decimal_real = boost::multiprecision::cpp_dec_float_50;

/// cos(step / steps of a right angle), rounded to nearest in units of 2^-bits.
std::int32_t nearest_cosine(int step, int steps, int bits) {
  const decimal_real angle = boost::math::constants::half_pi<decimal_real>() * step / steps;
  return floor(ldexp(cos(angle), bits) + decimal_real(0.5)).convert_to<std::int32_t>();
}

template <int Bits, int StepsPerDegree>
void expect_table() {
  constexpr const auto& table = detail::cosine_table<Bits, StepsPerDegree>;
  constexpr int steps = 90 * StepsPerDegree;
  static_assert(table.size() == steps + 1);
  for (int i = 0; i <= steps; ++i) {
    ASSERT_EQ(table[static_cast<std::size_t>(i)], nearest_cosine(i, steps, Bits)) << i;
  }
}

TEST(Trig, TablesAreNearest) {
  expect_table<16, 10>();
  expect_table<8, 10>();
  expect_table<16, 1>();
  expect_table<16, 7>();
  expect_table<24, 10>();
  expect_table<30, 10>();
}

/// Reduces angles to 0 to 3600 in repeated full turns, then checks each quadrant against the table.
template <class Number>
void expect_every_angle() {
  constexpr const auto& table = detail::cosine_table<Number::fraction_bits, 10>;
  const auto entry = [](int i) { return table[static_cast<std::size_t>(i)]; };
  for (int angle = std::numeric_limits<std::int16_t>::min();
       angle <= std::numeric_limits<std::int16_t>::max(); ++angle) {
    int a = angle;
    while (a < 0) a += 3600;
    while (a > 3600) a -= 3600;
    const int cos = a <= 900    ? entry(a)
                    : a <= 1800 ? -entry(1800 - a)
                    : a <= 2700 ? -entry(a - 1800)
                                : entry(3600 - a);
    const int sin = a <= 900    ? entry(900 - a)
                    : a <= 1800 ? entry(a - 900)
                    : a <= 2700 ? -entry(2700 - a)
                                : -entry(a - 2700);
    const auto result = sin_cos_of_tenths<Number>(static_cast<std::int16_t>(angle));
    ASSERT_EQ(result.cos.raw(), cos) << angle;
    ASSERT_EQ(result.sin.raw(), sin) << angle;
    ASSERT_EQ(fixproof::cos_of_tenths<Number>(static_cast<std::int16_t>(angle)), result.cos);
    ASSERT_EQ(fixproof::sin_of_tenths<Number>(static_cast<std::int16_t>(angle)), result.sin);
  }
}

TEST(Trig, EveryAngle) {
  expect_every_angle<q16_16>();
  expect_every_angle<q16_16_i8088>();
  expect_every_angle<q8_8>();
}

TEST(Trig, WholeTurnsDoNotCountInAnyType) {
  const auto tenth = sin_cos_of_tenths<q16_16>(300);
  const auto [sine, cosine] = tenth;
  EXPECT_EQ(sine, q16_16(0.5));
  EXPECT_EQ(cosine, tenth.cos);
  EXPECT_EQ(sin_cos_of_tenths<q16_16>(36300), tenth);
  EXPECT_EQ(sin_cos_of_tenths<q16_16>(36300U), tenth);
  EXPECT_EQ(sin_cos_of_tenths<q16_16>(3'600'000'000'000'300), tenth);
  EXPECT_EQ(sin_cos_of_tenths<q16_16>(std::int8_t{100}), sin_cos_of_tenths<q16_16>(100));
  // These are -2^63 and 2^64 - 1 modulo 3600.
  EXPECT_EQ(sin_cos_of_tenths<q16_16>(std::numeric_limits<std::int64_t>::min()),
            sin_cos_of_tenths<q16_16>(1792));
  EXPECT_EQ(sin_cos_of_tenths<q16_16>(std::numeric_limits<std::uint64_t>::max()),
            sin_cos_of_tenths<q16_16>(15));
}

TEST(Trig, KnownAngles) {
  const auto expect = [](int angle, std::int32_t cos, std::int32_t sin) {
    const auto result = sin_cos_of_tenths<q16_16>(static_cast<std::int16_t>(angle));
    EXPECT_EQ(result.cos.raw(), cos) << angle;
    EXPECT_EQ(result.sin.raw(), sin) << angle;
  };
  expect(0, 0x10000, 0);
  expect(900, 0, 0x10000);
  expect(1800, -0x10000, 0);
  expect(2700, 0, -0x10000);
  expect(3600, 0x10000, 0);
  expect(-900, 0, -0x10000);
  expect(600, 0x8000, 56756);  // sqrt(3) / 2 * 65536 = 56755.84
  expect(300, 56756, 0x8000);
  expect(1350, -46341, 46341);    // sqrt(2) / 2 * 65536 = 46340.95
  expect(-32768, 52477, -39258);  // equals 323.2 degrees
}

}  // namespace

/// Tests the conversion of constants to numbers and of numbers to pixels.
#include "xsharp/arithmetic.hpp"

#include "tests/support/test.hpp"
#include "tests/xsharp/pipeline/draws.hpp"
#include "tests/xsharp/pipeline/types.hpp"

namespace xsharp {
namespace {

constexpr std::int32_t least_raw = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t max_raw = std::numeric_limits<std::int32_t>::max();

/// Floor division; the built-in division truncates.
std::int64_t floor_of(std::int64_t n, std::int64_t d) { return n / d - (n % d < 0 ? 1 : 0); }

TEST(RawConstant, PublishedAddsAHalfAndDropsTheFraction) {
  // (long)(x * 65536.0 + 0.5), by hand: -65536 + 0.5 = -65535.5; 32768.5; -20971520 + 0.5.
  EXPECT_EQ(raw_constant(-1.0, Conversion::published), -65535);
  EXPECT_EQ(raw_constant(0.5, Conversion::published), 32768);
  EXPECT_EQ(raw_constant(-320.0, Conversion::published), -20971519);
  EXPECT_EQ(raw_constant(-1.0, Conversion::nearest), -65536);
  EXPECT_EQ(raw_constant(-320.0, Conversion::nearest), -20971520);
}

TEST(RawConstant, IsTheRationalRuleForEveryNumberOfEighthsOfAUnit) {
  EXPECT_TRUE(draws::hold(1, std::int64_t{least_raw} * 8 + 8, std::int64_t{max_raw} * 8 - 8,
                          [](const draws::Integers& eighths) {
                            const std::int64_t n = eighths[0];
                            const double value = std::ldexp(static_cast<double>(n), -19);
                            return raw_constant(value, Conversion::published) == (n + 4) / 8 &&
                                   raw_constant(value, Conversion::nearest) == floor_of(n + 4, 8);
                          }));
}

TEST(RawConstant, PublishedIsUpToOneAndAHalfUnitsTooHigh) {
  // -1.4 ulp + 0.5 = -0.9 ulp, which truncates to 0.
  EXPECT_EQ(raw_constant(std::ldexp(-1.4, -16), Conversion::published), 0);
  EXPECT_EQ(raw_constant(std::ldexp(-1.6, -16), Conversion::published), -1);
  EXPECT_EQ(raw_constant(std::ldexp(-1.4, -16), Conversion::nearest), -1);
}

TEST(RawConstant, WhatIsOutOfRangeIsTheEndOfTheRange) {
  using limits = std::numeric_limits<double>;
  // The variable is volatile because converting a known NaN is undefined; a compiler may yield 0.
  const volatile double nan = limits::quiet_NaN();
  for (const Conversion conversion : {Conversion::published, Conversion::nearest}) {
    for (const double large : {32768.0, 1e9, limits::max(), limits::infinity()}) {
      EXPECT_EQ(raw_constant(large, conversion), max_raw);
      EXPECT_EQ(raw_constant(-large - 1, conversion), least_raw);
    }
    EXPECT_EQ(raw_constant(nan, conversion), 0);
    EXPECT_EQ(raw_constant(limits::denorm_min(), conversion), 0);
    // The largest value in range is 2^31 - 1 ulp.
    EXPECT_EQ(raw_constant(32768 - std::ldexp(1, -16), conversion), max_raw);
    EXPECT_EQ(raw_constant(32768 - std::ldexp(3, -17), conversion), max_raw);
    EXPECT_EQ(raw_constant(32768 - std::ldexp(2, -16), conversion), max_raw - 1);
  }
}

TEST(RawCoordinate, WholeNumbersAreExactUnderBothConversions) {
  for (const std::int32_t whole : {-32768, -320, -1, 0, 1, 32767}) {
    EXPECT_EQ(coordinate<fixproof::q16_16>(whole, Conversion::published).raw(), whole * 65536);
    EXPECT_EQ(coordinate<fixproof::q16_16>(whole, Conversion::nearest).raw(), whole * 65536);
  }
  // -0.5 is -32768 ulp; -32767.5 truncates to -32767.
  EXPECT_EQ(coordinate<fixproof::q16_16>(-0.5, Conversion::published).raw(), -32767);
  EXPECT_EQ(coordinate<fixproof::q16_16>(-0.5, Conversion::nearest).raw(), -32768);
  EXPECT_EQ(
      coordinate<fixproof::q16_16>(std::numeric_limits<double>::quiet_NaN(), Conversion::published)
          .raw(),
      0);
}

template <class N>
struct ArithmeticOf : testing::Test {};
TYPED_TEST_SUITE(ArithmeticOf, pipeline::all_types, );

TYPED_TEST(ArithmeticOf, NearestPixelIsNearestHalvesUp) {
  using N = TypeParam;
  const auto pixel = [](double x) { return nearest_pixel(pipeline::number<N>(x)); };
  EXPECT_EQ(pixel(0.5), 1);
  EXPECT_EQ(pixel(-0.5), 0);
  EXPECT_EQ(pixel(-1.5), -1);
  EXPECT_EQ(pixel(2.5 - std::ldexp(1, -16)), 2);
  EXPECT_EQ(pixel(-0.5 - std::ldexp(1, -16)), -1);
  EXPECT_TRUE(draws::hold_for_raws(1, [](const draws::Integers& raw) {
    const auto x = Arithmetic<N>::from_raw(static_cast<std::int32_t>(raw[0]));
    return nearest_pixel(x) == floor_of(raw[0] + 0x8000, 0x10000);
  }));
}

TYPED_TEST(ArithmeticOf, RawsGoThroughUnchanged) {
  using A = Arithmetic<TypeParam>;
  EXPECT_TRUE(draws::hold_for_raws(1, [](const draws::Integers& raw) {
    return A::raw(A::from_raw(static_cast<std::int32_t>(raw[0]))) == raw[0];
  }));
  EXPECT_EQ(static_cast<double>(from_whole<TypeParam>(-7)), -7);
}

TYPED_TEST(ArithmeticOf, AMidpointIsBetween) {
  using A = Arithmetic<TypeParam>;
  EXPECT_TRUE(draws::hold_for_raws(2, [](const draws::Integers& raw) {
    const auto a = A::from_raw(static_cast<std::int32_t>(raw[0]));
    const auto b = A::from_raw(static_cast<std::int32_t>(raw[1]));
    const double exact = (static_cast<double>(a) + static_cast<double>(b)) / 2;
    const auto middle = static_cast<double>(A::midpoint(a, b));
    return std::fabs(middle - exact) <= pipeline::ulp / 2;
  }));
}

TYPED_TEST(ArithmeticOf, DivideByZeroHasNoResult) {
  using A = Arithmetic<TypeParam>;
  EXPECT_FALSE(A::divide(from_whole<TypeParam>(1), from_whole<TypeParam>(0)));
  EXPECT_EQ(A::divide(from_whole<TypeParam>(-6), from_whole<TypeParam>(3)),
            from_whole<TypeParam>(-2));
}

// Adds the floors and the fractions separately, in 64-bit integers.
TYPED_TEST(ArithmeticOf, OnlyThe8088LosesTheCarryOfATranslation) {
  using N = TypeParam;
  using A = Arithmetic<N>;
  constexpr bool loses = [] {
    if constexpr (std::same_as<N, double>) {
      return false;
    } else {
      return N::rules.divisor == fixproof::divisor_width::whole_part;
    }
  }();
  const auto moved = [](std::int32_t raw) {
    Transform<N> t = identity<N>();
    t.rows[1][3] = A::from_raw(raw);
    return t;
  };
  EXPECT_TRUE(draws::hold(2, -1'000'000'000, 1'000'000'000, [&](const draws::Integers& raw) {
    const std::int64_t whole = raw[0] + raw[1];
    const std::int64_t in_parts = (floor_of(raw[0], 65536) + floor_of(raw[1], 65536)) * 65536 +
                                  (whole - floor_of(whole, 65536) * 65536);
    const auto by = [&](Concatenation how) {
      return A::raw(A::concatenate(moved(static_cast<std::int32_t>(raw[0])),
                                   moved(static_cast<std::int32_t>(raw[1])), how)
                        .rows[1][3]);
    };
    return by(Concatenation::published) == (loses ? in_parts : whole) &&
           by(Concatenation::repaired) == whole;
  }));
}

// A float has 24 significant bits. Units of 2^-16 beyond them are rounded to even.
TEST(ArithmeticInFloat, RoundsTo24Bits) {
  using A = Arithmetic<float>;
  EXPECT_EQ(A::from_raw(0x18000), 1.5F);
  EXPECT_EQ(A::raw(-1.5F), -0x18000);
  EXPECT_EQ(A::raw(A::from_raw(0x1000001)), 0x1000000);
  EXPECT_EQ(A::raw(A::from_raw(0x1000003)), 0x1000004);
  EXPECT_EQ(A::from_raw(max_raw), 32768.0F);
  EXPECT_EQ(A::raw(32768.0F), max_raw);
  EXPECT_EQ(A::raw(std::numeric_limits<float>::quiet_NaN()), 0);
  // Constants are rounded to a float, not to 16.16.
  EXPECT_EQ(A::constant(0.1, Conversion::published), 0.1F);
  EXPECT_EQ(A::constant(-1.0, Conversion::published), -1.0F);
  EXPECT_EQ(A::constant(16777217, Conversion::nearest), 16777216.0F);
}

TEST(ArithmeticInFloat, ComputesInFloat) {
  using A = Arithmetic<float>;
  EXPECT_EQ(A::divide(1, 3), 0x1.555556p-2F);
  EXPECT_FALSE(A::divide(1, 0));
  EXPECT_FALSE(A::divide(0, -0.0F));
  EXPECT_FALSE(A::divides_by_whole_part());
  EXPECT_EQ(A::midpoint(1, 2), 1.5F);
  EXPECT_EQ(A::midpoint(std::numeric_limits<float>::max(), std::numeric_limits<float>::max()),
            std::numeric_limits<float>::max());
  EXPECT_NEAR(A::length({2, -3, 6}), 7, 0x1p-21);  // an ulp
  EXPECT_EQ(A::power(0.5F, 10), 0x1p-10F);
  EXPECT_NEAR(A::power(2, 0.5F), std::sqrt(2.0), 0x1p-23);
  EXPECT_NEAR(A::turn(300).sin, 0.5, 0x1p-24);
  EXPECT_NEAR(A::turn(-300).cos, std::sqrt(0.75), 0x1p-24);
  EXPECT_EQ(nearest_pixel(-0.5F), 0);
  EXPECT_EQ(nearest_pixel(2.5F), 3);
}

TEST(ArithmeticInFloat, TransformsAreSumsOfProducts) {
  using A = Arithmetic<float>;
  Transform<float> t = identity<float>();
  t.rows[0] = {2, 0, -1, 5};
  EXPECT_EQ(A::apply(t, {3, 4, 7}), (Vec3<float>{4, 4, 7}));
  // 2 * 2 + -1 * 0, 2 * 0, 2 * -1 + -1 * 1, 2 * 5 + 5
  for (const Concatenation how : {Concatenation::published, Concatenation::repaired}) {
    const Transform<float> both = A::concatenate(t, t, how);
    EXPECT_EQ(both.rows[0], (std::array<float, 4>{4, 0, -3, 15}));
    EXPECT_EQ(both.rows[1], t.rows[1]);
    EXPECT_EQ(both.rows[2], t.rows[2]);
  }
}

// A custom policy that divides by the whole part alone is not an 8088 build.
TEST(Concatenation, APolicyOfOnesOwnKeepsTheCarry) {
  constexpr fixproof::policy own{.divisor = fixproof::divisor_width::whole_part};
  EXPECT_FALSE(is_i8088_build(own));
  EXPECT_FALSE(is_i8088_build(fixproof::policies::i386_rounded));
  EXPECT_TRUE(is_i8088_build(fixproof::policies::i8088_mul_rounded));
}

}  // namespace
}  // namespace xsharp

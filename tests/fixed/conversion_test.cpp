/// Tests conversions from and to float, double, integers and other number types.
#include "fixed/fixed.hpp"
#include "tests/fixed/exact.hpp"
#include "tests/fixed/floats.hpp"
#include "tests/fixed/property.hpp"
#include "tests/fixed/types.hpp"
#include "tests/support/rounding_mode.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using floats::converted;
using floats::take_apart;

template <class Number>
class Conversion : public testing::Test {};
TYPED_TEST_SUITE(Conversion, some_types);

template <class Number, class Float>
void expect_converted(Float x) {
  const auto want = converted<Number>(x);
  for (const int mode : RoundingMode::all) {
    const auto got = exact::run<Number>([x, mode] {
      const RoundingMode set(mode);
      return Number(x);
    });
    ASSERT_EQ(got, want) << take_apart(x).m << " * 2^" << take_apart(x).e << ", mode " << mode;
  }
}

TYPED_TEST(Conversion, FromFloatingPointOfEveryExponent) {
  std::mt19937_64 random(21);
  for (std::uint64_t exponent = 0; exponent < 0x7ff; ++exponent) {
    for (const std::uint64_t fraction :
         {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{0xfffffffffffff},
          std::uint64_t{0x8000000000000}, random() >> 12, random() >> 42 << 30}) {
      const std::uint64_t bits = exponent << 52 | fraction;
      expect_converted<TypeParam>(std::bit_cast<double>(bits));
      expect_converted<TypeParam>(std::bit_cast<double>(bits | std::uint64_t{1} << 63));
    }
  }
  for (std::uint32_t exponent = 0; exponent < 0xff; ++exponent) {
    for (const std::uint32_t fraction : {0u, 1u, 0x7fffffu, 0x400000u, 0x123456u}) {
      const std::uint32_t bits = exponent << 23 | fraction;
      expect_converted<TypeParam>(std::bit_cast<float>(bits));
      expect_converted<TypeParam>(std::bit_cast<float>(bits | std::uint32_t{1} << 31));
    }
  }
}

TYPED_TEST(Conversion, FromDoubleAroundEveryHalf) {
  for (const auto x : exact::edges<TypeParam>()) {
    for (const int eighths : {-5, -4, -3, -1, 0, 1, 3, 4, 5}) {
      const double units = static_cast<double>(x.raw()) + eighths / 8.0;
      expect_converted<TypeParam>(units / static_cast<double>(exact::one<TypeParam>));
    }
  }
}

TYPED_TEST(Conversion, FromWhatIsNoNumber) {
  using limits = std::numeric_limits<TypeParam>;
  constexpr bool trap = TypeParam::rules.range == overflow::trap;
  const auto expect = [](exact::outcome<TypeParam> expected, auto x) {
    EXPECT_EQ(exact::run<TypeParam>([x] { return TypeParam(x); }), expected);
  };
  const auto end = [](TypeParam x) {
    return trap ? exact::outcome<TypeParam>{true, 0} : exact::outcome<TypeParam>{false, x.raw()};
  };
  expect(end(TypeParam()), std::bit_cast<double>(std::uint64_t{0x7ff8000000000000}));
  expect(end(TypeParam()), std::bit_cast<double>(std::uint64_t{0xfff0000000000001}));
  expect(end(TypeParam()), std::bit_cast<float>(std::uint32_t{0x7fc00000}));
  expect(end(limits::max()), std::bit_cast<double>(std::uint64_t{0x7ff0000000000000}));
  expect(end(limits::lowest()), std::bit_cast<double>(std::uint64_t{0xfff0000000000000}));
  expect(end(limits::max()), std::bit_cast<float>(std::uint32_t{0x7f800000}));
  expect(end(limits::lowest()), std::bit_cast<float>(std::uint32_t{0xff800000}));
}

TYPED_TEST(Conversion, ToDoubleAndBackIsTheSame) {
  EXPECT_TRUE(property::for_all<TypeParam>([](TypeParam x) {
    const auto value = static_cast<double>(x);
    const auto [m, e] = take_apart(value);
    const int shift = e + TypeParam::fraction_bits;
    return shift <= 0 && m == (shift < -62 ? std::int64_t{0} : std::int64_t{x.raw()} << -shift) &&
           TypeParam(value) == x;
  }));
}

TYPED_TEST(Conversion, ToFloatIsNearestEven) {
  const auto check = [](TypeParam x) {
    const auto [m, e] = take_apart(static_cast<float>(x));
    // The float, in ulps of the number, is as near as a 24-bit significand allows.
    const int shift = e + TypeParam::fraction_bits;
    if (shift <= 0) return x.raw() == 0 ? m == 0 : m == std::int64_t{x.raw()} << -shift;
    const std::int64_t step = std::int64_t{1} << shift;
    const std::int64_t error = 2 * (m * step - x.raw());
    return (m > -0x1000000 && m < 0x1000000) && (error < 0 ? -error : error) <= step &&
           ((error != step && error != -step) || m % 2 == 0);
  };
  for (const auto x : exact::edges<TypeParam>()) EXPECT_TRUE(check(x)) << x;
  EXPECT_TRUE(property::for_all<TypeParam>(check));
}

template <class Number, class Int>
void expect_integer(Int value) {
  const exact::integer units = exact::integer{value} * exact::one<Number>;
  EXPECT_EQ(exact::run<Number>([value] { return Number(value); }), exact::in_range<Number>(units))
      << +value;
}

template <class Number, class Int>
void expect_integers() {
  using limits = std::numeric_limits<Int>;
  for (const exact::integer edge :
       {exact::integer{0}, exact::integer{1}, exact::integer{127}, exact::integer{128},
        exact::integer{32767}, exact::integer{32768}, exact::integer{65536},
        exact::integer{1} << 31, exact::integer{1} << 32, exact::integer{1} << 47,
        exact::integer{limits::max()}, exact::integer{limits::min()}}) {
    for (const int step : {-1, 0, 1}) {
      for (const exact::integer value : {edge + step, -edge + step}) {
        if (value < limits::min() || value > limits::max()) continue;
        expect_integer<Number>(static_cast<Int>(value));
      }
    }
  }
}

TYPED_TEST(Conversion, FromIntegersOfEveryType) {
  expect_integers<TypeParam, signed char>();
  expect_integers<TypeParam, unsigned char>();
  expect_integers<TypeParam, short>();
  expect_integers<TypeParam, unsigned short>();
  expect_integers<TypeParam, int>();
  expect_integers<TypeParam, unsigned>();
  expect_integers<TypeParam, long>();
  expect_integers<TypeParam, unsigned long>();
  expect_integers<TypeParam, long long>();
  expect_integers<TypeParam, unsigned long long>();
}

TYPED_TEST(Conversion, ToIntegerIsTowardZero) {
  EXPECT_TRUE(property::for_all<TypeParam>([](TypeParam x) {
    const std::int64_t whole = x.raw() / exact::one<TypeParam>;
    return static_cast<int>(x) == whole && static_cast<long long>(x) == whole &&
           static_cast<unsigned char>(x) == static_cast<unsigned char>(whole) &&
           static_cast<unsigned long>(x) == static_cast<unsigned long>(whole);
  }));
}

template <class To, class From>
void expect_between() {
  for (const From x : exact::edges<From>()) {
    const exact::fraction units{exact::integer{x.raw()} * exact::one<To>, exact::one<From>};
    EXPECT_EQ(exact::run<To>([x] { return To(x); }), exact::result<To>(units)) << x;
  }
}

TEST(ConversionBetweenNumbers, IsOneRounding) {
  expect_between<q8_8, q16_16>();
  expect_between<q8_8_saturating, q16_16>();
  expect_between<q8_8_trapping, q16_16>();
  expect_between<q8_8_i386_unrounded, q16_16>();
  expect_between<q8_8_i8088, q16_16_saturating>();
  expect_between<q8_8_i8088_unrounded, q16_16>();
  expect_between<q16_16, q8_8>();
  expect_between<q16_16_trapping, q8_8_i8088>();
  expect_between<q16_16_i386, q16_16>();
}

}  // namespace

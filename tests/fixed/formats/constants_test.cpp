/// Tests the constants in every format against series and roots in integers of 1,024 bits.
#include "fixed/constants.hpp"

#include "fixed/fixed.hpp"
#include "tests/fixed/formats/integer.hpp"
#include "tests/support/test.hpp"

namespace constants_test {

using namespace fixproof;
using reference::integer;

/// Values below are in units of 2^-256. Each has an error of less than 2^-200.
constexpr int precision = 256;
const integer unit = integer(1) << precision;

integer times(const integer& a, const integer& b) { return (a * b) >> precision; }
integer over(const integer& a, const integer& b) { return (a << precision) / b; }
integer scaled_root(const integer& a) { return reference::floor_root(a << precision); }

/// The sum of sign^k / ((2k + 1) n^(2k + 1)): atan(1/n) if sign is -1, atanh(1/n) if it is 1.
integer inverse_tangent(int n, int sign) {
  integer sum = 0;
  integer power = unit / n;
  for (int k = 1; power != 0; k += 2) {
    sum += power / (k % 4 == 1 ? k : k * sign);
    power /= n * n;
  }
  return sum;
}

integer euler_number() {
  integer sum = 0;
  integer term = unit;
  for (int k = 1; term != 0; ++k) {
    sum += term;
    term /= k;
  }
  return sum;
}

const integer pi = 16 * inverse_tangent(5, -1) - 4 * inverse_tangent(239, -1);  // Machin
const integer ln2 = 2 * inverse_tangent(3, 1);             // (1 + 1/3) / (1 - 1/3)
const integer ln10 = 3 * ln2 + 2 * inverse_tangent(9, 1);  // 8 * 5/4

/// Brent and McMillan: with b = (n^k / k!)^2, the sum of b H(k) over that of b, less ln n. The
/// error is below pi e^-4n, here 2^-367.
integer euler_mascheroni() {
  constexpr int n = 64;
  integer term = unit;
  integer harmonic = 0;
  integer numerator = 0;
  integer denominator = unit;
  for (int k = 1; term != 0; ++k) {
    term = term * (n * n) / (k * k);
    harmonic += unit / k;
    numerator += times(term, harmonic);
    denominator += term;
  }
  return over(numerator, denominator) - 6 * ln2;
}

/// The integer nearest to value * 2^bits. Expects that the value is far enough from a tie.
integer nearest(const integer& value, int bits) {
  const integer half = integer(1) << (precision - bits - 1);
  const integer fraction = value % (2 * half);
  const integer from_tie = fraction > half ? fraction - half : half - fraction;
  EXPECT_GT(from_tie, integer(1) << (precision - 140));
  return (value + half) >> (precision - bits);
}

/// What one format makes of a constant.
struct Given {
  int bits;
  std::uint64_t highest;
  bool in_range;
  std::uint64_t raw;
};

template <class Number, detail::constant C>
constexpr Given given(const auto& constant_of) {
  constexpr auto highest =
      static_cast<std::uint64_t>(std::numeric_limits<typename Number::raw_type>::max());
  if constexpr (detail::holds<Number>(C)) {
    return {Number::fraction_bits, highest, true,
            static_cast<std::uint64_t>(constant_of(Number()).raw())};
  } else {
    return {Number::fraction_bits, highest, false, 0};
  }
}

/// All fraction bits of all stored integers, and with them the format of every alias.
template <detail::constant C>
std::vector<Given> given_everywhere(const auto& constant_of) {
  std::vector<Given> all;
  const auto with = [&]<class Raw, int... Bits>(Raw, std::integer_sequence<int, Bits...>) {
    (all.push_back(given<number<Raw, Bits>, C>(constant_of)), ...);
  };
  const auto both = [&]<class Signed>(Signed raw) {
    constexpr int bits = std::numeric_limits<Signed>::digits + 1;
    with(raw, std::make_integer_sequence<int, bits + 1>());
    with(std::make_unsigned_t<Signed>(), std::make_integer_sequence<int, bits + 1>());
  };
  both(std::int8_t());
  both(std::int16_t());
  both(std::int32_t());
  both(std::int64_t());
  return all;
}

/// @param whole_bits binary digits of the constant before the point; -1 if it is below a half
void expect_nearest(const std::vector<Given>& all, const integer& value, int whole_bits) {
  int out_of_range = 0;
  for (const Given& given : all) {
    const integer expected = nearest(value, given.bits);
    EXPECT_EQ(given.in_range, expected <= given.highest) << given.bits << ' ' << given.highest;
    if (given.in_range) {
      EXPECT_EQ(given.raw, expected) << given.bits << ' ' << given.highest;
    }
    out_of_range += given.in_range ? 0 : 1;
  }
  EXPECT_EQ(all.size(), 2U * (9 + 17 + 33 + 65));
  // Of the unsigned types of each width, as many as there are digits; of the signed, one more.
  EXPECT_EQ(out_of_range, 4 * std::max(whole_bits, 0) + 4 * (whole_bits + 1));
}

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): the names of a constant
#define EXPECT_CONSTANT(name, value, whole_bits)                                \
  expect_nearest(given_everywhere<detail::constants::name>([]<class N>(N) {     \
                   static_assert(std::same_as<decltype(name##_v<N>), const N>); \
                   return name##_v<N>;                                          \
                 }),                                                            \
                 value, whole_bits)

TEST(Constants, Circle) {
  EXPECT_CONSTANT(pi, pi, 2);
  EXPECT_CONSTANT(tau, 2 * pi, 3);
  EXPECT_CONSTANT(half_pi, pi / 2, 1);
  EXPECT_CONSTANT(inv_pi, over(unit, pi), -1);
  EXPECT_CONSTANT(inv_sqrtpi, scaled_root(over(unit, pi)), 0);
}

TEST(Constants, Logarithms) {
  EXPECT_CONSTANT(e, euler_number(), 2);
  EXPECT_CONSTANT(ln2, ln2, 0);
  EXPECT_CONSTANT(ln10, ln10, 2);
  EXPECT_CONSTANT(log2e, over(unit, ln2), 1);
  EXPECT_CONSTANT(log10e, over(unit, ln10), -1);
}

TEST(Constants, Roots) {
  EXPECT_CONSTANT(sqrt2, scaled_root(2 * unit), 1);
  EXPECT_CONSTANT(sqrt3, scaled_root(3 * unit), 1);
  EXPECT_CONSTANT(inv_sqrt3, scaled_root(unit / 3), 0);
  EXPECT_CONSTANT(phi, (unit + scaled_root(5 * unit)) / 2, 1);
  EXPECT_CONSTANT(egamma, euler_mascheroni(), 0);
}

/// The words that are stored, to their last bit but for truncation.
TEST(Constants, Words) {
  const auto expect = [](const detail::constant& c, const integer& value) {
    const integer words = (integer(c.whole) << 128) + (integer(c.high) << 64) + c.low;
    EXPECT_EQ(words, value >> (precision - 128));
  };
  expect(detail::constants::pi, pi);
  expect(detail::constants::tau, 2 * pi);
  expect(detail::constants::half_pi, pi / 2);
  expect(detail::constants::e, euler_number());
  expect(detail::constants::ln2, ln2);
  expect(detail::constants::ln10, ln10);
  expect(detail::constants::log2e, over(unit, ln2));
  expect(detail::constants::log10e, over(unit, ln10));
  expect(detail::constants::sqrt2, scaled_root(2 * unit));
  expect(detail::constants::sqrt3, scaled_root(3 * unit));
  expect(detail::constants::inv_pi, over(unit, pi));
  expect(detail::constants::inv_sqrtpi, scaled_root(over(unit, pi)));
  expect(detail::constants::inv_sqrt3, scaled_root(unit / 3));
  expect(detail::constants::phi, (unit + scaled_root(5 * unit)) / 2);
  expect(detail::constants::egamma, euler_mascheroni());
}

// The policy has no part in it: 92681.9 units.
static_assert(sqrt2_v<q16_16>.raw() == 92682 && sqrt2_v<q16_16_i386_unrounded>.raw() == 92682);
// 26353589.27 units, of which half of the rounded pi is 26353589.5.
static_assert(half_pi_v<q8_24>.raw() == 26353589 && (pi_v<q8_24> / 2).raw() == 26353590);
static_assert(sqrt2_v<q16_16_trapping>.raw() == 92682 && sqrt2_v<u1_15>.raw() == 46341);

namespace standard = std::numbers;
template <class N>
constexpr bool equal_standard =
    standard::pi_v<N> == pi_v<N>&& standard::e_v<N> == e_v<N>&& standard::ln2_v<N> ==
    ln2_v<N>&& standard::ln10_v<N> == ln10_v<N>&& standard::log2e_v<N> ==
    log2e_v<N>&& standard::log10e_v<N> == log10e_v<N>&& standard::sqrt2_v<N> ==
    sqrt2_v<N>&& standard::sqrt3_v<N> == sqrt3_v<N>&& standard::inv_pi_v<N> ==
    inv_pi_v<N>&& standard::inv_sqrtpi_v<N> == inv_sqrtpi_v<N>&& standard::inv_sqrt3_v<N> ==
    inv_sqrt3_v<N>&& standard::phi_v<N> == phi_v<N>&& standard::egamma_v<N> == egamma_v<N>;
static_assert(equal_standard<q16_16> && equal_standard<q8_8_trapping> && equal_standard<u32_32>);

TEST(IntegerConstant, IsThatValue) {
  static_assert(constant_v<q8_8, 127>.raw() == 127 * 256 &&
                constant_v<q8_8, -128>.raw() == -128 * 256);
  static_assert(constant_v<u0_64, 0>.raw() == 0 &&
                constant_v<u48_16, (1ULL << 48) - 1>.raw() == ~0xffffULL);
  static_assert(constant_v<q1_63, -1>.raw() == std::numeric_limits<std::int64_t>::min());
  static_assert(constant_v<q16_16_saturating, -32768>.raw() ==
                std::numeric_limits<std::int32_t>::min());
}

}  // namespace constants_test

/// Tests exponentials and logarithms against the oracle, and the error bounds of their parts.
#include "fixed/exponential.hpp"

#include "fixed/fixed.hpp"
#include "fixed/literals.hpp"
#include "oracle/exponential.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using oracle::Exponential;
using oracle::Integer;

constexpr std::array functions{Exponential::exp2, Exponential::exp, Exponential::log2,
                               Exponential::log, Exponential::log10};

template <class N>
N result(Exponential function, N x) {
  switch (function) {
    case Exponential::exp2:
      return exp2(x);
    case Exponential::exp:
      return exp(x);
    case Exponential::log2:
      return log2(x);
    case Exponential::log:
      return log(x);
    default:
      return log10(x);
  }
}

/// The oracle's result as the word of a type that saturates.
template <class N>
N expected(Exponential function, N x, oracle::Rounding ties) {
  using raw = typename N::raw_type;
  constexpr raw lowest = std::numeric_limits<raw>::min();
  constexpr raw highest = std::numeric_limits<raw>::max();
  const auto ulps = oracle::nearest(function, x.raw(), N::fraction_bits, ties);
  if (!ulps || *ulps < lowest) return N::from_raw(lowest);
  return N::from_raw(*ulps > highest ? highest : static_cast<raw>(*ulps));
}

template <class N>
void expect_nearest(N x, oracle::Rounding ties = oracle::Rounding::half_up) {
  for (const Exponential function : functions) {
    const N want = expected(function, x, ties);
    ASSERT_EQ(result(function, x).raw(), want.raw())
        << "function " << static_cast<int>(function) << " of raw " << +x.raw();
  }
}

template <class N>
class EveryWord : public testing::Test {};
using EightBits = testing::Types<q8_0, q4_4, q1_7, u4_4, u0_8>;
TYPED_TEST_SUITE(EveryWord, EightBits);

TYPED_TEST(EveryWord, OfEightBitsIsNearest) {
  for (int word = 0; word < 256; ++word) {
    expect_nearest(TypeParam::from_raw(static_cast<typename TypeParam::raw_type>(word)));
  }
}

template <class N>
class SomeWords : public testing::Test {};
using WideFormats = testing::Types<q12_4, q8_8, q4_12, q1_15, u8_8, u0_16, q32_0, q24_8, q16_16,
                                   q8_24, q2_30, q1_31, u24_8, u16_16, u1_31, u0_32>;
TYPED_TEST_SUITE(SomeWords, WideFormats);

TYPED_TEST(SomeWords, AreNearest) {
  using raw = typename TypeParam::raw_type;
  std::mt19937_64 random(1994);
  for (int i = 0; i < 400; ++i) {
    // Words of every length, so that small numbers and their negatives occur too.
    const auto word = static_cast<std::int64_t>(random()) >> (32 + i % 32);
    expect_nearest(TypeParam::from_raw(static_cast<raw>(word)));
  }
  for (int bit = 0; bit < std::numeric_limits<raw>::digits; ++bit) {
    for (const int near : {-1, 0, 1}) {
      const std::int64_t word = (std::int64_t{1} << bit) + near;
      expect_nearest(TypeParam::from_raw(static_cast<raw>(word)));
      expect_nearest(TypeParam::from_raw(static_cast<raw>(-word)));
    }
  }
}

TEST(Exponentials, TiesFollowThePolicy) {
  using even = number<std::int16_t, 8, policy{.multiply = rounding::half_even}>;
  using down = number<std::int16_t, 8, policy{.multiply = rounding::floor}>;
  EXPECT_EQ(exp2(q8_8(-9)).raw(), 1);
  EXPECT_EQ(exp2(even(-9)).raw(), 0);
  EXPECT_EQ(exp2(down(-9)).raw(), 1);
  EXPECT_EQ(exp2(even::from_raw(-9 * 256 + 1)).raw(), 1);
  for (int word = -0x8000; word < 0x8000; word += 97) {
    expect_nearest(even::from_raw(static_cast<std::int16_t>(word)), oracle::Rounding::half_even);
  }
}

TEST(Exponentials, RangeAndDomainFollowThePolicy) {
  EXPECT_EQ(exp(q16_16(11)), std::numeric_limits<q16_16>::max());
  EXPECT_EQ(exp(q16_16(-32768)), q16_16());
  EXPECT_EQ(exp2(q1_31()), std::numeric_limits<q1_31>::max());
  EXPECT_EQ(log(q16_16()), std::numeric_limits<q16_16>::lowest());
  EXPECT_EQ(log2(q16_16(-1)), std::numeric_limits<q16_16>::lowest());
  EXPECT_EQ(log(u16_16::from_raw(1)), u16_16());
  EXPECT_EQ(log2(q2_30::from_raw(1)), std::numeric_limits<q2_30>::lowest());
  EXPECT_THROW((void)exp(q16_16_trapping(11)), overflow_error);
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
    const detail::real precise = detail::precise_power(detail::real{x} << 56);
    const auto exact = static_cast<std::uint64_t>(precise >> (detail::real_bits - 63));
    const std::uint64_t below = exact - detail::power_of_two(x);
    ASSERT_LE(below, 15U) << x;
  }
}

TEST(Exponentials, LogarithmsHaveTheirError) {
  std::mt19937_64 random(1994);
  for (int i = 0; i < 20'000; ++i) {
    auto m = static_cast<std::uint32_t>(random() | 0x80000000U);
    if (i % 4 == 0) m = (m & 0xfe000000U) + m % 16;
    if (i % 4 == 1) m = (m | 0x01ffffffU) - m % 16;
    const detail::real precise = detail::precise_logarithm(m);
    const auto exact = static_cast<std::uint64_t>(precise >> (detail::real_bits - 64));
    const auto difference = static_cast<std::int64_t>(detail::binary_logarithm(m) - exact);
    ASSERT_LE(std::abs(difference), 5) << m;
  }
}

// Operands whose results are so near to a tie that 64 bits round them wrongly: only the precise
// path is right. Found among all words of q2_30.
TEST(Exponentials, HardWords) {
  for (const std::int32_t word :
       {695178213, 696541552, 952523017, 260216662, 339250479, 357012564, 52433004, 92286145,
        120718935, 121174018, 143521457, 170986079, 313536106, 446488154, 524330040, 922861450}) {
    expect_nearest(q2_30::from_raw(word));
  }
}

TEST(Exponentials, PreciseOnesAreNearest) {
  // The fast path decides nearly every rounding, so this calls the precise one.
  for (int word = -700; word < 1900; ++word) {
    if (word == 0) continue;
    const auto exact =
        oracle::nearest(Exponential::exp, word, 8, oracle::Rounding::half_up).value();
    EXPECT_EQ(
        (detail::precise_exponential<detail::exponential_base::e, 8>(std::int64_t{word} << 24)),
        static_cast<std::int64_t>(exact))
        << word;
  }
}

TEST(Exponentials, AreConstantExpressions) {
  using namespace literals;
  static_assert(exp(1_q8_24).raw() == 45605201);     // 45605201.4
  static_assert(log(1.5_q2_30).raw() == 435364845);  // 435364844.7
  static_assert(log10(u16_16(1000)) == 3 && log2(q24_8(1 << 20)) == 20);
}

}  // namespace

#include "oracle/exact.hpp"
#include "oracle/fast_sine.hpp"
#include "oracle/real.hpp"
#include "tests/support/test.hpp"

namespace oracle {
namespace {

/// Words whose sine or cosine is within 2^-46 of a half ulp, found by exhaustive search.
constexpr Word kHard[]{0x60cf72d8, 0x4162745d, 0x6c6b7c74, 0x734c79ae,
                       0x6f29ca6b, 0x776c1f1d, 0x378b3a20};

/// Checks that `word` is the nearest to an exact value, which an extended double gives to 2^-60.
void expect_nearest(Word word, long double exact, Word angle) {
  static_assert(std::numeric_limits<long double>::digits >= 64);
  const long double ulps = exact * 65536;
  EXPECT_EQ(static_cast<long double>(static_cast<std::int32_t>(word)), std::round(ulps)) << angle;
}

void expect_both(Word angle) {
  const auto radians = static_cast<long double>(static_cast<std::int32_t>(angle)) / 65536;
  expect_nearest(sin(angle, 16), std::sin(radians), angle);
  expect_nearest(cos(angle, 16), std::cos(radians), angle);
  EXPECT_EQ(fast::sin(angle, 16), sin(angle, 16)) << angle;
  EXPECT_EQ(fast::cos(angle, 16), cos(angle, 16)) << angle;
}

TEST(OracleSine, KnownAngles) {
  EXPECT_EQ(sin(0, 16), 0U);
  EXPECT_EQ(cos(0, 16), 0x10000U);
  EXPECT_EQ(sin(0x10000, 16), 55147U);      // 0.8414709848 * 65536 = 55146.64
  EXPECT_EQ(cos(0x10000, 16), 35409U);      // 0.5403023059 * 65536 = 35409.25
  EXPECT_EQ(sin(0xffff0000, 16), -55147U);  // sin(-1)
  EXPECT_EQ(sin(0x100, 8), 215U);           // 215.42
  EXPECT_EQ(cos(0xff00, 8), 138U);          // cos(-1): 138.32
  EXPECT_EQ(sin(0xff00, 8), 0xff29U);
}

TEST(OracleSine, BothFormulationsAndTheLibraryAgree) {
  for (const Word angle : kHard) {
    expect_both(angle);
    expect_both(~angle + 1);
  }
  for (int bit = 0; bit < 32; ++bit) {
    const Word power = Word{1} << bit;
    for (const Word angle : {power - 1, power, power + 1, ~power, ~power + 1}) expect_both(angle);
  }
  std::mt19937 random(2026);  // NOLINT(cert-msc32-c, cert-msc51-cpp)
  for (int i = 0; i < 5000; ++i) expect_both(static_cast<Word>(random()));
}

TEST(OracleSine, FastAgreesInEveryFormat) {
  std::mt19937 random(11);  // NOLINT(cert-msc32-c, cert-msc51-cpp)
  for (int fraction_bits = 2; fraction_bits <= 16; ++fraction_bits) {
    for (int i = 0; i < 300; ++i) {
      const auto angle = static_cast<Word>(random());
      ASSERT_EQ(fast::sin(angle, fraction_bits), sin(angle, fraction_bits)) << angle;
      ASSERT_EQ(fast::cos(angle, fraction_bits), cos(angle, fraction_bits)) << angle;
    }
  }
}

TEST(OracleSine, OnlyTheBitsOfTheFormatCount) {
  EXPECT_EQ(sin(0xabcd0100, 8), sin(0x0100, 8));
  EXPECT_EQ(fast::cos(0xabcdff00, 8), fast::cos(0xff00, 8));
}

TEST(OracleSine, FormatsOutsideTheRangeAreRefused) {
  for (const int fraction_bits : {-1, 1, 17}) {
    EXPECT_THROW((void)sin(1, fraction_bits), std::invalid_argument);
    EXPECT_THROW((void)cos(1, fraction_bits), std::invalid_argument);
    EXPECT_THROW((void)fast::sin(1, fraction_bits), std::invalid_argument);
    EXPECT_THROW((void)fast::cos(1, fraction_bits), std::invalid_argument);
  }
}

TEST(OracleSine, ManyDigits) {
  // sin^2 + cos^2 = 1, to the computed number of digits.
  const Integer sin = scaled_sin_of_radians(0x60cf72d8, 60);
  const Integer cos = scaled_cos_of_radians(0x60cf72d8, 60);
  const Integer one = Integer(1) << (2 * 76);
  EXPECT_LT(abs(sin * sin + cos * cos - one), Integer(1) << 78);
}

}  // namespace
}  // namespace oracle

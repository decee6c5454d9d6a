#include "oracle/format.hpp"
#include "tests/oracle/rules.hpp"
#include "tests/support/test.hpp"

namespace oracle {
namespace {

/// Whether q is n / d rounded, by the inequalities that define each rule, for d > 0.
bool defined_by_rule(int q, int n, int d, Rounding rule) {
  const int error = q * d - n;  // in units of 1 / d
  switch (rule) {
    case Rounding::half_up:
      return 2 * error <= d && 2 * error > -d;
    case Rounding::half_away:
      return 2 * std::abs(error) < d || (2 * std::abs(error) == d && std::abs(q) * d > std::abs(n));
    case Rounding::half_even:
      return 2 * std::abs(error) < d || (2 * std::abs(error) == d && q % 2 == 0);
    case Rounding::floor:
      return error <= 0 && error > -d;
    case Rounding::truncate:
      return std::abs(error) < d && std::abs(q) * d <= std::abs(n);
    case Rounding::ceiling:
      return error >= 0 && error < d;
  }
  return false;
}

TEST(OracleRounding, ObeysTheInequalitiesOfEveryRule) {
  for (const Rounding rule : test::kRoundings) {
    for (int d = 1; d <= 12; ++d) {
      for (int n = -60; n <= 60; ++n) {
        const int q = static_cast<int>(rounded(n, d, rule));
        EXPECT_TRUE(defined_by_rule(q, n, d, rule)) << n << " / " << d << " gave " << q;
        EXPECT_EQ(rounded(-n, -d, rule), q) << n << " / " << d << " with both signs changed";
      }
    }
  }
}

TEST(OracleRounding, HalvesGoWhereTheRuleSays) {
  EXPECT_EQ(rounded(3, 2, Rounding::half_up), 2);
  EXPECT_EQ(rounded(3, 2, Rounding::half_away), 2);
  EXPECT_EQ(rounded(3, 2, Rounding::half_even), 2);
  EXPECT_EQ(rounded(1, 2, Rounding::half_even), 0);
  EXPECT_EQ(rounded(3, 2, Rounding::floor), 1);
  EXPECT_EQ(rounded(3, 2, Rounding::truncate), 1);
  EXPECT_EQ(rounded(3, 2, Rounding::ceiling), 2);
  EXPECT_EQ(rounded(-3, 2, Rounding::ceiling), -1);
  EXPECT_EQ(rounded(-3, 2, Rounding::half_up), -1);
  EXPECT_EQ(rounded(-3, 2, Rounding::half_away), -2);
  EXPECT_EQ(rounded(-3, 2, Rounding::half_even), -2);
  EXPECT_EQ(rounded(-1, 2, Rounding::half_even), 0);
  EXPECT_EQ(rounded(-5, 2, Rounding::half_even), -2);
  EXPECT_EQ(rounded(-3, 2, Rounding::floor), -2);
  EXPECT_EQ(rounded(-3, 2, Rounding::truncate), -1);
}

TEST(OracleRounding, NeedsADenominator) {
  EXPECT_THROW((void)rounded(1, 0, Rounding::floor), std::domain_error);
}

TEST(OracleRounding, ObeysTheInequalitiesInWideToo) {
  for (const Rounding rule : test::kRoundings) {
    for (int d = 1; d <= 12; ++d) {
      for (int n = -60; n <= 60; ++n) {
        const int q = static_cast<int>(rounded<Wide>(n, d, rule));
        EXPECT_TRUE(defined_by_rule(q, n, d, rule)) << n << " / " << d << " gave " << q;
      }
    }
  }
}

TEST(OracleWide, ThrowsWhereAResultDoesNotFit) {
  const Wide most = std::numeric_limits<Wide>::max();
  EXPECT_GE(Integer(most), (Integer(1) << 127) - 1);
  EXPECT_THROW((void)(most + 1), std::runtime_error);
  EXPECT_THROW((void)(-most - 1), std::runtime_error);
  EXPECT_THROW((void)(most * 2), std::runtime_error);
  EXPECT_THROW((void)rounded<Wide>(most, 1, Rounding::half_up), std::runtime_error);
  EXPECT_THROW((void)rounded<Wide>(1, most, Rounding::half_even), std::runtime_error);
  EXPECT_EQ(rounded<Wide>(most, 1, Rounding::floor), most);
}

TEST(OracleWord, IsReadAsTwosComplementOfItsFormat) {
  EXPECT_EQ(ulps(0x7fffffff, 16), 2147483647);
  EXPECT_EQ(ulps(0x80000000, 16), Integer("-2147483648"));
  EXPECT_EQ(ulps(0x8000, 8), -32768);
  EXPECT_EQ(ulps(0x7, 2), 7);
  EXPECT_EQ(ulps(0x8, 2), -8);
}

TEST(OracleWord, BitsAboveTheFormatAreIgnored) { EXPECT_EQ(ulps(0xabcd0180, 8), 0x180); }

TEST(OracleWord, WrapIsTheResidueModuloThePowerOfTwo) {
  EXPECT_EQ(wrap(Integer(1) << 32, 16), 0U);
  EXPECT_EQ(wrap((Integer(1) << 70) + 5, 16), 5U);
  EXPECT_EQ(wrap(-1, 16), 0xffffffffU);
  EXPECT_EQ(wrap(-1, 8), 0xffffU);
  EXPECT_EQ(wrap(-65536, 8), 0U);
  EXPECT_EQ(wrap(-65537, 8), 0xffffU);
}

TEST(OracleWord, IsTheSameInWide) {
  for (const int bits : {4, 5, 16, 31, 32}) {
    const Format format(bits, 0, true);
    const Integer limit = Integer(1) << (bits - 1);
    for (const Integer& centre : {Integer(0), limit, -limit, 2 * limit, -2 * limit}) {
      for (int offset = -2; offset <= 2; ++offset) {
        const Integer value = centre + offset;
        EXPECT_EQ(wrap<Wide>(Wide(value), format), wrap(value, format)) << value;
        EXPECT_EQ(fits<Wide>(Wide(value), format), fits(value, format)) << value;
      }
    }
  }
  for (int fraction_bits = 2; fraction_bits <= 16; ++fraction_bits) {
    EXPECT_EQ(Integer(one<Wide>(fraction_bits)), one(fraction_bits));
    for (const Word word : {0U, 7U, 8U, 0x7fffU, 0x8000U, 0xabcd0180U, 0x7fffffffU, 0x80000000U}) {
      EXPECT_EQ(Integer(ulps<Wide>(word, fraction_bits)), ulps(word, fraction_bits)) << word;
    }
  }
}

TEST(OracleWord, FitsAtTheEdgesOfTheRange) {
  EXPECT_TRUE(fits(32767, 8));
  EXPECT_FALSE(fits(32768, 8));
  EXPECT_TRUE(fits(-32768, 8));
  EXPECT_FALSE(fits(-32769, 8));
}

TEST(OracleWord, SaturateStopsAtTheEdgesOfTheRange) {
  EXPECT_EQ(saturate(32767, 8), 0x7fffU);
  EXPECT_EQ(saturate(32768, 8), 0x7fffU);
  EXPECT_EQ(saturate(-32768, 8), 0x8000U);
  EXPECT_EQ(saturate(-32769, 8), 0x8000U);
  EXPECT_EQ(saturate(Integer(1) << 90, 16), 0x7fffffffU);
  EXPECT_EQ(saturate(-(Integer(1) << 90), 16), 0x80000000U);
  EXPECT_EQ(saturate(-7, 16), 0xfffffff9U);
}

TEST(OracleWord, WidthsOutsideTheRangeAreRefused) {
  for (const int bits : {-1, 0, 65}) {
    const Format format(bits, 0, true);
    EXPECT_THROW((void)wrap(0, format), std::invalid_argument) << bits;
    EXPECT_THROW((void)fits(0, format), std::invalid_argument) << bits;
    EXPECT_THROW((void)saturate(0, format), std::invalid_argument) << bits;
  }
}

}  // namespace
}  // namespace oracle

#include "oracle/decimal.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/oracle/rules.hpp"
#include "tests/support/test.hpp"

namespace oracle {
namespace {

TEST(OracleFromDecimal, ExactTextsNeedNoRule) {
  for (const Rounding rule : test::kRoundings) {
    EXPECT_EQ(from_decimal("1.5", rule, 16), 0x18000);
    EXPECT_EQ(from_decimal("-1.5", rule, 16), -0x18000);
    EXPECT_EQ(from_decimal("+1", rule, 8), 0x100);
    EXPECT_EQ(from_decimal("5.", rule, 16), 0x50000);
    EXPECT_EQ(from_decimal("-.5", rule, 16), -0x8000);
    EXPECT_EQ(from_decimal("-0", rule, 16), 0);
  }
}

TEST(OracleFromDecimal, RoundsOnce) {
  EXPECT_EQ(from_decimal("0.1", Rounding::half_up, 16), 6554);  // 6553.6
  EXPECT_EQ(from_decimal("0.1", Rounding::truncate, 16), 6553);
  EXPECT_EQ(from_decimal("-0.1", Rounding::floor, 16), -6554);
  const std::string half = "0.00000762939453125";  // 2^-17
  EXPECT_EQ(from_decimal(half, Rounding::half_up, 16), 1);
  EXPECT_EQ(from_decimal(half, Rounding::floor, 16), 0);
  EXPECT_EQ(from_decimal("-" + half, Rounding::half_up, 16), 0);
  EXPECT_EQ(from_decimal("-" + half, Rounding::half_away, 16), -1);
  EXPECT_EQ(from_decimal("-" + half + std::string(200, '0') + "1", Rounding::half_up, 16), -1);
}

TEST(OracleFromDecimal, HasNoLargestNumber) {
  EXPECT_EQ(from_decimal("1" + std::string(30, '0'), Rounding::floor, 16),
            Integer("65536" + std::string(30, '0')));
}

TEST(OracleFromDecimal, RefusesWhatIsNoNumber) {
  for (const char* text : {"", "+", "-", ".", "-.", "1e3", " 1", "1 ", "1.2.3", "--1", "+-1", "1-",
                           "0x1", "1,5", "nan"}) {
    EXPECT_EQ(from_decimal(text, Rounding::floor, 16), std::nullopt) << text;
  }
}

TEST(OracleFromDouble, RoundsOnce) {
  EXPECT_EQ(from_double(-1.0, Rounding::half_up, 16), -65536);
  EXPECT_EQ(from_double(0.1, Rounding::half_away, 16), 6554);
  EXPECT_EQ(from_double(0x1p-17, Rounding::half_up, 16), 1);
  EXPECT_EQ(from_double(-0x1p-17, Rounding::half_up, 16), 0);
  EXPECT_EQ(from_double(-0x1p-17, Rounding::half_away, 16), -1);
  // The significand's last bit beyond a half.
  EXPECT_EQ(from_double(-0x1.0000000000001p-17, Rounding::half_up, 16), -1);
  EXPECT_EQ(from_double(-0.0, Rounding::floor, 16), 0);
}

TEST(OracleFromDouble, TakesEveryFiniteDouble) {
  using Limits = std::numeric_limits<double>;
  EXPECT_EQ(from_double(0x1p1023, Rounding::floor, 16), Integer(1) << 1039);
  EXPECT_EQ(from_double(Limits::denorm_min(), Rounding::floor, 16), 0);
  EXPECT_EQ(from_double(-Limits::denorm_min(), Rounding::floor, 16), -1);
  EXPECT_EQ(from_double(Limits::infinity(), Rounding::floor, 16), std::nullopt);
  EXPECT_EQ(from_double(-Limits::infinity(), Rounding::floor, 16), std::nullopt);
  EXPECT_EQ(from_double(Limits::quiet_NaN(), Rounding::floor, 16), std::nullopt);
}

TEST(OracleToDecimal, IsExact) {
  EXPECT_EQ(to_decimal(0, 16), "0");
  EXPECT_EQ(to_decimal(0x18000, 16), "1.5");
  EXPECT_EQ(to_decimal(1, 16), "0.0000152587890625");
  EXPECT_EQ(to_decimal(0xffffffff, 16), "-0.0000152587890625");
  EXPECT_EQ(to_decimal(0x7fffffff, 16), "32767.9999847412109375");
  EXPECT_EQ(to_decimal(0x80000000, 16), "-32768");
  EXPECT_EQ(to_decimal(0xffff, 8), "-0.00390625");
}

TEST(OracleDecimal, FormatsOutsideTheRangeAreRefused) {
  EXPECT_THROW((void)from_decimal("1", Rounding::floor, 17), std::invalid_argument);
  EXPECT_THROW((void)from_double(1.0, Rounding::floor, 1), std::invalid_argument);
  EXPECT_THROW((void)to_decimal(1, 0), std::invalid_argument);
}

RC_GTEST_PROP(OracleDecimal, TextReadBackIsTheWord, (Word word)) {
  for (const Rounding rule : test::kRoundings) {
    RC_ASSERT(from_decimal(to_decimal(word, 16), rule, 16) == ulps(word, 16));
  }
}

RC_GTEST_PROP(OracleDecimal, ADoubleOfAWordIsTheWord, (Word word)) {
  const double value = static_cast<double>(static_cast<std::int32_t>(word)) / 65536;
  for (const Rounding rule : test::kRoundings) {
    RC_ASSERT(from_double(value, rule, 16) == ulps(word, 16));
  }
}

}  // namespace
}  // namespace oracle

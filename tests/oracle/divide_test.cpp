#include "oracle/exact.hpp"
#include "oracle/format.hpp"
#include "tests/oracle/rules.hpp"
#include "tests/support/test.hpp"
#include "tests/support/worked.hpp"

namespace oracle {
namespace {

void expect_div(const worked::Row& row, int fraction_bits) {
  const std::array results{row.i386_on, row.i386_off, row.i8088_on, row.i8088_off};
  for (const DivideRule rule : test::kDivideRules) {
    const auto index = static_cast<std::size_t>(rule);
    EXPECT_EQ(div(row.a, row.b, rule, fraction_bits), results.at(index))
        << std::hex << row.a << " / " << row.b << ", rule " << index;
  }
}

TEST(OracleDiv, AsWorkedByHand) {
  for (const worked::Row& row : worked::quotients) expect_div(row, 16);
  for (const worked::Row& row : worked::half_quotients) expect_div(row, 8);
}

TEST(OracleQuotient, FollowsTheRuleAndFaultsAtZeroAlone) {
  EXPECT_EQ(quotient(0xffffffff, 0x20000, Rounding::half_up, 16), 0U);
  EXPECT_EQ(quotient(0xffffffff, 0x20000, Rounding::half_away, 16), 0xffffffffU);
  EXPECT_EQ(quotient(0xffffffff, 0x20000, Rounding::floor, 16), 0xffffffffU);
  EXPECT_EQ(quotient(0xffffffff, 0x20000, Rounding::truncate, 16), 0U);
  EXPECT_EQ(quotient(0x10000, 1, Rounding::floor, 16), 0U);
  EXPECT_EQ(quotient(0, 0, Rounding::floor, 16), std::nullopt);
}

TEST(OracleQuotient, UnboundedKeepsEveryDigit) {
  EXPECT_EQ(exact_quotient(0x7fffffff, 1, Rounding::floor, 16), Integer("140737488289792"));
  EXPECT_EQ(exact_quotient(0x80000000, 1, Rounding::floor, 16), -(Integer(1) << 47));
  EXPECT_EQ(exact_quotient(1, 0, Rounding::floor, 16), std::nullopt);
}

}  // namespace
}  // namespace oracle

#include "oracle/exact.hpp"
#include "oracle/format.hpp"
#include "tests/oracle/rules.hpp"
#include "tests/support/test.hpp"
#include "tests/support/worked.hpp"

namespace oracle {
namespace {

constexpr Word kHalf = 0x00008000;
constexpr Word kMinusHalf = 0xffff8000;
constexpr Word kMinusOne = 0xffff0000;
constexpr Word kMost = 0x7fffffff;
constexpr Word kLeast = 0x80000000;

struct ProductsByRule {
  Word half_up;
  Word half_away;
  Word floor;
  Word truncate;
  Word half_even;
  Word ceiling;

  [[nodiscard]] Word of(Rounding rule) const {
    return std::array{half_up, half_away, floor, truncate, half_even, ceiling}.at(
        static_cast<std::size_t>(rule));
  }
};

void expect_mul(Word a, Word b, const ProductsByRule& expected) {
  for (const Rounding rule : test::kRoundings) {
    EXPECT_EQ(mul(a, b, rule, 16), expected.of(rule))
        << std::hex << a << " * " << b << ", rule " << static_cast<int>(rule);
  }
}

TEST(OracleAdd, SumsAndDifferencesWrap) {
  EXPECT_EQ(add(0x18000, kMinusHalf, 16), 0x10000U);
  EXPECT_EQ(sub(0x18000, kMinusHalf, 16), 0x20000U);
  EXPECT_EQ(add(kMost, 1, 16), kLeast);
  EXPECT_EQ(add(kLeast, kLeast, 16), 0U);
  EXPECT_EQ(sub(kLeast, 1, 16), kMost);
  EXPECT_EQ(sub(0, kLeast, 16), kLeast);
  EXPECT_EQ(add(0x7fff, 1, 8), 0x8000U);
  EXPECT_EQ(sub(0, 1, 8), 0xffffU);
}

TEST(OracleMul, ExactProductsNeedNoRule) {
  expect_mul(0x18000, 0x18000, {0x24000, 0x24000, 0x24000, 0x24000, 0x24000, 0x24000});
  expect_mul(kMinusOne, 0x18000,
             {0xfffe8000, 0xfffe8000, 0xfffe8000, 0xfffe8000, 0xfffe8000, 0xfffe8000});
}

TEST(OracleMul, HalvesOfAnUlp) {
  expect_mul(kHalf, 1, {1, 1, 0, 0, 0, 1});
  expect_mul(kHalf, 3, {2, 2, 1, 1, 2, 2});
  expect_mul(kMinusHalf, 1, {0, 0xffffffff, 0xffffffff, 0, 0, 0});
  expect_mul(kMinusHalf, 3,
             {0xffffffff, 0xfffffffe, 0xfffffffe, 0xffffffff, 0xfffffffe, 0xffffffff});
  expect_mul(kMinusHalf, 0xffffffff, {1, 1, 0, 0, 0, 1});
}

TEST(OracleMul, OneUnitBesideAHalf) {
  expect_mul(0x7fff, 1, {0, 0, 0, 0, 0, 1});
  expect_mul(0x8001, 1, {1, 1, 0, 0, 1, 1});
  expect_mul(0xffff8001, 1, {0, 0, 0xffffffff, 0, 0, 0});
  expect_mul(0xffff7fff, 1, {0xffffffff, 0xffffffff, 0xffffffff, 0, 0xffffffff, 0});
}

TEST(OracleMul, WrapsWhereItDoesNotFit) {
  expect_mul(kLeast, kLeast, {0, 0, 0, 0, 0, 0});
  expect_mul(kLeast, kMinusOne, {kLeast, kLeast, kLeast, kLeast, kLeast, kLeast});
  EXPECT_EQ(exact_product(kLeast, kLeast, Rounding::floor, 16), Integer(1) << 46);
  EXPECT_EQ(exact_product(kLeast, kMinusOne, Rounding::floor, 16), Integer(1) << 31);
}

void expect_worked(const worked::Row& row, int bits) {
  EXPECT_EQ(mul(row.a, row.b, Rounding::half_up, bits), row.i386_on) << row.a << ' ' << row.b;
  EXPECT_EQ(mul(row.a, row.b, Rounding::floor, bits), row.i386_off) << row.a << ' ' << row.b;
  EXPECT_EQ(mul(row.a, row.b, Rounding::half_away, bits), row.i8088_on) << row.a << ' ' << row.b;
  EXPECT_EQ(mul(row.a, row.b, Rounding::truncate, bits), row.i8088_off) << row.a << ' ' << row.b;
}

TEST(OracleMul, AsWorkedByHand) {
  for (const worked::Row& row : worked::products) expect_worked(row, 16);
  for (const worked::Row& row : worked::half_products) expect_worked(row, 8);
}

TEST(OracleMulAdd, RoundsOnce) {
  // 1/2 ulp - 1 ulp. Rounding the product first would give 0, 0, -1, -1.
  EXPECT_EQ(mul_add(kHalf, 1, 0xffffffff, Rounding::half_up, 16), 0U);
  EXPECT_EQ(mul_add(kHalf, 1, 0xffffffff, Rounding::half_away, 16), 0xffffffffU);
  EXPECT_EQ(mul_add(kHalf, 1, 0xffffffff, Rounding::floor, 16), 0xffffffffU);
  EXPECT_EQ(mul_add(kHalf, 1, 0xffffffff, Rounding::truncate, 16), 0U);
  EXPECT_EQ(exact_mul_add(kLeast, kLeast, kMost, Rounding::floor, 16),
            (Integer(1) << 46) + 0x7fffffff);
}

TEST(OracleDot, RoundsOnce) {
  const std::array<Word, 2> halves{kHalf, kHalf};
  const std::array<Word, 2> units{1, 1};
  for (const Rounding rule : test::kRoundings) EXPECT_EQ(dot(halves, units, rule, 16), 1U);
  const std::array<Word, 3> least{kLeast, kLeast, kLeast};
  EXPECT_EQ(exact_dot(least, least, Rounding::floor, 16), 3 * (Integer(1) << 46));
  EXPECT_EQ(dot({}, {}, Rounding::floor, 16), 0U);
}

TEST(OracleDot, NeedsVectorsOfOneLength) {
  const std::array<Word, 1> one{1};
  EXPECT_THROW((void)dot(one, {}, Rounding::floor, 16), std::invalid_argument);
}

TEST(OracleLerp, RoundsOnceAndKeepsTheWholeDifference) {
  // Halfway between the extremes lies -1/2 ulp, and their difference has 33 bits.
  EXPECT_EQ(lerp(kLeast, kMost, kHalf, Rounding::half_up, 16), 0U);
  EXPECT_EQ(lerp(kLeast, kMost, kHalf, Rounding::half_away, 16), 0xffffffffU);
  EXPECT_EQ(lerp(kLeast, kMost, kHalf, Rounding::floor, 16), 0xffffffffU);
  EXPECT_EQ(lerp(kLeast, kMost, kHalf, Rounding::truncate, 16), 0U);
}

TEST(OracleLerp, MeetsBothEnds) {
  EXPECT_EQ(lerp(kLeast, kMost, 0, Rounding::half_up, 16), kLeast);
  EXPECT_EQ(lerp(kLeast, kMost, 0x10000, Rounding::half_up, 16), kMost);
  EXPECT_EQ(exact_lerp(kLeast, kMost, 0x20000, Rounding::floor, 16), Integer(kMost) + 0xffffffffLL);
}

TEST(OracleSqrt, IsTheNearestRoot) {
  EXPECT_EQ(sqrt(0x40000, 16), 0x20000U);
  EXPECT_EQ(sqrt(0x20000, 16), 0x16a0aU);   // 92681.90
  EXPECT_EQ(sqrt(0xa0000, 16), 0x3298bU);   // 207243.03
  EXPECT_EQ(sqrt(kMost, 16), 0x00b504f3U);  // 11863283.20
  EXPECT_EQ(sqrt(1, 16), 0x100U);
  EXPECT_EQ(sqrt(0, 16), 0U);
  EXPECT_EQ(sqrt(0x200, 8), 0x16aU);  // 362.04
}

TEST(OracleSqrt, AlsoGoesDown) {
  for (const Rounding rule : {Rounding::floor, Rounding::truncate}) {
    EXPECT_EQ(exact_root(0x20000, rule, 16), 92681);   // .90
    EXPECT_EQ(exact_root(0xa0000, rule, 16), 207243);  // .03
    EXPECT_EQ(exact_root(0x40000, rule, 16), 0x20000);
  }
  EXPECT_EQ(exact_root(0x20000, Rounding::half_even, 16), 92682);
}

TEST(OracleSqrt, HasNoNegativeOperand) {
  EXPECT_EQ(sqrt(0xffffffff, 16), std::nullopt);
  EXPECT_EQ(sqrt(kLeast, 16), std::nullopt);
  EXPECT_EQ(sqrt(0x8000, 8), std::nullopt);
}

TEST(OracleFormat, OutsideTheRangeIsRefused) {
  constexpr int kHuge = std::numeric_limits<int>::max();
  for (const int fraction_bits : {-1, 0, 1, 17, kHuge}) {
    EXPECT_THROW((void)mul(1, 1, Rounding::floor, fraction_bits), std::invalid_argument);
    EXPECT_THROW((void)sqrt(1, fraction_bits), std::invalid_argument);
    EXPECT_THROW((void)dot({}, {}, Rounding::floor, fraction_bits), std::invalid_argument);
    for (const DivideRule rule : test::kDivideRules) {
      EXPECT_THROW((void)div(1, 1, rule, fraction_bits), std::invalid_argument);
    }
  }
}

}  // namespace
}  // namespace oracle

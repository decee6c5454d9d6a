#include "oracle/exact.hpp"
#include "tests/support/test.hpp"

namespace oracle {
namespace {

Word negated(Word word) { return ~word + 1; }

TEST(OracleCosineTable, Has901EntriesFromOneToZero) {
  const std::vector<Word> table = cosine_table(10);
  ASSERT_EQ(table.size(), 901U);
  EXPECT_EQ(table.front(), 0x10000U);
  EXPECT_EQ(table[1], 0x10000U);   // 65535.90
  EXPECT_EQ(table[241], 0xe9b0U);  // 59823.5006, the entry nearest to a half
  EXPECT_EQ(table[300], 0xddb4U);  // 56755.84
  EXPECT_EQ(table[450], 0xb505U);  // 46340.95
  EXPECT_EQ(table[600], 0x8000U);  // 32768 exactly
  EXPECT_EQ(table.back(), 0U);
}

TEST(OracleCosineTable, EveryEntryIsTheNearest) {
  // A 64-bit significand keeps the error below 1e-14 ulp. No entry is within 5e-4 of a half, so
  // long double decides every entry.
  static_assert(std::numeric_limits<long double>::digits >= 64);
  const std::vector<Word> table = cosine_table(10);
  ASSERT_EQ(table.size(), 901U);
  int nearly_halves = 0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto angle = static_cast<long double>(i) * std::numbers::pi_v<long double> / 1800;
    const long double exact = std::cos(angle) * 65536;
    EXPECT_EQ(static_cast<long double>(table[i]), std::round(exact)) << i;
    const long double to_half = std::abs(exact - std::floor(exact) - 0.5L);
    EXPECT_GT(to_half, 0.0005L) << i;
    if (to_half < 0.00065L) ++nearly_halves;
  }
  EXPECT_EQ(nearly_halves, 1);
}

TEST(OracleCosineTable, TakesAnyNumberOfStepsAndFormat) {
  const std::vector<Word> fine = cosine_table(10);
  const std::vector<Word> coarse = cosine_table(1);
  ASSERT_EQ(coarse.size(), 91U);
  for (std::size_t i = 0; i < coarse.size(); ++i) EXPECT_EQ(coarse[i], fine[10 * i]) << i;
  const std::vector<Word> half_width = cosine_table(1, 8);
  ASSERT_EQ(half_width.size(), 91U);
  EXPECT_EQ(half_width[0], 0x100U);
  EXPECT_EQ(half_width[45], 0xb5U);  // 181.02
  EXPECT_EQ(half_width[60], 0x80U);
  EXPECT_EQ(half_width[90], 0U);
}

TEST(OracleCosineTable, RefusesWhatIsNoTable) {
  EXPECT_THROW((void)cosine_table(0), std::invalid_argument);
  EXPECT_THROW((void)cosine_table(-10), std::invalid_argument);
  EXPECT_THROW((void)cosine_table(1, 17), std::invalid_argument);
}

TEST(OracleCosSin, TheQuartersOfATurnAreExact) {
  EXPECT_EQ(cos_sin(0), (CosSin{0x10000, 0}));
  EXPECT_EQ(cos_sin(900), (CosSin{0, 0x10000}));
  EXPECT_EQ(cos_sin(1800), (CosSin{0xffff0000, 0}));
  EXPECT_EQ(cos_sin(2700), (CosSin{0, 0xffff0000}));
  EXPECT_EQ(cos_sin(3600), (CosSin{0x10000, 0}));
  EXPECT_EQ(cos_sin(-900), (CosSin{0, 0xffff0000}));
  EXPECT_EQ(cos_sin(300), (CosSin{0xddb4, 0x8000}));
  EXPECT_EQ(cos_sin(-300), (CosSin{0xddb4, 0xffff8000}));
}

TEST(OracleCosSin, EveryAngleFollowsFromTheQuarterTable) {
  const std::vector<Word> table = cosine_table(10);
  const auto folded = [&](int tenths) {
    const auto angle = static_cast<std::size_t>((tenths % 3600 + 3600) % 3600);
    if (angle <= 900) return table[angle];
    if (angle <= 1800) return negated(table[1800 - angle]);
    if (angle <= 2700) return negated(table[angle - 1800]);
    return table[3600 - angle];
  };
  for (int tenths = INT16_MIN; tenths <= INT16_MAX; ++tenths) {
    const CosSin expected{folded(tenths), folded(tenths - 900)};
    ASSERT_EQ(cos_sin(static_cast<std::int16_t>(tenths)), expected) << tenths;
  }
}

}  // namespace
}  // namespace oracle

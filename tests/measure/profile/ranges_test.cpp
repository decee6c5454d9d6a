// Tests bits of values and results outside 16.16 against the oracle's unbounded results.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "measure/trade/profile/places.hpp"
#include "measure/trade/profile/value_range.hpp"
#include "measure/trade/profile/wraps.hpp"
#include "oracle/format.hpp"
#include "tests/support/test.hpp"

namespace fixproof {
namespace {

using oracle::Integer;
using oracle::Rounding;
using Word = std::uint32_t;

TEST(ValueRange, CountsTheSignAmongTheBits) {
  EXPECT_EQ(trade::signed_bits(0), 1);
  EXPECT_EQ(trade::signed_bits(-1), 1);
  EXPECT_EQ(trade::signed_bits(1), 2);
  EXPECT_EQ(trade::signed_bits(-2), 2);
  EXPECT_EQ(trade::signed_bits(32767), 16);
  EXPECT_EQ(trade::signed_bits(-32768), 16);
  EXPECT_EQ(trade::signed_bits(32768), 17);
  EXPECT_EQ(trade::signed_bits(-2147483648LL), 32);
  trade::ValueRange range;
  EXPECT_TRUE(range.empty());
  EXPECT_EQ(range.bits(), 0);
  range.add(3);
  range.add(-9);
  EXPECT_EQ(range.least(), -9);
  EXPECT_EQ(range.greatest(), 3);
  EXPECT_EQ(range.bits(), 5);
}

TEST(Places, EveryWordHasAName) {
  for (int i = 0; i < 5; ++i) {
    const auto operation = static_cast<cases::Operation>(i);
    std::array<int, 4> seen{};
    for (std::size_t w = 0; w < cases::words_in(operation); ++w)
      ++seen.at(trade::operand_place(operation, w));
    for (std::size_t n = 0; n < seen.size(); ++n) {
      EXPECT_EQ(seen.at(n) > 0, n < trade::operand_names(operation).size());
    }
    for (std::size_t w = 0; w < cases::words_out(operation); ++w) {
      EXPECT_LT(trade::result_place(operation, w), trade::result_names(operation).size());
    }
  }
  // Row by row: the fourth word of each row belongs to the translation.
  const auto name = [](std::size_t word) {
    return trade::operand_names(
        cases::Operation::concat)[trade::operand_place(cases::Operation::concat, word)];
  };
  EXPECT_EQ(name(11), "first translation");
  EXPECT_EQ(name(12), "second matrix");
}

TEST(Wraps, AtTheEndsOfTheRange) {
  const auto product_wraps = [](Word a, Word b) {
    const std::array in{a, b};
    return trade::wraps(cases::Variant{}, in);
  };
  EXPECT_TRUE(product_wraps(0x40000000, 0x00020000));   // 16384 * 2
  EXPECT_FALSE(product_wraps(0xC0000000, 0x00020000));  // -16384 * 2
  EXPECT_FALSE(product_wraps(0x7FFFFFFF, 0x00010000));
  EXPECT_TRUE(product_wraps(0x7FFFFFFF, 0x00010001));
  EXPECT_FALSE(product_wraps(0, 0x80000000));
}

// 2351 * 4513 * 13264529 is 2^47 - 1, which truncates to the largest word and rounds to 2^31. -2^15
// * 641 * 6700417 is -2^47 - 2^15, half a unit below the smallest word.
TEST(Wraps, WhereRoundingDecides) {
  const std::array<Word, 2> above{2351 * 4513, 13264529};
  const std::array<Word, 2> below{0U - 32768 * 641, 6700417};
  const auto mul = [](cases::Target target, bool rounds) {
    return cases::Variant{.build = {.target = target, .mul_round = rounds}};
  };
  for (const cases::Target target : {cases::Target::i386, cases::Target::i8088}) {
    EXPECT_TRUE(trade::wraps(mul(target, true), above));
    EXPECT_FALSE(trade::wraps(mul(target, false), above));
  }
  EXPECT_FALSE(trade::wraps(mul(cases::Target::i386, true), below));    // half up
  EXPECT_TRUE(trade::wraps(mul(cases::Target::i386, false), below));    // floor
  EXPECT_TRUE(trade::wraps(mul(cases::Target::i8088, true), below));    // half away from zero
  EXPECT_FALSE(trade::wraps(mul(cases::Target::i8088, false), below));  // truncation
}

// Translations of 20000 and 20000 with identity matrices: only their sum is out of range.
TEST(Wraps, WhereTheTranslationDecides) {
  constexpr Word unit = 65536;
  std::array<Word, 24> concat{};
  for (const std::size_t i : {0U, 5U, 10U, 12U, 17U, 22U}) concat.at(i) = unit;
  const cases::Variant concatenation{.operation = cases::Operation::concat};
  const cases::Variant transform{.operation = cases::Operation::xformvec};
  for (std::size_t row = 0; row < 3; ++row) {
    auto in = concat;
    in.at(4 * row + 3) = 20000 * unit;
    EXPECT_FALSE(trade::wraps(concatenation, in));
    in.at(12 + 4 * row + 3) = 20000 * unit;
    EXPECT_TRUE(trade::wraps(concatenation, in));
    std::array<Word, 15> vector{};
    std::copy_n(in.begin(), 12, vector.begin());
    EXPECT_FALSE(trade::wraps(transform, vector));
    vector.at(12 + row) = 20000 * unit;
    EXPECT_TRUE(trade::wraps(transform, vector));
  }
}

Rounding product_rule(const cases::Variant& v) {
  if (v.build.target == cases::Target::i386)
    return v.build.mul_round ? Rounding::half_up : Rounding::floor;
  return v.build.mul_round ? Rounding::half_away : Rounding::truncate;
}

cases::Variant any_variant(cases::Operation operation) {
  return {.operation = operation,
          .build = {.target = *rc::gen::element(cases::Target::i386, cases::Target::i8088),
                    .mul_round = *rc::gen::arbitrary<bool>(),
                    .div_round = *rc::gen::arbitrary<bool>()}};
}

/// A word of any magnitude and either sign, so that some results fit and some do not.
Word any_word(int least_shift) {
  const Word word = *rc::gen::arbitrary<Word>() >> *rc::gen::inRange(least_shift, 22);
  return *rc::gen::arbitrary<bool>() ? 0U - word : word;
}

RC_GTEST_PROP(Wraps, ProductsAsTheOracleHasThem, ()) {
  const cases::Variant v = any_variant(cases::Operation::mul);
  const std::array in{any_word(0), any_word(0)};
  RC_ASSERT(trade::wraps(v, in) ==
            !oracle::fits(oracle::exact_product(in[0], in[1], product_rule(v), 16), 16));
}

RC_GTEST_PROP(Wraps, QuotientsAsTheOracleHasThem, ()) {
  const cases::Variant v = any_variant(cases::Operation::div);
  const std::array in{any_word(0), any_word(0)};
  Word divisor = in[1];
  if (v.build.target == cases::Target::i8088) {
    const bool negative = divisor >> 31 != 0;
    const Word whole = (negative ? 0U - divisor : divisor) & 0xFFFF0000U;
    divisor = negative ? 0U - whole : whole;
  }
  RC_PRE(divisor != 0U);
  const Rounding rule = v.build.div_round ? Rounding::half_away : Rounding::truncate;
  RC_ASSERT(trade::wraps(v, in) ==
            !oracle::fits(*oracle::exact_quotient(in[0], divisor, rule, 16), 16));
}

RC_GTEST_PROP(Wraps, TransformsAsTheOracleHasThem, ()) {
  const cases::Variant v = any_variant(cases::Operation::xformvec);
  std::array<Word, 15> in{};
  for (Word& word : in) word = any_word(4);
  bool expected = false;
  for (std::size_t i = 0; i < 3; ++i) {
    Integer sum = oracle::ulps(in.at(4 * i + 3), 16);
    for (std::size_t j = 0; j < 3; ++j) {
      sum += oracle::exact_product(in.at(4 * i + j), in.at(12 + j), product_rule(v), 16);
    }
    expected = expected || !oracle::fits(sum, 16);
  }
  RC_ASSERT(trade::wraps(v, in) == expected);
}

/// Adds as the printed 8088 ConcatXforms does: integer parts, and fractions without a carry.
Integer sum_in_parts(const Integer& a, const Integer& b) {
  const Integer whole = 65536;
  const auto fraction = [&](const Integer& n) -> Integer { return (n % whole + whole) % whole; };
  return a - fraction(a) + b - fraction(b) + fraction(fraction(a) + fraction(b));
}

RC_GTEST_PROP(Wraps, ConcatenationsAsTheOracleHasThem, ()) {
  cases::Variant v = any_variant(cases::Operation::concat);
  v.build.repaired = v.build.target == cases::Target::i8088 && *rc::gen::arbitrary<bool>();
  std::array<Word, 24> in{};
  for (Word& word : in) word = any_word(6);
  bool expected = false;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      Integer sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        sum += oracle::exact_product(in.at(4 * i + k), in.at(12 + 4 * k + j), product_rule(v), 16);
      }
      if (j == 3) {
        const Integer moved = oracle::ulps(in.at(4 * i + 3), 16);
        const bool whole = v.build.target == cases::Target::i386 || v.build.repaired;
        sum = whole ? sum + moved : sum_in_parts(sum, moved);
      }
      expected = expected || !oracle::fits(sum, 16);
    }
  }
  RC_ASSERT(trade::wraps(v, in) == expected);
}

}  // namespace
}  // namespace fixproof

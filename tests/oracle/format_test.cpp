// The exact results in formats other than 2F bits, against the definition in built-in integers of 8
// bits and against the oracle of 16.16.
#include "oracle/format.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "oracle/fast.hpp"

namespace {

using oracle::Format;
using oracle::Integer;
using oracle::LongWord;
using oracle::Rounding;

int value_of(unsigned word, const Format& format) {
  const int value = static_cast<int>(word);
  return format.is_signed && value > 127 ? value - 256 : value;
}

/// n / d rounded by the definition of each rule. Exact: the operands have at most 16 bits.
double nearest(double n, double d, Rounding rule) {
  const double exact = n / d;
  switch (rule) {
    case Rounding::half_up:
      return std::floor(exact + 0.5);
    case Rounding::half_away:
      return std::round(exact);
    case Rounding::half_even:
      return std::nearbyint(exact);
    case Rounding::floor:
      return std::floor(exact);
    case Rounding::ceiling:
      return std::ceil(exact);
    case Rounding::truncate:
      break;
  }
  return std::trunc(exact);
}

constexpr Rounding rules[] = {Rounding::half_up, Rounding::half_away, Rounding::half_even,
                              Rounding::floor,   Rounding::truncate,  Rounding::ceiling};

TEST(OracleFormat, EveryPairOfBytes) {
  for (const Format& format : {Format{8, 4, true}, Format{8, 7, true}, Format{8, 0, true},
                               Format{8, 4, false}, Format{8, 8, false}}) {
    const double one = std::ldexp(1, format.fraction_bits);
    for (const Rounding rule : rules) {
      for (unsigned a = 0; a < 256; ++a) {
        for (unsigned b = 0; b < 256; ++b) {
          const double x = value_of(a, format);
          const double y = value_of(b, format);
          ASSERT_EQ(oracle::exact_product(a, b, rule, format), Integer(nearest(x * y, one, rule)));
          const auto quotient = oracle::exact_quotient(a, b, rule, format);
          ASSERT_EQ(quotient.has_value(), b != 0);
          if (quotient) {
            ASSERT_EQ(*quotient, Integer(nearest(x * one, y, rule)));
          }
        }
        const auto root = oracle::exact_root(a, rule, format);
        const double x = value_of(a, format);
        ASSERT_EQ(root.has_value(), x >= 0);
        if (root) {
          ASSERT_EQ(*root, Integer(nearest(std::sqrt(x * one), 1, rule)));
        }
      }
    }
  }
}

TEST(OracleFormat, WordsOfEachWidth) {
  const Format narrow{8, 4, true};
  EXPECT_EQ(oracle::ulps(0x1ff, narrow), -1);
  EXPECT_EQ(oracle::wrap(Integer(-129), narrow), 0x7fU);
  EXPECT_EQ(oracle::wrap(Integer(-256), narrow), 0U);
  EXPECT_EQ(oracle::saturate(Integer(-129), narrow), 0x80U);
  EXPECT_EQ(oracle::saturate(Integer(128), narrow), 0x7fU);
  EXPECT_TRUE(oracle::fits(Integer(-128), narrow));
  EXPECT_FALSE(oracle::fits(Integer(128), narrow));
  const Format wide{64, 32, false};
  EXPECT_EQ(oracle::ulps(~LongWord{0}, wide), (Integer(1) << 64) - 1);
  EXPECT_EQ(oracle::wrap(Integer(-1), wide), ~LongWord{0});
  EXPECT_EQ(oracle::saturate(Integer(-1), wide), 0U);
  EXPECT_EQ(oracle::saturate(Integer(1) << 64, wide), ~LongWord{0});
  EXPECT_EQ(oracle::lowest({64, 63, true}), -(Integer(1) << 63));
  EXPECT_THROW(static_cast<void>(oracle::lowest({65, 3, true})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(oracle::wrap(1, {0, 0, true})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(oracle::one({8, 9, true})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(oracle::exact_product(1, 1, Rounding::floor, {8, -1, true})),
               std::invalid_argument);
  // The words of a format do not depend on their unit.
  EXPECT_EQ(oracle::wrap(257, {8, 9, true}), 1U);
}

TEST(OracleFormat, ConversionRoundsOnce) {
  const Format from{32, 16, true};
  const Format to{8, 4, true};
  // 0x18800 is 1.53125, which is 24.5 sixteenths.
  EXPECT_EQ(oracle::converted(0x18800, from, to, Rounding::half_up), 25);
  EXPECT_EQ(oracle::converted(0x18800, from, to, Rounding::half_even), 24);
  EXPECT_EQ(oracle::converted(-0x18800, from, to, Rounding::half_up), -24);
  EXPECT_EQ(oracle::converted(24, to, from, Rounding::floor), 0x18000);
}

TEST(OracleFormat, AFractionNamesTheFormatOfTheListings) {
  for (int fraction = 2; fraction <= 16; ++fraction) {
    const Format format = fraction;
    EXPECT_EQ(format.bits, 2 * fraction);
    EXPECT_EQ(format.fraction_bits, fraction);
    EXPECT_TRUE(format.is_signed);
  }
}

// A right guess, one below the root, and any other, at the words where the root steps.
TEST(OracleFormat, FastRootsDoNotDependOnTheGuess) {
  for (const Format format : {Format{32, 30, true}, Format{32, 32, false}, Format{16, 3, false}}) {
    for (std::uint64_t r = 1; r < std::uint64_t{1} << format.bits; r = r * 5 / 4 + 1) {
      for (const std::uint64_t n : {r * r - r, r * r, r * r + r}) {
        const LongWord first = n >> format.fraction_bits;
        for (LongWord word = first; word <= first + 1 && word >> format.bits == 0; ++word) {
          const auto exact = oracle::exact_root(word, Rounding::half_up, format);
          for (LongWord guess : {r - 1, r, r + 1, LongWord{0}, ~LongWord{0}}) {
            const auto root = oracle::fast::sqrt(word, format, guess);
            ASSERT_EQ(root.has_value(), exact.has_value());
            if (!exact) continue;
            ASSERT_EQ(Integer(*root), *exact) << word;
            ASSERT_EQ(guess, *root);
          }
        }
      }
    }
  }
}

}  // namespace

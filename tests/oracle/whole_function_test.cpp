// Tests remainders, the quotient of a product and lengths by their definitions, in built-in
// integers and doubles that hold every result of bytes.
#include "oracle/whole_function.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "oracle/fast.hpp"

namespace {

using oracle::Format;
using oracle::Integer;
using oracle::LongWord;
using oracle::Rounding;

constexpr Format byte_formats[] = {{8, 4, true}, {8, 0, true}, {8, 8, false}};

int byte_value(unsigned word, const Format& format) {
  const int value = static_cast<int>(word);
  return format.is_signed && value > 127 ? value - 256 : value;
}

TEST(OracleWholeFunctions, RemaindersOfEveryPairOfBytes) {
  for (const Format& format : byte_formats) {
    for (unsigned a = 0; a < 256; ++a) {
      for (unsigned b = 0; b < 256; ++b) {
        const int n = byte_value(a, format);
        const int d = byte_value(b, format);
        const auto truncated = oracle::truncated_remainder(n, d);
        const auto nearest = oracle::nearest_remainder(n, d);
        const auto fast_truncated = oracle::fast::truncated_remainder(a, b, format);
        const auto fast_nearest = oracle::fast::nearest_remainder(a, b, format);
        ASSERT_EQ(truncated.has_value(), d != 0);
        ASSERT_EQ(nearest.has_value(), d != 0);
        ASSERT_EQ(fast_truncated.has_value(), d != 0);
        ASSERT_EQ(fast_nearest.has_value(), d != 0);
        if (d == 0) continue;
        ASSERT_EQ(*truncated, n % d) << n << ' ' << d;
        ASSERT_EQ(*nearest, Integer(std::remainder(n, d))) << n << ' ' << d;
        ASSERT_EQ(*fast_truncated, oracle::wrap(*truncated, format)) << n << ' ' << d;
        ASSERT_EQ(*fast_nearest, oracle::wrap(*nearest, format)) << n << ' ' << d;
      }
    }
  }
}

TEST(OracleWholeFunctions, TheQuotientOfAProduct) {
  for (const Format& format : byte_formats) {
    for (unsigned a = 0; a < 256; a += 5) {
      for (unsigned b = 0; b < 256; b += 3) {
        for (unsigned c = 0; c < 256; ++c) {
          const int x = byte_value(a, format);
          const int y = byte_value(b, format);
          const int z = byte_value(c, format);
          const auto down = oracle::product_quotient(x, y, z, Rounding::floor);
          const auto up = oracle::product_quotient(x, y, z, Rounding::half_up);
          const auto fast = oracle::fast::product_quotient(a, b, c, Rounding::half_up, format);
          ASSERT_EQ(down.has_value(), z != 0);
          ASSERT_EQ(fast.has_value(), z != 0);
          if (z == 0) continue;
          // A double rounds no ratio of 16 bits to 8 up to a whole or half number.
          const double exact = static_cast<double>(x * y) / z;
          ASSERT_EQ(*down, Integer(std::floor(exact))) << x << ' ' << y << ' ' << z;
          ASSERT_EQ(*up, Integer(std::floor(exact + 0.5))) << x << ' ' << y << ' ' << z;
          ASSERT_EQ(*fast, oracle::wrap(*up, format)) << x << ' ' << y << ' ' << z;
        }
      }
    }
  }
  // 7 * 3 / 6 and 7 * 3 / -6 ulps are 3.5 and -3.5.
  EXPECT_EQ(*oracle::product_quotient(7, 3, 6, Rounding::half_even), 4);
  EXPECT_EQ(*oracle::product_quotient(7, 3, -6, Rounding::half_up), -3);
  EXPECT_EQ(*oracle::product_quotient(7, 3, -6, Rounding::half_away), -4);
  EXPECT_EQ(*oracle::product_quotient(7, 3, -6, Rounding::truncate), -3);
}

/// Whether r is the integer nearest to the root of the sum: (r - 1/2)^2 < sum < (r + 1/2)^2.
bool is_nearest_root(const Integer& r, const Integer& sum) {
  const Integer twice = 2 * r;
  return (r == 0 || (twice - 1) * (twice - 1) < 4 * sum) && 4 * sum < (twice + 1) * (twice + 1);
}

TEST(OracleWholeFunctions, Lengths) {
  for (const Format& format :
       {Format{8, 4, true}, Format{8, 8, false}, Format{32, 16, true}, Format{32, 32, false}}) {
    const LongWord ones = ~LongWord{0} >> (64 - format.bits);
    std::uint64_t state = 5;
    const auto word = [&]() -> LongWord {
      state = state * 6364136223846793005U + 1442695040888963407U;
      const std::uint64_t drawn = state >> 32U >> (state >> 20U) % 30;
      return (state >> 7U) % 8 == 0 ? ones - drawn % 3 : drawn & ones;
    };
    for (int i = 0; i < 20'000; ++i) {
      const LongWord a = word();
      const LongWord b = word();
      const LongWord c = word();
      const Integer x = oracle::ulps(a, format);
      const Integer y = oracle::ulps(b, format);
      const Integer z = oracle::ulps(c, format);
      const Integer root = oracle::nearest_length(x, y, z);
      ASSERT_TRUE(is_nearest_root(root, x * x + y * y + z * z)) << x << ' ' << y << ' ' << z;
      ASSERT_EQ(Integer(oracle::fast::nearest_length(a, b, c, format)), root)
          << x << ' ' << y << ' ' << z;
      // The ratio is the length rounded down.
      const auto [n, d] = oracle::length_of(x, y, z);
      const Integer squares = (x * x + y * y + z * z) * d * d;
      ASSERT_TRUE(n * n <= squares && squares < (n + 1) * (n + 1));
      ASSERT_EQ(n * n == squares, d == 1);
    }
  }
  EXPECT_EQ(oracle::nearest_length(2, -3, 6), 7);
  EXPECT_EQ(oracle::nearest_length(0, 0, 0), 0);
  // The squares of all three are 3 (2^32 - 1)^2, which takes 66 bits; the root is 7439101571.8.
  const LongWord most = 0xffffffff;
  EXPECT_EQ(oracle::fast::nearest_length(most, most, most, {32, 0, false}), 7439101572U);
}

}  // namespace

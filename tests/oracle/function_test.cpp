/// Tests which results the oracle takes for ties of the functions.
#include "oracle/function.hpp"

#include "tests/support/test.hpp"

namespace {

using oracle::Function;
using oracle::Integer;
using oracle::Rounding;

/// A result that lies between 0 and 1 ulp, rounded by both rules for ties.
struct Halves {
  Integer up;
  Integer even;
  bool operator==(const Halves&) const = default;
};

Halves rounded(Function function, const Integer& x, const Integer& y, int fraction_bits) {
  return {oracle::nearest(function, x, y, fraction_bits, Rounding::half_up).value(),
          oracle::nearest(function, x, y, fraction_bits, Rounding::half_even).value()};
}

Integer two_to(int exponent) { return Integer(1) << exponent; }

TEST(OracleFunctions, TiesAreExact) {
  const Halves half{1, 0};
  const Halves minus_half{0, 0};
  for (const int bits : {0, 1, 8, 32, 250}) {
    const Integer one = two_to(bits);
    EXPECT_EQ(rounded(Function::exp2, -(bits + 1) * one, 0, bits), half) << bits;
    EXPECT_EQ(rounded(Function::rsqrt, two_to(3 * bits + 2), 0, bits), half) << bits;
    EXPECT_EQ(rounded(Function::reciprocal, two_to(2 * bits + 1), 0, bits), half) << bits;
    EXPECT_EQ(rounded(Function::reciprocal, -two_to(2 * bits + 1), 0, bits), minus_half) << bits;
    EXPECT_EQ(rounded(Function::pow, 2 * one, -(bits + 1) * one, bits), half) << bits;
  }
  EXPECT_EQ(rounded(Function::sin_of_degrees, 30, 0, 0), half);
  EXPECT_EQ(rounded(Function::sin_of_degrees, -150, 0, 0), minus_half);
  EXPECT_EQ(rounded(Function::cos_of_degrees, 420, 0, 0), half);
  EXPECT_EQ(rounded(Function::cos_of_degrees, -120, 0, 0), minus_half);
}

TEST(OracleFunctions, TiesOfPowersAreExact) {
  // 3^3 / 2^9 in units of 2^-8, and its negative.
  EXPECT_EQ(rounded(Function::pow, 96, 3 * 256, 8), (Halves{14, 14}));
  EXPECT_EQ(rounded(Function::pow, -96, 3 * 256, 8), (Halves{-13, -14}));
  // (25/4)^(3/2) = 125/8 in units of 1/4.
  EXPECT_EQ(rounded(Function::pow, 25, 6, 2), (Halves{63, 62}));
  // (81/16)^(9/4) = 3^9 / 2^9, and (1/16)^(9/4), in units of 2^-8.
  EXPECT_EQ(rounded(Function::pow, 81 * 16, 9 * 64, 8), (Halves{9842, 9842}));
  EXPECT_EQ(rounded(Function::pow, 16, 9 * 64, 8), (Halves{1, 0}));
}

TEST(OracleFunctions, AnotherResultTooNearATieIsAnError) {
  constexpr int bits = 250;
  const Integer one = two_to(bits);
  const auto nearest = [&](Function function, const Integer& x, const Integer& y) {
    return oracle::nearest(function, x, y, bits, Rounding::half_up);
  };
  // About 2^-250 ulps from half a unit. The power of a whole exponent is rational, but no tie.
  EXPECT_THROW((void)nearest(Function::exp2, -(bits + 1) * one + 1, 0), std::range_error);
  EXPECT_THROW((void)nearest(Function::pow, 2 * one, -(bits + 1) * one + 1), std::range_error);
  EXPECT_THROW((void)nearest(Function::pow, 2 * one + 1, -(bits + 1) * one), std::range_error);
  EXPECT_THROW((void)nearest(Function::rsqrt, two_to(3 * bits + 2) + 1, 0), std::range_error);
  // Within 2^-200 ulps of a whole number there is no question.
  EXPECT_EQ(nearest(Function::exp2, -bits * one + 1, 0), 1);
}

}  // namespace

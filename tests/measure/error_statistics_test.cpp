// Tests statistics of a few errors, worked by hand.
#include "measure/accuracy/error_statistics.hpp"

#include "tests/support/test.hpp"

namespace {

using fixproof::measure::ErrorHistogram;
using fixproof::measure::ErrorStatistics;

TEST(ErrorStatistics, OfNothingAreZero) {
  const ErrorStatistics none;
  EXPECT_EQ(none.cases(), 0U);
  EXPECT_EQ(none.mean(), 0);
  EXPECT_EQ(none.mean_error(), 0);
  EXPECT_EQ(none.root_mean_square(), 0);
  EXPECT_EQ(none.correct(), 0);
}

// -1, 0.5, 0.25 and 0.25: the sum is 0, the sum of squares 1 + 1/4 + 1/16 + 1/16 = 11/8.
TEST(ErrorStatistics, OfFourErrors) {
  ErrorStatistics four;
  four.add(-1, false);
  four.add(0.5, true);
  four.add(0.25, true);
  four.add(0.25, true);
  EXPECT_EQ(four.cases(), 4U);
  EXPECT_EQ(four.max(), 1);
  EXPECT_EQ(four.mean(), 0);
  EXPECT_DOUBLE_EQ(four.root_mean_square(), std::sqrt(11.0 / 32));
  EXPECT_EQ(four.correct(), 0.75);
}

// Sixteen errors of 3 and -3: the rms is 3, and the standard error of the mean 3 / sqrt(16).
TEST(ErrorStatistics, TheMeanOfSixteenIsKnownToAQuarterOfTheirSize) {
  ErrorStatistics sixteen;
  for (int i = 0; i < 8; ++i) {
    sixteen.add(3, false);
    sixteen.add(-3, false);
  }
  EXPECT_EQ(sixteen.mean(), 0);
  EXPECT_DOUBLE_EQ(sixteen.mean_error(), 0.75);
}

TEST(ErrorStatistics, TheBiasKeepsItsSign) {
  ErrorStatistics two;
  two.add(-0.5, true);
  two.add(-0.25, true);
  EXPECT_EQ(two.mean(), -0.375);
  EXPECT_EQ(two.max(), 0.5);
}

using Counts = std::array<std::uint64_t, ErrorHistogram::buckets>;

// Buckets are 1/16 wide while no error exceeds 1/2.
TEST(ErrorHistogram, ABorderBelongsToTheBucketNearerZero) {
  ErrorHistogram h;
  for (const double error : {0.0, 1.0 / 16, 1.1 / 16, 0.5, -0.01, -1.0 / 16, -0.5}) h.add(error);
  EXPECT_EQ(h.span(), 0.5);
  EXPECT_EQ(h.counts(), (Counts{1, 0, 0, 0, 0, 0, 0, 2, 2, 1, 0, 0, 0, 0, 0, 1}));
}

// An error of 3 needs a span of 4, so buckets are 1/2 wide. 0.5 and -0.5 stay beside zero.
TEST(ErrorHistogram, WidensUntilEveryErrorHasAPlace) {
  ErrorHistogram h;
  for (const double error : {0.5, -0.5, 0.25, 3.0, 0.51}) h.add(error);
  EXPECT_EQ(h.span(), 4);
  EXPECT_EQ(h.counts(), (Counts{0, 0, 0, 0, 0, 0, 0, 1, 2, 1, 0, 0, 0, 1, 0, 0}));
}

TEST(ErrorHistogram, TheOrderOfErrorsDoesNotMatter) {
  ErrorHistogram outward;
  ErrorHistogram inward;
  const auto add_both = [](ErrorHistogram& h, int i) {
    h.add(i / 32.0);
    h.add(-i / 32.0);
  };
  for (int i = 0; i <= 80; ++i) add_both(outward, i);
  for (int i = 80; i >= 0; --i) add_both(inward, i);
  EXPECT_EQ(outward.span(), inward.span());
  EXPECT_EQ(outward.counts(), inward.counts());
}

}  // namespace

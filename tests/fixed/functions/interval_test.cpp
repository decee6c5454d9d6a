/// Tests intervals alone: operands of functions give no interval with an end that is an integer.
#include "fixed/detail/interval.hpp"

#include <gtest/gtest.h>

#include <cstddef>

#include "fixed/detail/interval_rounding.hpp"

namespace interval_test {
namespace {

using fixproof::rounding;
using fixproof::detail::int128;
using fixproof::detail::interval;

constexpr std::size_t digits = 6;

/// 1 + 2^-191 with a radius of 2^-191: its lower end is 1.
interval from_one() {
  const interval one(digits, false, 1, 0);
  return one + interval(digits, false, 1, 63).scaled(63 - 191).widened();
}

TEST(Intervals, AreNotDecidedWhereAnEndIsAnInteger) {
  EXPECT_FALSE(from_one().directed_ulps<rounding::ceiling>(0).is_decided);
  EXPECT_FALSE((-from_one()).directed_ulps<rounding::ceiling>(0).is_decided);
  const auto nearest = from_one().nearest_ulps(0);
  EXPECT_TRUE(nearest.is_decided);
  EXPECT_EQ(nearest.ulps, int128{1});
}

TEST(Intervals, AreDecidedBesideAnInteger) {
  const interval above = from_one() + interval(digits, false, 1, 63).scaled(63 - 180);
  const auto up = above.directed_ulps<rounding::ceiling>(0);
  const auto down = above.directed_ulps<rounding::floor>(0);
  EXPECT_TRUE(up.is_decided && down.is_decided);
  EXPECT_EQ(up.ulps, int128{2});
  EXPECT_EQ(down.ulps, int128{1});
}

TEST(Intervals, KnowNothingOfAQuotientByWhatMayBeZero) {
  const interval one(digits, false, 1, 0);
  const interval none = from_one() - from_one();
  EXPECT_FALSE(none.is_normal());
  EXPECT_FALSE((one / none).nearest_ulps(16).is_decided);
}

TEST(Intervals, GiveTheIntegerThatNoPrecisionTellsFromTheResult) {
  const auto three = [](std::size_t n) { return interval(n, false, 3, 0).widened(); };
  EXPECT_EQ(fixproof::detail::certain_ulps<rounding::ceiling>(4, three), int128{48});
  EXPECT_EQ(fixproof::detail::certain_ulps<rounding::floor>(4, three), int128{48});
}

}  // namespace
}  // namespace interval_test

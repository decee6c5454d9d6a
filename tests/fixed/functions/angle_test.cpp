/// Tests the limits of angles, their hardest pairs, and the error bounds of their parts.
#include "fixed/angle.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "fixed/constants.hpp"
#include "fixed/fixed.hpp"
#include "oracle/function.hpp"
#include "tests/fixed/functions/hard_pairs.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;

/// The oracle's angle, in a format that saturates.
template <class N>
void expect_nearest(N y, N x) {
  using raw = typename N::raw_type;
  const auto want = oracle::nearest(oracle::Function::atan2, y.raw(), x.raw(), N::fraction_bits,
                                    oracle::Rounding::half_up);
  const auto limited = std::clamp(static_cast<std::int64_t>(want.value()),
                                  std::int64_t{std::numeric_limits<raw>::min()},
                                  std::int64_t{std::numeric_limits<raw>::max()});
  ASSERT_EQ(atan2(y, x).raw(), limited) << y.raw() << ' ' << x.raw();
}

/// (x, y) and its mirror images.
template <class N>
void expect_hard_pair(const functions::HardPair& pair) {
  using raw = typename N::raw_type;
  EXPECT_EQ(detail::nearest_angle(pair.y, pair.x, N::fraction_bits), pair.result)
      << pair.y << ' ' << pair.x;
  const auto number = [](std::int64_t value) { return N::from_raw(static_cast<raw>(value)); };
  for (const std::int64_t to_y : {-1, 1}) {
    for (const std::int64_t to_x : {-1, 1}) {
      expect_nearest(number(to_y * pair.y), number(to_x * pair.x));
      expect_nearest(number(to_x * pair.x), number(to_y * pair.y));
    }
  }
}

/// The number of pairs of each format in a file, all of which were tried.
std::map<std::string, int> tried_pairs(const std::string& name) {
  const std::map<std::string, void (*)(const functions::HardPair&)> formats{
      {"q8_8", expect_hard_pair<q8_8>},
      {"q16_16", expect_hard_pair<q16_16>},
      {"q24_8", expect_hard_pair<q24_8>},
      {"q8_24", expect_hard_pair<q8_24>},
      {"q2_30", expect_hard_pair<q2_30>}};
  std::map<std::string, int> tried;
  for (const functions::HardPair& pair : functions::hard_pairs(name)) {
    const auto format = formats.find(pair.format);
    if (format == formats.end()) {
      ADD_FAILURE() << name << " has a pair of the format " << pair.format
                    << ", which tried_pairs() does not know";
      continue;
    }
    format->second(pair);
    ++tried[pair.format];
  }
  return tried;
}

// The hardest of 16.16, 2^-63.5 ulps from a tie, is (-1953906981, 910339403).
TEST(Angles, TheHardestPairs) {
  EXPECT_EQ(tried_pairs("hard_pairs.txt"),
            (std::map<std::string, int>{{"q8_8", 1367}, {"q16_16", 610}}));
}

TEST(Angles, TheHardestPairsOf32Bits) {
  EXPECT_EQ(tried_pairs("hard_pairs_32.txt"),
            (std::map<std::string, int>{{"q24_8", 602}, {"q8_24", 75}, {"q2_30", 33}}));
}

TEST(Angles, RangeFollowsThePolicy) {
  using trapping = number<std::int32_t, 30, policies::trapping>;
  EXPECT_EQ(atan2(q2_30(1), q2_30(-1)), std::numeric_limits<q2_30>::max());
  EXPECT_EQ(atan2(q2_30(-1), q2_30(-1)), std::numeric_limits<q2_30>::lowest());
  EXPECT_THROW((void)atan2(trapping(1), trapping(-1)), overflow_error);
  EXPECT_THROW((void)acos(q16_16_trapping::from_raw(65537)), domain_error);
  EXPECT_EQ(asin(q16_16::from_raw(65537)), q16_16());
  EXPECT_EQ(acos(q2_30(-1)), std::numeric_limits<q2_30>::max());
  EXPECT_EQ(atan2(q16_16(), q16_16()), q16_16());
  EXPECT_EQ(atan2(q16_16(), q16_16(-1)), pi_v<q16_16>);
  EXPECT_EQ(atan(std::numeric_limits<q16_16>::max()).raw(), half_pi_v<q16_16>.raw() - 2);
}

TEST(Angles, PartsHaveTheirError) {
  std::mt19937_64 random(1994);
  for (int i = 0; i < 5000; ++i) {
    // Below 2^57. Those below 2^32 are divided in two steps.
    const std::uint64_t d = (random() >> (7 + random() % 45)) | 1;
    std::uint64_t n = random() % (d + 1);
    if (i % 3 == 0) n = d / 64 * (random() % 65);
    if (i % 3 == 1 && n > 0) n = d * (n % 64) / 64;  // Next to the places where the table steps.
    const auto exact = static_cast<std::int64_t>(
        detail::precise_arctangent(detail::ratio(detail::real{n}, detail::real{d})) >>
        (detail::real_bits - 58));
    ASSERT_LE(std::abs(detail::arctangent(n, d) - exact), 6) << n << ' ' << d;
    if (d >> 32 == 0) {
      const std::int64_t quick = detail::quick_arctangent(n, d);
      ASSERT_LE(std::abs((quick << 26) - exact), 3 << 26) << n << ' ' << d;
    }
  }
}

}  // namespace

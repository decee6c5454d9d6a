/// Tests the limits of angles, their hardest pair, and the error bounds of their parts.
#include "fixed/angle.hpp"

#include <fstream>
#include <sstream>

#include "fixed/constants.hpp"
#include "fixed/fixed.hpp"
#include "oracle/function.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;

template <class N>
void expect_nearest(N y, N x) {
  const auto want = oracle::nearest(oracle::Function::atan2, y.raw(), x.raw(), N::fraction_bits,
                                    oracle::Rounding::half_up);
  ASSERT_EQ(atan2(y, x).raw(), static_cast<std::int64_t>(want.value()))
      << y.raw() << ' ' << x.raw();
}

/// (x, y) and its mirror images.
template <class N>
void expect_mirrored_nearest(std::int64_t y, std::int64_t x) {
  for (const std::int64_t to_y : {-1, 1}) {
    for (const std::int64_t to_x : {-1, 1}) {
      const auto number = [](std::int64_t raw) {
        return N::from_raw(static_cast<typename N::raw_type>(raw));
      };
      expect_nearest(number(to_y * y), number(to_x * x));
      expect_nearest(number(to_x * x), number(to_y * y));
    }
  }
}

// The hardest of 16.16, 2^-63.5 ulps from a tie, is (-1953906981, 910339403).
TEST(Angles, TheHardestPairs) {
  std::ifstream file(FUNCTIONS_FOLDER "/hard_pairs.txt");
  std::string line;
  std::size_t pairs = 0;
  while (std::getline(file, line)) {
    if (line.starts_with('#')) continue;
    std::istringstream parts(line);
    std::string format;
    std::int64_t y = 0;
    std::int64_t x = 0;
    std::int64_t result = 0;
    ASSERT_TRUE(parts >> format >> y >> x >> result) << line;
    if (format == "q16_16") {
      EXPECT_EQ(detail::nearest_angle(y, x, 16), result) << line;
      expect_mirrored_nearest<q16_16>(y, x);
    } else {
      ASSERT_EQ(format, "q8_8");
      EXPECT_EQ(detail::nearest_angle(y, x, 8), result) << line;
      expect_mirrored_nearest<q8_8>(y, x);
    }
    ++pairs;
  }
  EXPECT_EQ(pairs, 1977U);
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
    // Below 2^57, of which those below 2^32 are divided in two steps.
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

/// Tests that this program checks the bounds of fixed/detail, and that the bounds hold where
/// results are the largest. In the other tests of this program, a bound that does not hold ends the
/// program.
#include <cstdint>
#include <limits>

#include "fixed/detail/digit_series.hpp"
#include "fixed/detail/power.hpp"
#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"

namespace assertion_test {

namespace detail = fixproof::detail;

TEST(AssertionsDeathTest, EndTheProgram) {
  EXPECT_DEATH(detail::nearest_within(std::numeric_limits<std::int64_t>::max(), std::int64_t{1}, 9),
               "");
  EXPECT_DEATH(detail::nearest_within(detail::int128{1} << 80, detail::int128{1}, 16), "");
  EXPECT_DEATH(detail::nearest_units(detail::real_one << 64, 0), "");
  // The square of 2^30 - 1/2 is beyond every result, so its bounds decide it before.
  EXPECT_DEATH(detail::rational_power<fixproof::rounding::half_up>(0x7fffffff, 4, 1), "");
  EXPECT_DEATH(
      {
        auto large = detail::in_digits::scaled_integer(-1, detail::in_digits::real_bits + 38);
        detail::in_digits::nearest_units(large, 32);
      },
      "");
}

/// Tangents on both sides of each pole, up to 2^34.
template <int F>
void take_tangents_at_poles() {
  using N = fixproof::number<std::uint32_t, F>;
  constexpr double half_pi = 1.5707963267948966;
  for (int odd = 1; odd * half_pi < (0x1p32 - 2) / (std::int64_t{1} << F); odd += 2) {
    const auto below = static_cast<std::uint32_t>(odd * half_pi * (std::int64_t{1} << F));
    for (const std::uint32_t raw : {below - 1, below, below + 1}) {
      const N result = tan(N::from_raw(raw));
      // All are out of range.
      EXPECT_TRUE(result == N() || result == std::numeric_limits<N>::max()) << F << ' ' << raw;
    }
  }
}

TEST(Assertions, HoldForTangentsAtPoles) {
  take_tangents_at_poles<31>();
  take_tangents_at_poles<30>();
  take_tangents_at_poles<29>();
  take_tangents_at_poles<28>();
}

}  // namespace assertion_test

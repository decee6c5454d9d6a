/// Tests the two-word sum against 128-bit integers.
#include "fixed/detail/wide_sum.hpp"

#include "tests/fixed/exact.hpp"
#include "tests/support/test.hpp"

namespace {

TEST(WideSum, IsThe128BitSum) {
  std::mt19937_64 random(22);
  constexpr std::int64_t lowest = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t highest = std::numeric_limits<std::int64_t>::max();
  for (int run = 0; run < 300; ++run) {
    fixproof::detail::wide_sum sum;
    exact::integer expected = 0;
    for (int term = 0; term < 50; ++term) {
      std::int64_t value = static_cast<std::int64_t>(random()) >> (random() % 64);
      if (random() % 4 == 0) value = random() % 2 == 0 ? lowest : highest;
      if (random() % 8 == 0) value = -1;
      if (random() % 2 == 0) {
        sum.add(value);
        expected += value;
      } else {
        sum.add_shifted_32(value);
        expected += value * (exact::integer{1} << 32);
      }
      ASSERT_EQ(sum.negative(), expected < 0);
      for (const int bits : {1, 8, 16, 63}) {
        // Boost 1.74's >> loses a sign with 32-bit limbs, for example for -2^63 - 1 by 1.
        const exact::integer shifted = exact::below({expected, exact::integer{1} << bits});
        ASSERT_EQ(sum.low_shifted_right(bits), exact::low_word(shifted));
        const exact::integer clamped = shifted < lowest    ? lowest
                                       : shifted > highest ? highest
                                                           : shifted;
        ASSERT_EQ(sum.clamped_shifted_right(bits), static_cast<std::int64_t>(clamped));
      }
    }
  }
}

}  // namespace

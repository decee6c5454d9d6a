/// Tests that the functions in compact words have the results of those in words, and that their
/// parts have the errors that they allow.
#include <map>
#include <string>

#include "tests/fixed/functions/compact_words.hpp"
#include "tests/fixed/functions/hard_pairs.hpp"

namespace compact_test {

using namespace fixproof;
namespace words = fixproof::detail;
namespace compact = fixproof::detail::in_compact_words;
using functions::expect_same_in_both;

class CompactWords : public testing::Test {
 public:
  /// A word of any length, next to a power of two, or a number with rational results.
  template <class N>
  std::int64_t any() {
    using limits = std::numeric_limits<typename N::raw_type>;
    auto word = static_cast<std::int64_t>(random_()) >> (31 + below(33));
    if (below(6) == 0) word = (std::int64_t{1} << below(33)) + below(3) - 1;
    if (below(6) == 0) word = (below(720) - 360) * (std::int64_t{1} << N::fraction_bits);
    if (below(6) == 0) word = (below(200) - 100) * (std::int64_t{1} << below(N::fraction_bits + 1));
    return std::clamp<std::int64_t>(word, limits::min(), limits::max());
  }

  template <class... N>
  void expect_same_results(int count) {
    for (int i = 0; i < count; ++i) {
      (expect_same_in_both<N>(any<N>(), any<N>()), ...);
      (expect_same_in_both<N, rounding::half_even>(any<N>(), any<N>()), ...);
    }
  }

  int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }
  std::uint64_t bits() { return random_(); }

 private:
  std::mt19937_64 random_{1994};
};

TEST_F(CompactWords, ResultsAreThoseOfWords) { expect_same_results<q16_16, u16_16>(2500); }

TEST_F(CompactWords, WhereDigitsDecideTheRest) {
  expect_same_results<q24_8, q32_0, q8_24, q2_30, number<std::int32_t, 31>,
                      number<std::uint32_t, 32>, number<std::int32_t, 5>, number<std::int32_t, 17>>(
      300);
}

template <class Raw, int... Points>
void expect_same_words(std::integer_sequence<int, Points...> /*points*/) {
  using limits = std::numeric_limits<Raw>;
  for (std::int64_t x = limits::min(); x <= limits::max(); ++x) {
    (expect_same_in_both<number<Raw, Points>>(x, x * 77 % 128), ...);
  }
}

TEST_F(CompactWords, OfEveryWordOf8Bits) {
  expect_same_words<std::int8_t>(std::integer_sequence<int, 0, 1, 2, 3, 4, 5, 6, 7>());
  expect_same_words<std::uint8_t>(std::integer_sequence<int, 0, 1, 2, 3, 4, 5, 6, 7, 8>());
}

/// The sinh and the cosine that are nearest to a tie, tangents that 64 bits of the phase do not
/// decide, one out of range that no error bound decides, poles in degrees and turns, and words next
/// to these.
TEST_F(CompactWords, OfHardWords) {
  for (const std::int64_t x : {441619, 0x60cf72d8, 294933721, 522027539, 1054246514, 1, 2,
                               0x7fffffff, 0x4000, 0x4001, 0x5a0000, 0x59ffff}) {
    expect_same_in_both<q16_16>(x, 1);
    expect_same_in_both<q16_16>(-x, 1);
  }
}

TEST_F(CompactWords, HardPairsAreThoseOfTheFiles) {
  std::size_t pairs = 0;
  const auto check = [&]<class N>(const functions::HardPair& pair) {
    ASSERT_EQ(compact::nearest_angle(pair.y, pair.x, words::result_bits<N, N>()), pair.result)
        << pair.format << ' ' << pair.y << ' ' << pair.x;
    ++pairs;
  };
  for (const char* name : {"hard_pairs.txt", "hard_pairs_32.txt"}) {
    for (const functions::HardPair& pair : functions::hard_pairs(name)) {
      if (pair.format == "q8_8") check.operator()<q8_8>(pair);
      if (pair.format == "q16_16") check.operator()<q16_16>(pair);
      if (pair.format == "q24_8") check.operator()<q24_8>(pair);
      if (pair.format == "q8_24") check.operator()<q8_24>(pair);
      if (pair.format == "q2_30") check.operator()<q2_30>(pair);
    }
  }
  EXPECT_EQ(pairs, 2687U);
}

/// What a long arctangent is too high, in units of 2^-90.
std::int64_t arctangent_error(std::uint64_t n, std::uint64_t d) {
  const compact::long_angle found = compact::long_arctangent(n, d);
  const words::real exact = words::precise_arctangent(words::ratio(words::real{n}, words::real{d}));
  const words::real sum = (words::real{found.high} << (words::real_bits - 58)) +
                          (words::real{found.low} << (words::real_bits - 90));
  return static_cast<std::int64_t>((sum - exact) >> (words::real_bits - 90));
}

TEST_F(CompactWords, ArctangentsHaveTheirError) {
  std::int64_t most = 0;
  const auto check = [&](std::uint64_t n, std::uint64_t d) {
    const std::int64_t error = arctangent_error(n, d);
    ASSERT_GE(error, -196) << n << ' ' << d;
    ASSERT_LE(error, 666) << n << ' ' << d;
    most = std::max(most, error);
  };
  check(1, 1);
  check(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const std::uint64_t d = bits() >> 32 | 1;
    check(bits() % (d + 1), d);
    // z is next to 1/64, where the error is greatest.
    check((bits() % 64 * d + d - 1) / 64, d);
  }
  EXPECT_GT(most, 400);
}

// 360 degrees are less than a turn, and with a unit more of each they are more.
TEST_F(CompactWords, ADegreeIsRoundedDown) {
  const auto turn = [](std::uint64_t unit) {
    std::uint64_t carry = unit * 360;
    std::uint64_t top = 0;
    for (const std::uint32_t word : compact::turns_of_degree) {
      carry += std::uint64_t{word} * 360;
      top = carry >> 32;
      carry = top;
    }
    return top;
  };
  EXPECT_EQ(turn(0), 0U);
  EXPECT_EQ(turn(1), 1U);
}

}  // namespace compact_test

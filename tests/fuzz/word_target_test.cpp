// Tests what the mutator makes of word inputs.
#include "fuzz/word_target.hpp"

#include "fuzz/words.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using fuzz::WordTarget;

/// The number of cases on each edge of the divide, from definitions in 64-bit integers.
struct Edges {
  int ties = 0;
  int ties_of_8088 = 0;
  int near_2_31 = 0;
  int near_2_32 = 0;
  int divisor_below_one = 0;
  int divisor_zero = 0;
  int lowest = 0;
  int minus_one = 0;

  void count(std::uint32_t a, std::uint32_t b) {
    const std::int64_t n = static_cast<std::int32_t>(a);
    const std::int64_t d = static_cast<std::int32_t>(b);
    lowest += n == INT32_MIN || d == INT32_MIN;
    minus_one += d == -1 || d == -0x10000;
    divisor_zero += d == 0;
    divisor_below_one += std::abs(d) < 0x10000;
    if (d == 0) return;
    const std::int64_t scaled = std::abs(n) << 16;
    ties += scaled % std::abs(d) * 2 == std::abs(d);
    const std::int64_t quotient = scaled / std::abs(d);
    near_2_31 += std::abs(quotient - (std::int64_t{1} << 31)) <= 2;
    near_2_32 += std::abs(quotient - (std::int64_t{1} << 32)) <= 2;
    const std::int64_t whole = std::abs(d) >> 16;
    ties_of_8088 += whole != 0 && std::abs(n) % whole * 2 == whole;
  }
};

TEST(MutateInput, SeeksTheEdgesOfTheDivide) {
  std::array<std::uint8_t, 8> input{};
  Edges edges;
  constexpr std::uint32_t inputs = 20000;
  for (std::uint32_t seed = 0; seed < inputs; ++seed) {
    ASSERT_EQ(fuzz::mutate_input(WordTarget::divide, input, input.size(), seed), input.size());
    std::array<std::uint32_t, 2> words{};
    fuzz::read_words(input, words);
    edges.count(words[0], words[1]);
  }
  // Of uniform words, fewer than one in a thousand is on any of these edges.
  constexpr int some = inputs / 400;
  EXPECT_GT(edges.ties, some);
  EXPECT_GT(edges.ties_of_8088, some);
  EXPECT_GT(edges.near_2_31, some);
  EXPECT_GT(edges.near_2_32, some);
  EXPECT_GT(edges.divisor_below_one, some);
  EXPECT_GT(edges.divisor_zero, some);
  EXPECT_GT(edges.lowest, some);
  EXPECT_GT(edges.minus_one, some);
}

TEST(MutateInput, SameSeedSameInput) {
  for (const auto target : {WordTarget::divide, WordTarget::matrix, WordTarget::agreement}) {
    std::vector<std::uint8_t> once(fuzz::input_size(target), 7);
    auto twice = once;
    fuzz::mutate_input(target, once, once.size(), 42);
    EXPECT_NE(once, twice);
    fuzz::mutate_input(target, twice, twice.size(), 42);
    EXPECT_EQ(once, twice);
  }
}

TEST(MutateInput, FillsAShortInputAndLeavesASmallRoom) {
  std::vector<std::uint8_t> room(200, 0xAA);
  EXPECT_EQ(fuzz::mutate_input(WordTarget::agreement, room, 3, 1), 97U);
  EXPECT_EQ(room[97], 0xAA);
  std::array<std::uint8_t, 5> small{1, 2, 3, 4, 5};
  const auto before = small;
  EXPECT_EQ(fuzz::mutate_input(WordTarget::divide, small, 5, 1), 5U);
  EXPECT_EQ(small, before);
}

TEST(FuzzWords, HighestByteFirst) {
  const std::array<std::uint8_t, 6> bytes{0x80, 0, 0, 1, 0xAB, 0xCD};
  std::array<std::uint32_t, 2> words{};
  fuzz::read_words(bytes, words);
  EXPECT_EQ(words, (std::array<std::uint32_t, 2>{0x80000001, 0xABCD0000}));
  std::array<std::uint8_t, 6> back{};
  fuzz::write_words(words, back);
  EXPECT_EQ(back, bytes);
}

}  // namespace

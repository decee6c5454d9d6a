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

/// What an arcsine is too high, in units of 2^-62, if the cosine is rounded down.
/// @param sine in units of 2^-32
std::int64_t arcsine_error(std::uint64_t sine) {
  const words::real cosine = words::precise_side(0 - sine * sine, 32);
  const auto rounded = static_cast<std::uint64_t>(cosine >> (words::real_bits - 58));
  const words::real found{compact::arcsine(sine << 26, rounded)};
  const words::real exact =
      words::precise_arctangent(words::ratio(words::real{sine} << (words::real_bits - 32), cosine));
  return static_cast<std::int64_t>(((found << (words::real_bits - 62)) - exact) >>
                                   (words::real_bits - 62));
}

TEST_F(CompactWords, ArcsinesHaveTheirError) {
  constexpr std::uint64_t root_of_half = 0xb504f333;
  std::int64_t most = 0;
  const auto check = [&](std::uint64_t sine) {
    const std::int64_t error = arcsine_error(std::min(sine, root_of_half));
    ASSERT_GE(error, -21) << sine;
    ASSERT_LE(error, 21) << sine;
    most = std::max(most, std::abs(error));
  };
  check(1);
  for (int i = 0; i < 1000; ++i) {
    check(bits() % root_of_half + 1);
    // Next to an entry of the table, or in the middle of two
    check((bits() % 90 + 1) * (std::uint64_t{1} << 25) + bits() % 3 - 1);
  }
  EXPECT_GT(most, 10);
}

TEST_F(CompactWords, LogarithmsHaveTheirError) {
  std::int64_t most = 0;
  const auto check = [&](std::uint32_t fraction) {
    const words::real found{compact::binary_logarithm_of(fraction)};
    const words::real exact = words::precise_logarithm((std::uint64_t{1} << 32) + fraction);
    const auto error = static_cast<std::int64_t>(((found << (words::real_bits - 64)) - exact) >>
                                                 (words::real_bits - 64));
    ASSERT_LT(std::abs(error), 79) << fraction;
    most = std::max(most, std::abs(error));
  };
  for (int i = 0; i < 1000; ++i) {
    check(static_cast<std::uint32_t>(bits()));
    // The greatest r of an interval
    check(static_cast<std::uint32_t>((bits() % 32 + 1) * (std::uint64_t{1} << 27) - 1));
  }
  EXPECT_GT(most, 60);
}

/// A positive number and an exponent, often with a power in range or a rational one.
struct Power {
  std::uint32_t raw;
  std::int64_t exponent;
};

Power power_of(CompactWords& random, int fraction_bits) {
  const auto word = [&] { return static_cast<std::uint32_t>(random.bits() >> 32); };
  Power power{std::max(word() >> random.below(32), 1U), word() >> random.below(32)};
  const double log = std::log2(std::ldexp(power.raw, -fraction_bits));
  const int kind = random.below(4);
  if (kind < 2 && log != 0) {
    // From half an ulp to 2^34
    const double exponent =
        std::ldexp((random.below(35) - fraction_bits - 0.5) / log, fraction_bits);
    power.exponent = static_cast<std::int64_t>(std::clamp(exponent, -4294967295.0, 4294967295.0));
  } else if (kind == 2) {
    std::uint32_t root = std::max(word() >> (16 + random.below(16)), 1U);
    if (random.below(2) == 0) root = 1U << random.below(16);
    const std::int64_t eighth = (std::int64_t{1} << fraction_bits) / 8;
    power = {root * root, std::min<std::int64_t>(random.below(40) * eighth, 0xffffffff)};
    if (random.below(2) == 0) power.exponent *= -1;
  }
  return power;
}

template <rounding Ties>
void expect_same_power(const Power& of, int fraction_bits) {
  constexpr std::int64_t beyond = std::int64_t{1} << 33;
  const auto known = words::nearest_real_power<Ties>(of.raw, of.exponent, fraction_bits);
  const auto found = compact::nearest_real_power<Ties>(of.raw, of.exponent, fraction_bits);
  ASSERT_EQ(std::min(found, beyond), std::min(known, beyond))
      << of.raw << ' ' << of.exponent << ' ' << fraction_bits;
}

TEST_F(CompactWords, PowersAreThoseOfWords) {
  for (int fraction_bits = 0; fraction_bits <= 32; ++fraction_bits) {
    for (int i = 0; i < 1000; ++i) {
      const Power power = power_of(*this, fraction_bits);
      expect_same_power<rounding::half_up>(power, fraction_bits);
      expect_same_power<rounding::half_even>(power, fraction_bits);
      expect_same_power<rounding::floor>(power, fraction_bits);
    }
    expect_same_power<rounding::half_up>({0, 0}, fraction_bits);
    if (fraction_bits == 32) continue;
    // A power of 1 is 1, whatever the error of the exponent
    expect_same_power<rounding::half_up>({1U << fraction_bits, 0xffffffff}, fraction_bits);
    expect_same_power<rounding::half_up>({1U << fraction_bits, -0xffffffffLL}, fraction_bits);
  }
}

// Whole powers decide whether a power is above any number of half ulps, not only next to a tie.
TEST_F(CompactWords, WholePowersDecide) {
  int above = 0;
  int negative_above = 0;
  int ties = 0;
  int negative_ties = 0;
  for (int i = 0; i < 20000; ++i) {
    const int fraction_bits = below(33);
    const Power of = power_of(*this, fraction_bits);
    const std::int64_t down =
        words::nearest_real_power<rounding::floor>(of.raw, of.exponent, fraction_bits);
    const std::int64_t up =
        words::nearest_real_power<rounding::half_up>(of.raw, of.exponent, fraction_bits);
    // Both may be any integers beyond.
    if (of.exponent == 0 || down >= std::int64_t{1} << 33) continue;
    const bool is_negative = of.exponent < 0;
    const auto n = static_cast<std::uint32_t>(std::abs(of.exponent));
    // Below half an ulp, is_tie() takes another power for a tie.
    if (is_negative && up == 0) continue;
    ASSERT_EQ(compact::is_tie(of.raw, n, is_negative, fraction_bits), up != down)
        << of.raw << ' ' << of.exponent << ' ' << fraction_bits;
    if (up != down) {
      ++(is_negative ? negative_ties : ties);
      continue;
    }
    // A result to nearest is above the tie below it, and not above that above.
    if (down > 0) {
      ASSERT_TRUE(compact::is_above(of.raw, n, is_negative, fraction_bits,
                                    static_cast<std::uint64_t>(2 * down - 1)))
          << of.raw << ' ' << of.exponent << ' ' << fraction_bits;
      ++(is_negative ? negative_above : above);
    }
    ASSERT_FALSE(compact::is_above(of.raw, n, is_negative, fraction_bits,
                                   static_cast<std::uint64_t>(2 * down + 1)))
        << of.raw << ' ' << of.exponent << ' ' << fraction_bits;
  }
  EXPECT_GT(above, 3000);
  EXPECT_GT(negative_above, 1000);
  EXPECT_GT(ties, 5);
  EXPECT_GT(negative_ties, 0);
}

// Numbers of 64 bits would be wrong about these powers in 16.16, whose results are from mpmath with
// 80 digits. They are from 2^-20 to 2^-27 ulps from a tie.
TEST_F(CompactWords, OfPowersNextToATie) {
  for (const auto& [raw, exponent, result] :
       {std::array<std::int64_t, 3>{65576, 1039772291, 1048928445},
        {65593, 775217432, 1917067868},
        {65516, -1675400762, 160409155},
        {65586, 861921961, 1487884844},
        {65504, -1296149118, 1026865512},
        {65584, 924803763, 2011324358},
        {65588, 843710922, 1782487730},
        {65518, -2023925301, 316772022}}) {
    ASSERT_EQ(compact::nearest_real_power<rounding::half_up>(static_cast<std::uint64_t>(raw),
                                                             exponent, 16),
              result)
        << raw << ' ' << exponent;
  }
}

// The shorter side is the root here, so its error counts.
TEST_F(CompactWords, ArcsinesOfRootsHaveTheirError) {
  for (int i = 0; i < 1000; ++i) {
    const std::uint64_t cosine = (bits() >> 32) / 4 + 0xbfffffff;
    const words::real sine = words::precise_side(0 - cosine * cosine, 32);
    const auto rounded = static_cast<std::uint64_t>(sine >> (words::real_bits - 58));
    const words::real found{compact::arcsine(rounded, cosine << 26)};
    const words::real exact = words::precise_arctangent(
        words::ratio(sine, words::real{cosine} << (words::real_bits - 32)));
    const auto error = static_cast<std::int64_t>(((found << (words::real_bits - 62)) - exact) >>
                                                 (words::real_bits - 62));
    ASSERT_LE(std::abs(error), 21) << cosine;
  }
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

/// Compares functions that round down, up and toward zero with MPFR.
#include "fixed/batch/batch.hpp"
#include "fixed/batch/functions.hpp"
#include "tests/fixed/functions/long_words.hpp"

namespace bounds_test {
namespace {

using fixproof::policy;
using fixproof::q16_16;
using fixproof::rounding;
using fixproof::with_policy;
using long_words::Word;
using oracle::Function;

constexpr policy down{.functions = rounding::floor};
constexpr policy up{.functions = rounding::ceiling};
constexpr policy to_zero{.functions = rounding::truncate};

struct Case {
  long_words::Format format;
  mpfr_rnd_t rounding;
};

const std::array cases{
    Case{long_words::format_of<with_policy<q16_16, down>>("q16_16_down"), MPFR_RNDD},
    Case{long_words::format_of<with_policy<q16_16, up>>("q16_16_up"), MPFR_RNDU},
    Case{long_words::format_of<with_policy<q16_16, to_zero>>("q16_16_to_zero"), MPFR_RNDZ},
    Case{long_words::format_of<with_policy<fixproof::q8_8, up>>("q8_8_up"), MPFR_RNDU},
    Case{long_words::format_of<with_policy<fixproof::u0_32, up>>("u0_32_up"), MPFR_RNDU},
    Case{long_words::format_of<with_policy<fixproof::q2_30, to_zero>>("q2_30_to_zero"), MPFR_RNDZ},
    Case{long_words::format_of<with_policy<fixproof::q32_32, down>>("q32_32_down"), MPFR_RNDD},
    Case{long_words::format_of<with_policy<fixproof::u0_64, up>>("u0_64_up"), MPFR_RNDU}};

class Bounds : public testing::TestWithParam<Case> {};

TEST_P(Bounds, AreThoseOfMpfr) {
  const Case& test = GetParam();
  long_words::Comparison comparison(test.format, test.rounding);
  long_words::Random word(test.format.format, 1999);
  for (int i = 0; i < 60; ++i) {
    const Word x = word();
    const Word y = word();
    for (const auto& name : long_words::names) {
      ASSERT_NO_FATAL_FAILURE(comparison.compare(name, x, y));
    }
  }
  EXPECT_GT(comparison.count(), 500U);
}

TEST_P(Bounds, AreRightWhereResultsAreExactOrNearlySo) {
  const Case& test = GetParam();
  long_words::Comparison comparison(test.format, test.rounding);
  const std::vector<Word> words = long_words::hard_words(test.format.format);
  for (std::size_t i = 0; i < words.size(); ++i) {
    for (std::size_t k = i % 64; k < long_words::names.size(); k += 64) {
      const Word other = words[(i * 31 + 7) % words.size()];
      ASSERT_NO_FATAL_FAILURE(comparison.compare(long_words::names[k], words[i], other));
    }
  }
  const auto pairs = long_words::hard_powers(test.format.format);
  for (std::size_t i = 0; i < pairs.size(); i += 40) {
    ASSERT_NO_FATAL_FAILURE(
        comparison.compare({Function::pow, "pow", true}, pairs[i].first, pairs[i].second));
  }
}

INSTANTIATE_TEST_SUITE_P(All, Bounds, testing::ValuesIn(cases),
                         [](const auto& one) { return std::string(one.param.format.name); });

TEST(Bounds, OfExactResultsAreThese) {
  using low = with_policy<q16_16, down>;
  using high = with_policy<q16_16, up>;
  EXPECT_EQ(exp(low(0)), 1);
  EXPECT_EQ(exp(high(0)), 1);
  EXPECT_EQ(acos(high(1)), 0);
  EXPECT_EQ(atan2_in_degrees(high(1), high(-1)), 135);
  EXPECT_EQ(cbrt(high(-27)), -3);
  EXPECT_EQ(sqrt(high(6.25)), high(2.5));
}

// A root below 1 whose upper bound is 1, which a format without whole bits does not have.
TEST(Bounds, OutOfRangeSaturate) {
  using high = with_policy<fixproof::u0_32, up>;
  constexpr auto most = std::numeric_limits<high>::max();
  EXPECT_EQ(sqrt(most), most);
  using trapping = with_policy<fixproof::u0_32, policy{.range = fixproof::overflow::trap,
                                                       .functions = rounding::ceiling}>;
  EXPECT_THROW(static_cast<void>(sqrt(std::numeric_limits<trapping>::max())),
               fixproof::overflow_error);
}

TEST(Bounds, OfSpansAreThoseOfNumbers) {
  using high = with_policy<q16_16, up>;
  const std::vector<high> x{high(0.1), high(2), high(-1), high(3)};
  std::vector<high> out(x.size());
  fixproof::batch::exp(x, out);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_EQ(out[i], exp(x[i]));
  fixproof::batch::sqrt(x, out);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_EQ(out[i], sqrt(x[i]));
}

}  // namespace
}  // namespace bounds_test

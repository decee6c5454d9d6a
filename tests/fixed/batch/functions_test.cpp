/// Compares the functions of fixed/batch/functions.hpp on every path with the functions of one
/// number.
#include "tests/fixed/batch/functions.hpp"

#include <cfenv>

#include "fixed/formats.hpp"
#include "tests/fixed/functions/hard_words.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

template <class N>
void expect_same_bits(std::size_t count) {
  const Numbers<N> x = operands<N>(count, 16);
  const Numbers<N> y = operands<N>(count, 17);
  for (const BatchFunction<N>& f : all_functions<N>) {
    Numbers<N> want;
    for (std::size_t i = 0; i < x.size(); ++i) want.push_back(f.one(x[i], y[i]));
    for (const batch::path path : every_path) {
      Numbers<N> results(x.size());
      f.many(x, y, results, path);
      ASSERT_EQ(results, want) << f.name << " on path " << static_cast<int>(path);
    }
  }
}

constexpr std::size_t many = 20'000;

TEST(BatchFunctions, SameBitsAsOneByOne) {
  expect_same_bits<q16_16>(many);
  expect_same_bits<q8_8>(many);
  expect_same_bits<q2_30>(many);
  expect_same_bits<q24_8>(many);
  expect_same_bits<q1_15>(many);
}

TEST(BatchFunctions, SameBitsInFormatsWithoutOneOrWithoutFraction) {
  expect_same_bits<number<std::int32_t, 32>>(many);
  expect_same_bits<number<std::int32_t, 0>>(many);
}

TEST(BatchFunctions, UnsignedAndByteFormatsTakeThePlainLoop) {
  expect_same_bits<u16_16>(1000);
  expect_same_bits<q4_4>(1000);
}

/// The bounds of the estimates hold in all rounding modes.
TEST(BatchFunctions, SameBitsInEveryRoundingMode) {
  const int before = std::fegetround();
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    expect_same_bits<q16_16>(2000);
    expect_same_bits<q2_30>(2000);
  }
  std::fesetround(before);
}

TEST(BatchFunctions, NothingBeyondTheShortestSpan) {
  const Numbers<q16_16> x = operands<q16_16>(70, 18);
  const Numbers<q16_16> y = operands<q16_16>(70, 19);
  const q16_16 untouched = q16_16::from_raw(77);
  for (const BatchFunction<q16_16>& f : all_functions<q16_16>) {
    for (const batch::path path : every_path) {
      for (std::size_t count = 0; count < x.size(); ++count) {
        Numbers<q16_16> results(count + 3, untouched);
        f.many({x.begin(), x.begin() + static_cast<std::ptrdiff_t>(count)}, y, results, path);
        for (std::size_t i = 0; i < results.size(); ++i) {
          ASSERT_EQ(results[i], i < count ? f.one(x[i], y[i]) : untouched) << f.name;
        }
      }
    }
  }
}

template <class N>
void expect_results_may_replace_operands() {
  const Numbers<N> x = operands<N>(1003, 20);
  const Numbers<N> y = operands<N>(1003, 21);
  for (const BatchFunction<N>& f : all_functions<N>) {
    Numbers<N> want;
    Numbers<N> want_of_same;
    for (std::size_t i = 0; i < x.size(); ++i) {
      want.push_back(f.one(x[i], y[i]));
      want_of_same.push_back(f.one(x[i], x[i]));
    }
    for (const batch::path path : every_path) {
      Numbers<N> first = x;
      f.many(first, y, first, path);
      ASSERT_EQ(first, want) << f.name << " in place of x";
      Numbers<N> second = y;
      f.many(x, second, second, path);
      ASSERT_EQ(second, want) << f.name << " in place of y";
      Numbers<N> both = x;
      f.many(both, both, both, path);
      ASSERT_EQ(both, want_of_same) << f.name << " in place of both";
    }
  }
}

TEST(BatchFunctions, AResultMayReplaceAnOperand) {
  expect_results_may_replace_operands<q16_16>();
  expect_results_may_replace_operands<q2_30>();
  expect_results_may_replace_operands<q8_8>();
}

/// The words nearest to a tie, each in one lane of a block of others.
TEST(BatchFunctions, HardWords) {
  functions::for_each_hard_word(
      paths::source("tests/fixed/functions/hard_words.txt"),
      []<class N>(const functions::HardWord& word) {
        const BatchFunction<N>& f = functions::named(all_functions<N>, word.function);
        Numbers<N> x(16, N(0.5));
        x[5] = N::from_raw(static_cast<typename N::raw_type>(word.operand));
        for (const batch::path path : every_path) {
          Numbers<N> results(x.size());
          f.many(x, x, results, path);
          EXPECT_EQ(results[5].raw(), word.result) << f.name << " of raw " << word.operand;
          EXPECT_EQ(results[4], f.one(x[4], x[4])) << f.name;
        }
      });
}

/// A word next to a pole, in each lane of a block of others.
template <class N>
void expect_tangent(std::int64_t word, typename N::raw_type tangent) {
  constexpr std::size_t lanes = 16;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    Numbers<N> x(lanes, N(0.5));
    x[lane] = N::from_raw(static_cast<typename N::raw_type>(word));
    for (const batch::path path : every_path) {
      Numbers<N> results(lanes);
      batch::tan(x, results, path);
      EXPECT_EQ(results[lane].raw(), tangent) << word << " on path " << static_cast<int>(path);
      EXPECT_EQ(results[(lane + 1) % lanes], fixproof::tan(N(0.5)));
    }
  }
}

TEST(BatchFunctions, TangentsNextToPolesSaturate) {
  constexpr std::int32_t highest = std::numeric_limits<std::int32_t>::max();
  constexpr std::int32_t lowest = std::numeric_limits<std::int32_t>::min();
  expect_tangent<q2_30>(0x6487ed51, highest);
  expect_tangent<q2_30>(0x6487ed52, lowest);
  expect_tangent<q2_30>(-0x6487ed51, lowest);
  expect_tangent<q2_30>(-0x6487ed52, highest);
  expect_tangent<number<std::uint32_t, 30>>(0x6487ed51, 0xffffffff);
  expect_tangent<number<std::uint32_t, 30>>(0x6487ed52, 0);
  expect_tangent<u1_31>(0xc90fdaa2, 0xffffffff);
  expect_tangent<u1_31>(0xc90fdaa3, 0);
}

}  // namespace
}  // namespace batch_test

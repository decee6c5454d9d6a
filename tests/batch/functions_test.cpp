/// Compares the functions of batch/functions.hpp on every path with the functions of one number.
#include "tests/batch/functions.hpp"

#include <cfenv>
#include <fstream>
#include <sstream>

#include "fixed/formats.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

/// The ends of the range, small numbers, and words with any number of leading zeros.
template <class N>
Numbers<N> operands(std::size_t count, unsigned seed) {
  using raw = typename N::raw_type;
  std::mt19937 random(seed);
  Numbers<N> all{N(), std::numeric_limits<N>::lowest(), std::numeric_limits<N>::max()};
  while (all.size() < count) {
    const std::uint32_t word = static_cast<std::uint32_t>(random()) >> random() % 32;
    all.push_back(N::from_raw(static_cast<raw>(random() % 2 == 0 ? word : 0 - word)));
  }
  return all;
}

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

TEST(BatchFunctions, AResultMayReplaceAnOperand) {
  for (const BatchFunction<q16_16>& f : all_functions<q16_16>) {
    for (const batch::path path : every_path) {
      Numbers<q16_16> x = operands<q16_16>(1003, 20);
      const Numbers<q16_16> y = operands<q16_16>(1003, 21);
      Numbers<q16_16> want;
      for (std::size_t i = 0; i < x.size(); ++i) want.push_back(f.one(x[i], y[i]));
      f.many(x, y, x, path);
      ASSERT_EQ(x, want) << f.name;
    }
  }
}

/// Puts the operand into one lane of a block of others.
template <class N>
bool check_hard_word(const std::string& function, std::int64_t operand, std::int64_t result) {
  using raw = typename N::raw_type;
  for (const BatchFunction<N>& f : all_functions<N>) {
    if (function != f.name) continue;
    Numbers<N> x(16, N(0.5));
    x[5] = N::from_raw(static_cast<raw>(operand));
    for (const batch::path path : every_path) {
      Numbers<N> results(x.size());
      f.many(x, x, results, path);
      EXPECT_EQ(results[5].raw(), result) << function << " of raw " << operand;
      EXPECT_EQ(results[4], f.one(x[4], x[4])) << function;
    }
    return true;
  }
  return false;
}

/// The words nearest to a tie.
TEST(BatchFunctions, HardWords) {
  std::ifstream file(HARD_WORDS);
  std::string line;
  std::size_t words = 0;
  while (std::getline(file, line)) {
    if (line.starts_with('#')) continue;
    std::istringstream parts(line);
    std::string function;
    std::string format;
    std::int64_t operand = 0;
    std::int64_t result = 0;
    ASSERT_TRUE(parts >> function >> format >> operand >> result) << line;
    const bool known = format == "q8_8"     ? check_hard_word<q8_8>(function, operand, result)
                       : format == "q24_8"  ? check_hard_word<q24_8>(function, operand, result)
                       : format == "q16_16" ? check_hard_word<q16_16>(function, operand, result)
                       : format == "q8_24"  ? check_hard_word<q8_24>(function, operand, result)
                       : format == "q2_30"  ? check_hard_word<q2_30>(function, operand, result)
                                            : false;
    ASSERT_TRUE(known) << line;
    ++words;
  }
  EXPECT_GE(words, 396U);
}

/// As the functions of one number, under a policy that throws.
TEST(BatchFunctions, ThrowAsOneByOne) {
  for (const batch::path path : every_path) {
    Numbers<q16_16_trapping> x(40, q16_16_trapping(2));
    Numbers<q16_16_trapping> out(40);
    batch::exp(x, out, path);
    EXPECT_EQ(out[39], exp(q16_16_trapping(2)));
    x[21] = q16_16_trapping(11);
    EXPECT_THROW(batch::exp(x, out, path), overflow_error);
    x[21] = q16_16_trapping(-1);
    EXPECT_THROW(batch::log(x, out, path), domain_error);
    EXPECT_THROW(batch::rsqrt(x, out, path), domain_error);
  }
}

}  // namespace
}  // namespace batch_test

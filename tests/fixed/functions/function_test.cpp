/// Tests the functions of real numbers against the oracle, in formats of every width and with
/// fraction bits at both ends.
#include <fstream>
#include <sstream>

#include "tests/fixed/functions/functions.hpp"

namespace {

using namespace fixproof;
using functions::binary;
using functions::expected;
using functions::Named;
using functions::unary;

template <class N, std::size_t Size>
void expect_nearest(const std::array<Named<N>, Size>& functions, N x, N y = N(),
                    oracle::Rounding ties = oracle::Rounding::half_up) {
  for (const Named<N>& f : functions) {
    ASSERT_EQ(+f.compute(x, y).raw(), +expected(f.function, x, y, ties).raw())
        << f.name << " of raw " << +x.raw() << ' ' << +y.raw();
  }
}

template <class N>
class EveryFormat : public testing::Test {
 public:
  using raw = typename N::raw_type;

  /// A word of any length, so that small numbers and their negatives occur too.
  N word() {
    const auto bits = static_cast<std::int64_t>(random_());
    return N::from_raw(static_cast<raw>(bits >> (32 + random_() % 32)));
  }

  static std::vector<N> edges() {
    std::vector<N> words;
    for (int bit = 0; bit <= std::numeric_limits<raw>::digits; ++bit) {
      for (const int off : {-1, 0, 1}) {
        const std::int64_t word = (std::int64_t{1} << bit) + off;
        words.push_back(N::from_raw(static_cast<raw>(word)));
        words.push_back(N::from_raw(static_cast<raw>(-word)));
      }
    }
    return words;
  }

 private:
  std::mt19937_64 random_{1994};
};
using FunctionFormats =
    testing::Types<q8_0, q4_4, q1_7, u4_4, u0_8, q12_4, q8_8, q1_15, u8_8, u0_16, q32_0, q24_8,
                   q16_16, q8_24, q2_30, q1_31, u24_8, u16_16, u1_31, u0_32>;
TYPED_TEST_SUITE(EveryFormat, FunctionFormats);

TYPED_TEST(EveryFormat, FunctionsOfOneNumberAreNearest) {
  using N = TypeParam;
  if constexpr (sizeof(N) == 1) {
    for (int word = 0; word < 256; ++word) {
      expect_nearest(unary<N>, N::from_raw(static_cast<typename N::raw_type>(word)));
    }
  } else {
    for (const N x : this->edges()) expect_nearest(unary<N>, x);
    for (int i = 0; i < 150; ++i) expect_nearest(unary<N>, this->word());
    // Whole degrees, because some have rational sines.
    for (int degrees = -360; degrees <= 720; degrees += 15) expect_nearest(unary<N>, N(degrees));
  }
}

TYPED_TEST(EveryFormat, FunctionsOfTwoNumbersAreNearest) {
  using N = TypeParam;
  for (int i = 0; i < 250; ++i) {
    const N x = this->word();
    // Next to a diagonal, too.
    const auto close =
        static_cast<typename N::raw_type>(x.raw() + static_cast<typename N::raw_type>(i % 3));
    expect_nearest(binary<N>, x, i % 4 == 0 ? N::from_raw(close) : this->word());
  }
  const std::vector<N> edges = this->edges();
  for (std::size_t i = 0; i < edges.size(); i += 5) {
    for (std::size_t k = i % 7; k < edges.size(); k += 7) {
      expect_nearest(binary<N>, edges[i], edges[k]);
    }
  }
  // Powers, many of them rational.
  for (int i = -12; i <= 12; ++i) {
    for (int k = -12; k <= 12; ++k) expect_nearest(binary<N>, N(i) / N(2), N(k) / N(4));
  }
}

/// Checks a line of hard_words.txt: function, format, operand, result, distance.
template <class N>
bool check_hard_word(const std::string& function, std::int64_t operand, std::int64_t result) {
  for (const Named<N>& f : unary<N>) {
    if (function != f.name) continue;
    const N x = N::from_raw(static_cast<typename N::raw_type>(operand));
    EXPECT_EQ(f.compute(x, N()).raw(), result) << function << " of raw " << operand;
    EXPECT_EQ(expected(f.function, x, N(), oracle::Rounding::half_up).raw(), result);
    return true;
  }
  return false;
}

TEST(Functions, OfHardWordsAreNearest) {
  std::ifstream file(FUNCTIONS_FOLDER "/hard_words.txt");
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
  EXPECT_EQ(words, 432U);
}

}  // namespace

/// Tests the functions of real numbers against the oracle, in formats of every width and with
/// fraction bits at both ends.
#include "tests/fixed/functions/functions.hpp"
#include "tests/fixed/functions/hard_words.hpp"

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
TYPED_TEST_SUITE(EveryFormat, functions::Formats);

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

TEST(Functions, OfHardWordsAreNearest) {
  functions::for_each_hard_word(
      FUNCTIONS_FOLDER "/hard_words.txt", []<class N>(const functions::HardWord& word) {
        const Named<N>& f = functions::named(unary<N>, word.function);
        const N x = N::from_raw(static_cast<typename N::raw_type>(word.operand));
        EXPECT_EQ(f.compute(x, N()).raw(), word.result) << f.name << " of raw " << word.operand;
        EXPECT_EQ(expected(f.function, x, N(), oracle::Rounding::half_up).raw(), word.result);
      });
}

}  // namespace

/// Compares the functions with MPFR, which other authors wrote, in 300 digits.
#include <boost/multiprecision/mpfr.hpp>

#include "oracle/real_function.hpp"
#include "tests/fixed/functions/functions.hpp"
#include "tests/fixed/functions/hard_words.hpp"

namespace {

using namespace fixproof;
using functions::Named;
/// A number of 300 digits.
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<300>,
                                           boost::multiprecision::et_off>;

/// The result of MPFR, rounded half up and saturated.
template <class N>
std::int64_t by_mpfr(oracle::Function function, N x, N y) {
  constexpr std::int64_t lowest = std::numeric_limits<typename N::raw_type>::min();
  constexpr std::int64_t highest = std::numeric_limits<typename N::raw_type>::max();
  const auto real = [](N number) {
    return ldexp(Real(std::int64_t{number.raw()}), -N::fraction_bits);
  };
  const Real value = ldexp(oracle::real_function(function, real(x), real(y)), N::fraction_bits);
  // MPFR is off by less than 2^-900, so this makes every tie go up.
  const Real biased = floor(value + 0.5 + ldexp(Real(1), -900));
  if (biased >= highest) return highest;
  if (biased <= lowest) return lowest;
  return biased.convert_to<std::int64_t>();
}

template <class N, std::size_t Size>
void expect_equal(const std::array<Named<N>, Size>& all, int count) {
  std::mt19937_64 random(1994);
  const auto word = [&random] {
    const auto bits = static_cast<std::int64_t>(random());
    return N::from_raw(static_cast<typename N::raw_type>(bits >> (32 + random() % 32)));
  };
  for (int i = 0; i < count; ++i) {
    const N x = word();
    const N y = word();
    for (const Named<N>& f : all) {
      if (!oracle::in_domain<std::int64_t>(f.function, x.raw(), y.raw(), N::fraction_bits))
        continue;
      ASSERT_EQ(f.compute(x, y).raw(), by_mpfr(f.function, x, y))
          << f.name << " of raw " << +x.raw() << ' ' << +y.raw();
    }
  }
}

template <class N>
class Mpfr : public testing::Test {};
TYPED_TEST_SUITE(Mpfr, functions::Formats);

TYPED_TEST(Mpfr, GivesTheSameWords) {
  expect_equal(functions::unary<TypeParam>, 150);
  expect_equal(functions::binary<TypeParam>, 500);
}

TEST(MpfrHardWords, HaveTheSameResults) {
  functions::for_each_hard_word(
      FUNCTIONS_FOLDER "/hard_words.txt", []<class N>(const functions::HardWord& word) {
        const Named<N>& f = functions::named(functions::unary<N>, word.function);
        const N x = N::from_raw(static_cast<typename N::raw_type>(word.operand));
        EXPECT_EQ(by_mpfr(f.function, x, N()), word.result) << f.name << " of raw " << word.operand;
      });
}

}  // namespace

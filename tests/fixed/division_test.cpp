/// Tests division, by integers and by hardware doubles, in every rounding mode of the processor,
/// with the operands nearest to a change of the result.
#include "fixed/fixed.hpp"
#include "tests/fixed/exact.hpp"
#include "tests/fixed/types.hpp"
#include "tests/support/rounding_mode.hpp"
#include "tests/support/test.hpp"

namespace {

template <class Number>
class Division : public testing::Test {};
TYPED_TEST_SUITE(Division, fixproof::dividing_types);

TYPED_TEST(Division, IsExactInEveryRoundingMode) {
  for (const auto& [n, d] : exact::near_misses<TypeParam>()) {
    const auto expected = exact::quotient(n, d);
    for (const int mode : RoundingMode::all) {
      const RoundingMode set(mode);
      const auto result = exact::run<TypeParam>([n = n, d = d] { return n / d; });
      ASSERT_EQ(result, expected) << n << " / " << d << " in mode " << mode;
    }
  }
}

/// The form that batches use, whichever form operator/ takes.
template <class Number>
void divide_by_doubles() {
  using raw = typename Number::raw_type;
  for (const auto& [n, d] : exact::near_misses<Number>()) {
    const auto expected = exact::quotient(n, d).raw;
    for (const int mode : RoundingMode::all) {
      const RoundingMode set(mode);
      const raw result = fixproof::detail::total_divide<raw, Number::fraction_bits, Number::rules>(
          n.raw(), d.raw());
      ASSERT_EQ(result, expected) << n << " / " << d << " in mode " << mode;
    }
  }
}

TEST(DivisionByDoubles, WrappingAndSaturating) {
  divide_by_doubles<fixproof::q16_16>();
  divide_by_doubles<fixproof::q16_16_saturating>();
  divide_by_doubles<fixproof::q8_8>();
  divide_by_doubles<fixproof::q8_8_saturating>();
}

/// Checks that a loop, which the compiler may vectorise, agrees with single divisions.
template <class Number>
void divide_all(const std::vector<exact::Quotient<Number>>& pairs) {
  std::vector<Number> n, d, quotients(pairs.size());
  for (const auto& pair : pairs) {
    n.push_back(pair.n);
    d.push_back(pair.d);
  }
  for (const int mode : RoundingMode::all) {
    {
      const RoundingMode set(mode);
      for (std::size_t i = 0; i < pairs.size(); ++i) quotients[i] = n[i] / d[i];
    }
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      ASSERT_EQ(quotients[i].raw(), exact::quotient(n[i], d[i]).raw) << n[i] << " / " << d[i];
    }
  }
}

TEST(DivisionLoop, WrappingAndSaturating) {
  divide_all(exact::near_misses<fixproof::q16_16>());
  divide_all(exact::near_misses<fixproof::q16_16_saturating>());
  divide_all(exact::near_misses<fixproof::q8_8>());
  divide_all(exact::near_misses<fixproof::q8_8_saturating>());
}

TEST(DivisionByZero, GivesTheEndOnTheNumeratorsSide) {
  using fixproof::q16_16;
  using fixproof::q16_16_saturating;
  EXPECT_EQ((q16_16(1) / q16_16()).raw(), 0x7fffffff);
  EXPECT_EQ((q16_16::from_raw(-1) / q16_16()).raw(), -0x7fffffff - 1);
  EXPECT_EQ((q16_16() / q16_16()).raw(), 0);
  EXPECT_EQ((q16_16_saturating(-5) / q16_16_saturating()).raw(), -0x7fffffff - 1);
  EXPECT_EQ((q16_16_saturating() / q16_16_saturating()).raw(), 0);
  EXPECT_EQ((fixproof::q8_8(-1) / fixproof::q8_8()).raw(), -0x8000);
  EXPECT_EQ((fixproof::q8_8(1) / fixproof::q8_8()).raw(), 0x7fff);
}

}  // namespace

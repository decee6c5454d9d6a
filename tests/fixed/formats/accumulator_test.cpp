/// Tests accumulators that promise few terms against exact integers: terms at the ends of the
/// range, as many as promised, in each format and under each rule, and sums that do not fit.
#include <cstdint>
#include <limits>
#include <random>

#include "fixed/fixed.hpp"
#include "tests/fixed/formats/reference.hpp"
#include "tests/fixed/formats/types.hpp"
#include "tests/support/test.hpp"

namespace accumulator_test {

using fixproof::accumulator;
using fixproof::q16_16;
using fixproof::q1_15;
using fixproof::q2_30;
using fixproof::q8_8;
using reference::integer;
using reference::Type;

/// A sum of as many terms as it promises, and as many terms by the generator's choice.
template <class N, std::uint64_t Terms>
void expect_exact(std::mt19937_64& random) {
  const Type type = Type::of<N>();
  const auto operand = [&random] {
    using limits = std::numeric_limits<N>;
    if (random() % 4 == 0) return reference::number_of<N>(random());
    return random() % 2 == 0 ? limits::lowest() : limits::max();
  };
  accumulator<N, Terms> sum;
  integer expected = 0;
  // Always the same term in every fourth run, so that the sum reaches its limit.
  const bool is_one_term = random() % 4 == 0;
  const std::uint64_t kind = random() % 4;
  const N x = operand();
  const N y = operand();
  const std::uint64_t count = Terms < 40 ? Terms : 40;
  for (std::uint64_t i = 0; i < count; ++i) {
    const N a = is_one_term ? x : operand();
    const N b = is_one_term ? y : operand();
    const integer first = type.value(reference::word_of(a));
    const integer second = type.value(reference::word_of(b));
    switch (is_one_term ? kind : random() % 4) {
      case 0:
        sum.add(a);
        expected += first * type.one;
        break;
      case 1:
        sum.subtract(a);
        expected -= first * type.one;
        break;
      case 2:
        sum.add_product(a, b);
        expected += first * second;
        break;
      default:
        sum.subtract_product(a, b);
        expected -= first * second;
    }
  }
  ASSERT_EQ(reference::difference(
                type, reference::outcome([&] { return reference::word_of(sum.result()); }),
                reference::returned_product(type, expected)),
            "")
      << type << ", " << Terms << " terms";
  using To = fixproof::number<std::int32_t, 12>;
  const Type to = Type::of<To>();
  const integer ulps = reference::round(expected * to.one, type.one * type.one, to.rules.multiply);
  ASSERT_EQ(reference::difference(to, reference::word_of(sum.template result<To>()),
                                  reference::in_range(to, ulps, to.rules.product_range())),
            "")
      << type << ", " << Terms << " terms, as a number of 20.12";
}

template <class N>
struct FewTerms : testing::Test {};
TYPED_TEST_SUITE(FewTerms, formats::narrow);
template <class N>
struct FewWideTerms : testing::Test {};
TYPED_TEST_SUITE(FewWideTerms, formats::wide);

template <class N>
void expect_exact_of_few() {
  std::mt19937_64 random(8);
  for (int run = 0; run < 2000; ++run) {
    expect_exact<N, 1>(random);
    expect_exact<N, 8>(random);
    expect_exact<N, 39>(random);
  }
}
TYPED_TEST(FewTerms, AreSummedExactly) { expect_exact_of_few<TypeParam>(); }
TYPED_TEST(FewWideTerms, AreSummedExactly) { expect_exact_of_few<TypeParam>(); }

// By hand: terms of 2^14, 2^30 and 2^62, so many of them, and two bits. A sum of 4 or 8 bytes has
// as many more for what it remembers.
static_assert(sizeof(accumulator<fixproof::number<std::int8_t, 4>, 8>) == 8 &&
              sizeof(accumulator<q8_8, 8>) == 16 && sizeof(accumulator<q1_15, 8>) == 16 &&
              sizeof(accumulator<q1_15, 0xffffffff>) == 16 &&
              sizeof(accumulator<q1_15, 0x100000000>) == 16 &&
              sizeof(accumulator<q16_16, 1>) == 16 && sizeof(accumulator<q1_15>) == 16 &&
              sizeof(accumulator<q2_30, 5>) == 16);

/// Whether a sum of so many of the greatest products has a result, which it has unless it stops.
template <class N, std::uint64_t Terms>
constexpr bool fits(int terms) {
  accumulator<N, Terms> sum;
  for (int i = 0; i < terms; ++i) {
    sum.add_product(std::numeric_limits<N>::lowest(), std::numeric_limits<N>::lowest());
  }
  static_cast<void>(sum.result());
  return true;
}

// A sum of 32 bits stays below 2^30, so it has room for 65,535 terms of 2^14.
using q4_4 = fixproof::number<std::int8_t, 4>;
static_assert(fits<q4_4, 9>(9) && fits<q4_4, 9>(1000));

TEST(FewTermsDeathTest, StopBeforeASumIsWrong) {
  EXPECT_TRUE((fits<q4_4, 9>(65'535)));
  EXPECT_DEATH((fits<q4_4, 9>(65'536)), "");
  const auto subtract_often = [] {
    accumulator<q4_4, 9> sum;
    for (int i = 0; i < 80'000; ++i) sum.subtract_product(q4_4(-8), q4_4(-8));
    static_cast<void>(sum.result());
  };
  EXPECT_DEATH(subtract_often(), "");
  const auto come_back = [] {
    accumulator<q4_4, 9> sum;
    for (int i = 0; i < 65'536; ++i) sum.add_product(q4_4(-8), q4_4(-8));
    return sum.subtract_product(q4_4(-8), q4_4(-8)).result();
  };
  EXPECT_DEATH(come_back(), "");
}

// Sums of 64 bits, which so few terms never fill, from -2^62 to 2^62 - 1.
TEST(FewTermsDeathTest, WatchedSumsOf64BitsStop) {
  constexpr std::int64_t half = std::int64_t{1} << 61;
  fixproof::detail::watched_sum<std::int64_t> sum;
  sum.add(half);
  sum.add(half - 1);
  EXPECT_EQ(sum.value(), 2 * half - 1);
  auto above = sum;
  above.add(1);
  above.subtract(half);
  EXPECT_DEATH(static_cast<void>(above.value()), "");
  auto below = sum;
  for (int i = 0; i < 3; ++i) below.subtract(half);
  below.subtract(half - 1);
  EXPECT_EQ(below.value(), -2 * half);
  below.subtract(1);
  EXPECT_DEATH(static_cast<void>(below.value()), "");
}

}  // namespace accumulator_test

/// Tests division by hardware doubles in every rounding mode of the processor, with the operands
/// nearest to a change of the result.
#include <fenv.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "fixed/fixed.hpp"
#include "tests/fixed/exact.hpp"
#include "tests/fixed/types.hpp"

namespace {

/// Sets the rounding mode of the processor for its lifetime.
class rounding_mode {
 public:
  explicit rounding_mode(int mode) { EXPECT_EQ(fesetround(mode), 0); }
  rounding_mode(const rounding_mode&) = delete;
  rounding_mode& operator=(const rounding_mode&) = delete;
  ~rounding_mode() { fesetround(FE_TONEAREST); }
};

template <class Number>
struct operands {
  Number n, d;
};

/// Pairs whose quotient lies within 1 / (2 d) ulp of an integer or a half. Numerators are near k d
/// 2^-16 and (k + 1/2) d 2^-16. Divisors are near powers of two, odd or random.
template <class Number>
std::vector<operands<Number>> near_misses() {
  using raw = typename Number::raw_type;
  using exact::integer;
  std::mt19937_64 random(20);
  const integer unit = exact::one<Number>;
  const integer lowest = std::numeric_limits<raw>::min();
  const integer highest = std::numeric_limits<raw>::max();
  std::vector<operands<Number>> pairs;
  const auto add = [&](integer n, integer d) {
    if (n < lowest || n > highest || d < lowest || d > highest) return;
    pairs.push_back({Number::from_raw(static_cast<raw>(n)), Number::from_raw(static_cast<raw>(d))});
  };
  const auto around = [&](integer d) {
    for (int shift = 0; shift < std::numeric_limits<raw>::digits; shift += 2) {
      const integer k = static_cast<integer>(random()) >> (shift + 33);
      const integer n = (2 * k + 1) * d / (2 * unit);
      for (const int step : {-1, 0, 1}) {
        add(n + step, d);
        add(-n + step, d);
      }
    }
  };
  for (const auto edge : exact::edges<Number>()) around(edge.raw());
  for (int i = 0; i < 200; ++i) around(static_cast<raw>(random()));
  for (int i = 0; i < 4000; ++i) {
    add(static_cast<raw>(random()), static_cast<raw>(random()));
    add(static_cast<raw>(random()) >> (random() % 24),
        static_cast<raw>(random()) >> (random() % 24));
  }
  return pairs;
}

template <class Number>
class Division : public testing::Test {};
TYPED_TEST_SUITE(Division, fixed::all_types);

TYPED_TEST(Division, IsExactInEveryRoundingMode) {
  for (const auto& [n, d] : near_misses<TypeParam>()) {
    const auto expected = exact::quotient(n, d);
    for (const int mode : {FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO}) {
      const rounding_mode set(mode);
      const auto result = exact::run<TypeParam>([n = n, d = d] { return n / d; });
      ASSERT_EQ(result, expected) << n << " / " << d << " in mode " << mode;
    }
  }
}

/// Checks that a loop, which the compiler may vectorise, agrees with single divisions.
template <class Number>
void divide_all(const std::vector<operands<Number>>& pairs) {
  std::vector<Number> n, d, quotients(pairs.size());
  for (const auto& pair : pairs) {
    n.push_back(pair.n);
    d.push_back(pair.d);
  }
  for (const int mode : {FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO}) {
    {
      const rounding_mode set(mode);
      for (std::size_t i = 0; i < pairs.size(); ++i) quotients[i] = n[i] / d[i];
    }
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      ASSERT_EQ(quotients[i].raw(), exact::quotient(n[i], d[i]).raw) << n[i] << " / " << d[i];
    }
  }
}

TEST(DivisionLoop, WrappingAndSaturating) {
  divide_all(near_misses<fixed::q16_16>());
  divide_all(near_misses<fixed::q16_16_saturating>());
  divide_all(near_misses<fixed::q8_8>());
  divide_all(near_misses<fixed::q8_8_saturating>());
}

TEST(DivisionByZero, GivesTheEndOnTheNumeratorsSide) {
  using fixed::q16_16;
  using fixed::q16_16_saturating;
  EXPECT_EQ((q16_16(1) / q16_16()).raw(), 0x7fffffff);
  EXPECT_EQ((q16_16::from_raw(-1) / q16_16()).raw(), -0x7fffffff - 1);
  EXPECT_EQ((q16_16() / q16_16()).raw(), 0);
  EXPECT_EQ((q16_16_saturating(-5) / q16_16_saturating()).raw(), -0x7fffffff - 1);
  EXPECT_EQ((q16_16_saturating() / q16_16_saturating()).raw(), 0);
  EXPECT_EQ((fixed::q8_8(-1) / fixed::q8_8()).raw(), -0x8000);
  EXPECT_EQ((fixed::q8_8(1) / fixed::q8_8()).raw(), 0x7fff);
}

}  // namespace

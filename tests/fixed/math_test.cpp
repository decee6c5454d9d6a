/// Tests functions of numbers against exact fractions.
#include "fixed/fixed.hpp"
#include "tests/fixed/exact.hpp"
#include "tests/fixed/property.hpp"
#include "tests/fixed/types.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using exact::integer;

template <class Number>
class Math : public testing::Test {};
TYPED_TEST_SUITE(Math, some_types);

/// x rounded to a whole number by the rule.
template <class Number>
exact::outcome<Number> whole(Number x, rounding rule) {
  const integer unit = exact::one<Number>;
  return exact::in_range<Number>(exact::round({x.raw(), unit}, rule) * unit);
}

TYPED_TEST(Math, WholeNumbers) {
  const auto check = [](TypeParam x) {
    const auto same = [](exact::outcome<TypeParam> expected, const auto& call) {
      EXPECT_EQ(exact::run<TypeParam>(call), expected);
      return !testing::Test::HasFailure();
    };
    const integer unit = exact::one<TypeParam>;
    const integer up = -exact::below({-integer{x.raw()}, unit});
    constexpr bool away = TypeParam::rules.multiply == rounding::half_away;
    return same(whole(x, rounding::floor), [x] { return floor(x); }) &&
           same(whole(x, rounding::truncate), [x] { return trunc(x); }) &&
           same(exact::in_range<TypeParam>(up * unit), [x] { return ceil(x); }) &&
           same(whole(x, away ? rounding::half_away : rounding::half_up),
                [x] { return round(x); }) &&
           to_integer<rounding::floor>(x) == exact::round({x.raw(), unit}, rounding::floor) &&
           to_integer<rounding::half_up>(x) == exact::round({x.raw(), unit}, rounding::half_up) &&
           to_integer<rounding::half_away>(x) ==
               exact::round({x.raw(), unit}, rounding::half_away) &&
           to_integer<rounding::truncate>(x) == exact::round({x.raw(), unit}, rounding::truncate);
  };
  for (const auto x : exact::edges<TypeParam>()) ASSERT_TRUE(check(x)) << x;
  EXPECT_TRUE(property::for_all<TypeParam>(check));
}

TYPED_TEST(Math, AbsMinMax) {
  for (const auto a : exact::edges<TypeParam>()) {
    const integer raw = a.raw();
    EXPECT_EQ(exact::run<TypeParam>([a] { return abs(a); }),
              exact::in_range<TypeParam>(raw < 0 ? -raw : raw));
    for (const auto b : exact::edges<TypeParam>()) {
      ASSERT_EQ(min(a, b).raw(), a.raw() < b.raw() ? a.raw() : b.raw());
      ASSERT_EQ(max(a, b).raw(), a.raw() < b.raw() ? b.raw() : a.raw());
    }
  }
}

TYPED_TEST(Math, ClampsToALimit) {
  const auto edges = exact::edges<TypeParam>();
  for (const auto x : edges) {
    for (const auto low : edges) {
      const auto high = edges[edges.size() / 2];
      const auto above = x.raw() < low.raw() ? low.raw() : x.raw();
      ASSERT_EQ(clamp(x, low, high).raw(), above < high.raw() ? above : high.raw());
    }
  }
}

TYPED_TEST(Math, SquareRootIsNearest) {
  const auto check = [](TypeParam x) {
    if (x.raw() < 0) {
      constexpr bool trap = TypeParam::rules.range == overflow::trap;
      return exact::run<TypeParam>([x] { return sqrt(x); }) == exact::outcome<TypeParam>{trap, 0};
    }
    // The condition is |r - sqrt(n)| < 1/2, squared and times 4.
    const integer r = sqrt(x).raw();
    const integer n = integer{x.raw()} * exact::one<TypeParam>;
    if (n == 0) return r == 0;
    return r > 0 && (2 * r - 1) * (2 * r - 1) < 4 * n && 4 * n < (2 * r + 1) * (2 * r + 1);
  };
  for (const auto x : exact::edges<TypeParam>()) ASSERT_TRUE(check(x)) << x;
  EXPECT_TRUE(property::for_all<TypeParam>(check));
  // The root changes around k^2 and (k + 1/2)^2.
  for (std::int64_t k = 1; k < 2896; k += 7) {
    for (const std::int64_t step : {-1, 0, 1}) {
      const std::int64_t raw = (k * k + k / 2 * (k % 2)) / exact::one<TypeParam> + step;
      if (raw > std::numeric_limits<typename TypeParam::raw_type>::max()) continue;
      const auto x = TypeParam::from_raw(static_cast<typename TypeParam::raw_type>(raw));
      ASSERT_TRUE(check(x)) << x;
    }
  }
}

TYPED_TEST(Math, MulAddIsOneRounding) {
  const auto check = [](TypeParam a, TypeParam b, TypeParam c) {
    const integer unit = exact::one<TypeParam>;
    const auto expected =
        exact::result<TypeParam>({integer{a.raw()} * b.raw() + c.raw() * unit, unit});
    return exact::run<TypeParam>([&] { return mul_add(a, b, c); }) == expected;
  };
  const auto edges = exact::edges<TypeParam>();
  for (std::size_t i = 0; i < edges.size(); i += 3) {
    for (const auto b : edges) {
      for (std::size_t k = 1; k < edges.size(); k += 11) {
        ASSERT_TRUE(check(edges[i], b, edges[k])) << edges[i] << ' ' << b << ' ' << edges[k];
      }
    }
  }
  EXPECT_TRUE(property::for_all<TypeParam>(check));
}

TYPED_TEST(Math, LerpIsOneRounding) {
  const auto check = [](TypeParam a, TypeParam b, TypeParam t) {
    const integer unit = exact::one<TypeParam>;
    const integer parts = a.raw() * unit + (integer{b.raw()} - a.raw()) * t.raw();
    return exact::run<TypeParam>([&] { return lerp(a, b, t); }) ==
           exact::result<TypeParam>({parts, unit});
  };
  const auto edges = exact::edges<TypeParam>();
  for (const auto a : edges) {
    for (std::size_t i = 0; i < edges.size(); i += 3) {
      for (std::size_t k = 1; k < edges.size(); k += 11) {
        ASSERT_TRUE(check(a, edges[i], edges[k])) << a << ' ' << edges[i] << ' ' << edges[k];
      }
    }
    EXPECT_EQ(lerp(a, TypeParam::from_raw(77), TypeParam()), a);
    EXPECT_EQ(lerp(TypeParam::from_raw(77), a, TypeParam(1)), a);
  }
  EXPECT_TRUE(property::for_all<TypeParam>(check));
}

TYPED_TEST(Math, DotIsOneRounding) {
  const auto check = [](const std::vector<TypeParam>& a, const std::vector<TypeParam>& b) {
    integer sum = 0;
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
      sum += integer{a[i].raw()} * b[i].raw();
    }
    return exact::run<TypeParam>([&] { return dot(a, b); }) ==
           exact::result<TypeParam>({sum, exact::one<TypeParam>});
  };
  EXPECT_TRUE(property::for_all<TypeParam>(check));
  // Sums leave the 64-bit range in both directions and return.
  const auto lowest = std::numeric_limits<TypeParam>::lowest();
  const auto highest = std::numeric_limits<TypeParam>::max();
  for (const std::size_t length : {1U, 2U, 3U, 4U, 7U, 1000U}) {
    EXPECT_TRUE(check(std::vector(length, lowest), std::vector(length, lowest)));
    EXPECT_TRUE(check(std::vector(length, lowest), std::vector(length, highest)));
  }
  const auto tiny = TypeParam::from_raw(1);
  EXPECT_TRUE(
      check({lowest, lowest, tiny, lowest, lowest}, {lowest, lowest, tiny, highest, highest}));
}

TEST(Dot, TakesWhateverHoldsNumbers) {
  const std::array<q16_16, 3> a{q16_16(1), q16_16(2), q16_16(3)};
  const q16_16 b[] = {q16_16(4), q16_16(5), q16_16(6), q16_16(7)};
  const std::vector<q16_16> c(b, b + 2);
  EXPECT_EQ(dot(a, b), q16_16(32));
  EXPECT_EQ(dot(c, a), q16_16(14));
  EXPECT_EQ(dot(std::span(a), std::span(b).subspan(1)), q16_16(5 + 12 + 21));
  EXPECT_EQ(dot(std::span<const q16_16>(), a), q16_16());
}

}  // namespace

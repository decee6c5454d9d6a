/// Tests comparisons of exact values with numbers against fractions of big integers.
#include "fixed/exactness.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <compare>
#include <limits>
#include <random>
#include <vector>

#include "fixed/formats.hpp"
#include "fixed/power.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using boost::multiprecision::cpp_int;
using boost::multiprecision::cpp_rational;

template <class N>
cpp_rational value(N x) {
  return cpp_rational(x.raw()) / cpp_rational(cpp_int(1) << N::fraction_bits);
}

int sign(const cpp_rational& x) { return x.sign(); }
int sign(std::partial_ordering order) { return order < 0 ? -1 : order > 0 ? 1 : 0; }

/// The ends of the range, the numbers around zero and one, and random ones of every length.
template <class N>
std::vector<N> random_numbers(std::uint64_t seed) {
  using raw = typename N::raw_type;
  using limits = std::numeric_limits<raw>;
  std::vector<N> all;
  for (const int small : {0, 1, 2, 3}) {
    all.push_back(N::from_raw(static_cast<raw>(small)));
    all.push_back(N::from_raw(static_cast<raw>(limits::max() - small)));
    all.push_back(N::from_raw(static_cast<raw>(limits::min() + small)));
    if constexpr (limits::is_signed) all.push_back(N::from_raw(static_cast<raw>(-small)));
  }
  std::mt19937_64 random(seed);
  for (int i = 0; i < 16; ++i) {
    all.push_back(N::from_raw(static_cast<raw>(static_cast<raw>(random()) >> (i % 8 * 2))));
  }
  return all;
}

/// Compares with r, and with the numbers beside it, so that every comparison is also a near one.
template <class R, class Check>
void near(R r, const Check& check) {
  using raw = typename R::raw_type;
  using limits = std::numeric_limits<raw>;
  check(r);
  if (r.raw() != limits::max()) check(R::from_raw(static_cast<raw>(r.raw() + 1)));
  if (r.raw() != limits::min()) check(R::from_raw(static_cast<raw>(r.raw() - 1)));
}

template <class A, class B, class R>
void compare_all() {
  int equal = 0;
  for (const A a : random_numbers<A>(1)) {
    for (const B b : random_numbers<B>(2)) {
      const cpp_rational x = value(a);
      const cpp_rational y = value(b);
      near(add<R>(a, b), [&](R r) {
        ASSERT_EQ(sign(compare_sum(a, b, r)), sign(x + y - value(r))) << x << " + " << y;
      });
      near(subtract<R>(a, b), [&](R r) {
        ASSERT_EQ(sign(compare_difference(a, b, r)), sign(x - y - value(r))) << x << " - " << y;
      });
      near(multiply<R>(a, b), [&](R r) {
        equal += compare_product(a, b, r) == 0 ? 1 : 0;
        ASSERT_EQ(sign(compare_product(a, b, r)), sign(x * y - value(r))) << x << " * " << y;
      });
      if (y == 0) {
        ASSERT_EQ(compare_quotient(a, b, R()), std::partial_ordering::unordered);
        continue;
      }
      near(divide<R>(a, b), [&](R r) {
        ASSERT_EQ(sign(compare_quotient(a, b, r)), sign(x / y - value(r))) << x << " / " << y;
      });
    }
  }
  EXPECT_GT(equal, 0);
}

TEST(Exactness, OfArithmetic) {
  compare_all<q16_16, q16_16, q16_16>();
  compare_all<q8_8, q2_30, q16_16>();
  compare_all<u16_16, q1_15, q24_8>();
  compare_all<q32_32, q48_16, q32_32>();
  compare_all<q32_32, number<std::uint64_t, 64>, number<std::uint64_t, 0>>();
}

template <class A, class R>
void compare_values_and_roots() {
  for (const A a : random_numbers<A>(3)) {
    const cpp_rational x = value(a);
    near(R(a), [&](R r) { ASSERT_EQ(sign(compare_value(a, r)), sign(x - value(r))) << x; });
    if (a.raw() < 0) {
      ASSERT_EQ(compare_sqrt(a, R()), std::partial_ordering::unordered);
      continue;
    }
    near(sqrt<R>(a), [&](R r) {
      const cpp_rational root = value(r);
      const int expected = root < 0 ? 1 : sign(x - root * root);
      ASSERT_EQ(sign(compare_sqrt(a, r)), expected) << x;
    });
  }
}

TEST(Exactness, OfConversionsAndRoots) {
  compare_values_and_roots<q16_16, q8_8>();
  compare_values_and_roots<q8_8, q16_16>();
  compare_values_and_roots<q2_30, u0_32>();
  compare_values_and_roots<q32_32, q16_48>();
  compare_values_and_roots<number<std::uint64_t, 64>, q48_16>();
}

}  // namespace

/// Tests the FIXED.ASM presets against the results worked by hand.
#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"
#include "tests/support/worked.hpp"

namespace {

using namespace fixproof;
using worked::Answer;
using worked::Row;

/// A number from its two's complement word.
template <class Number>
constexpr Number word(std::uint32_t bits) {
  return Number::from_raw(static_cast<typename Number::raw_type>(bits));
}

template <class On, class Off>
void expect_product(const Row& p, Answer on, Answer off) {
  EXPECT_EQ(word<On>(p.a) * word<On>(p.b), word<On>(*on)) << std::hex << p.a << ' ' << p.b;
  EXPECT_EQ(word<Off>(p.a) * word<Off>(p.b), word<Off>(*off)) << std::hex << p.a << ' ' << p.b;
}

TEST(Presets, Products) {
  for (const Row& p : worked::products) {
    expect_product<q16_16_i386, q16_16_i386_unrounded>(p, p.i386_on, p.i386_off);
    expect_product<q16_16_i386_mul_rounded, q16_16_i386_div_rounded>(p, p.i386_on, p.i386_off);
    expect_product<q16_16_i8088, q16_16_i8088_unrounded>(p, p.i8088_on, p.i8088_off);
    expect_product<q16_16_i8088_mul_rounded, q16_16_i8088_div_rounded>(p, p.i8088_on, p.i8088_off);
  }
}

template <class On, class Off>
void expect_quotient(const Row& q, Answer on, Answer off) {
  const auto check = [&q]<class Number>(Number, Answer expected) {
    const auto n = word<Number>(q.a);
    const auto d = word<Number>(q.b);
    const auto tried = try_divide(n, d);
    ASSERT_EQ(tried.has_value(), expected.has_value()) << std::hex << q.a << " / " << q.b;
    if (expected) {
      EXPECT_EQ(*tried, word<Number>(*expected)) << std::hex << q.a << " / " << q.b;
      EXPECT_EQ(n / d, word<Number>(*expected)) << std::hex << q.a << " / " << q.b;
    } else {
      EXPECT_THROW(static_cast<void>(n / d), divide_error) << std::hex << q.a << " / " << q.b;
    }
  };
  check(On(), on);
  check(Off(), off);
}

TEST(Presets, Quotients) {
  for (const Row& q : worked::quotients) {
    expect_quotient<q16_16_i386, q16_16_i386_unrounded>(q, q.i386_on, q.i386_off);
    expect_quotient<q16_16_i386_div_rounded, q16_16_i386_mul_rounded>(q, q.i386_on, q.i386_off);
    expect_quotient<q16_16_i8088, q16_16_i8088_unrounded>(q, q.i8088_on, q.i8088_off);
    expect_quotient<q16_16_i8088_div_rounded, q16_16_i8088_mul_rounded>(q, q.i8088_on, q.i8088_off);
  }
}

TEST(Presets, HalfWidth) {
  for (const Row& p : worked::half_products) {
    expect_product<q8_8_i386, q8_8_i386_unrounded>(p, p.i386_on, p.i386_off);
    expect_product<q8_8_i386_mul_rounded, q8_8_i386_div_rounded>(p, p.i386_on, p.i386_off);
    expect_product<q8_8_i8088, q8_8_i8088_unrounded>(p, p.i8088_on, p.i8088_off);
    expect_product<q8_8_i8088_mul_rounded, q8_8_i8088_div_rounded>(p, p.i8088_on, p.i8088_off);
  }
  for (const Row& q : worked::half_quotients) {
    expect_quotient<q8_8_i386, q8_8_i386_unrounded>(q, q.i386_on, q.i386_off);
    expect_quotient<q8_8_i386_div_rounded, q8_8_i386_mul_rounded>(q, q.i386_on, q.i386_off);
    expect_quotient<q8_8_i8088, q8_8_i8088_unrounded>(q, q.i8088_on, q.i8088_off);
    expect_quotient<q8_8_i8088_div_rounded, q8_8_i8088_mul_rounded>(q, q.i8088_on, q.i8088_off);
  }
}

}  // namespace

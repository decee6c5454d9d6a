/// Tests the operations of fixed/checked.hpp and fixed/wide.hpp, the remainder and the shifts
/// against exact integers in every format.
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "fixed/fixed.hpp"
#include "tests/fixed/formats/reference.hpp"
#include "tests/fixed/formats/types.hpp"
#include "tests/support/test.hpp"

namespace {

using fixproof::overflow;
using reference::integer;

/// The four forms of one operation.
template <class N>
struct Forms {
  std::optional<N> checked;
  fixproof::overflowing<N> flagged;
  N saturating;
  N wrapping;
};

/// Whether the forms are right for an exact result.
template <class N>
bool right(const Forms<N>& forms, const integer& exact) {
  const auto wrapped = reference::in_range<N>(exact, overflow::wrap);
  const auto trapped = reference::in_range<N>(exact, overflow::trap);
  if (forms.checked.has_value() != trapped.has_value()) return false;
  if (trapped && reference::raw(*forms.checked) != *trapped) return false;
  return forms.flagged.overflow == !trapped && reference::raw(forms.flagged.value) == wrapped &&
         reference::raw(forms.wrapping) == wrapped &&
         reference::raw(forms.saturating) == reference::in_range<N>(exact, overflow::saturate);
}

template <class N>
std::string first_wrong(N a, N b, N c) {
  using namespace fixproof;  // NOLINT(google-build-using-namespace)
  const integer x = reference::raw(a);
  const integer y = reference::raw(b);
  const integer z = reference::raw(c);
  const integer one = reference::one<N>();
  const auto product = [&](const integer& n) {
    return reference::round(n, one, N::rules.multiply);
  };
  const auto is = [](const Forms<N>& forms, const integer& exact) { return right(forms, exact); };
  if (!is({checked_add(a, b), overflowing_add(a, b), saturating_add(a, b), wrapping_add(a, b)},
          x + y))
    return "add";
  if (!is({checked_subtract(a, b), overflowing_subtract(a, b), saturating_subtract(a, b),
           wrapping_subtract(a, b)},
          x - y))
    return "subtract";
  if (!is({checked_multiply(a, b), overflowing_multiply(a, b), saturating_multiply(a, b),
           wrapping_multiply(a, b)},
          product(x * y)))
    return "multiply";
  if (!is({checked_mul_add(a, b, c), overflowing_mul_add(a, b, c), saturating_mul_add(a, b, c),
           wrapping_mul_add(a, b, c)},
          product(x * y + z * one)))
    return "mul_add";
  if (!is({checked_negate(a), overflowing_negate(a), saturating_negate(a), wrapping_negate(a)}, -x))
    return "negate";
  if (!is({checked_abs(a), overflowing_abs(a), saturating_abs(a), wrapping_abs(a)}, x < 0 ? -x : x))
    return "abs";
  for (const int places : {0, 1, 7, 31, 63, 64, 300}) {
    if (!is({checked_shift_left(a, places), overflowing_shift_left(a, places),
             saturating_shift_left(a, places), wrapping_shift_left(a, places)},
            x * reference::power(2, places)))
      return "shift_left";
    const integer shifted = reference::below(x, reference::power(2, places));
    if (reference::raw(a >> places) != shifted || reference::raw(a << -places) != shifted)
      return "a >> places";
    if (!is({checked_shift_left(a, -places), overflowing_shift_left(a, -places),
             saturating_shift_left(a, -places), wrapping_shift_left(a, -places)},
            shifted))
      return "shift_left by a negative number";
    const auto left = reference::in_range<N>(x * reference::power(2, places), N::rules.range);
    if (reference::outcome([&] { return a << places; }) != left) return "a << places";
  }
  const Forms<N> quotient{checked_divide(a, b), overflowing_divide(a, b), saturating_divide(a, b),
                          wrapping_divide(a, b)};
  if (y == 0) {
    using limits = std::numeric_limits<typename N::raw_type>;
    const integer end = x == 0  ? integer(0)
                        : x < 0 ? integer(limits::min())
                                : integer(limits::max());
    if (quotient.checked || !quotient.flagged.overflow) return "divide by zero";
    for (const N& value : {quotient.flagged.value, quotient.saturating, quotient.wrapping}) {
      if (reference::raw(value) != end) return "divide by zero";
    }
    if (checked_remainder(a, b)) return "checked_remainder";
    const bool throws = N::rules.quotient_range() == overflow::trap;
    if (reference::outcome([&] { return a % b; }).has_value() == throws) return "a % 0";
  } else {
    const integer n = y < 0 ? -x : x;
    const integer d = y < 0 ? -y : y;
    if (!is(quotient, reference::round(n * one, d, N::rules.divide))) return "divide";
    const integer rest = x % y;  // truncated
    if (reference::raw(a % b) != rest) return "a % b";
    if (!checked_remainder(a, b) || reference::raw(*checked_remainder(a, b)) != rest)
      return "checked_remainder";
  }
  if (x < 0 && checked_sqrt(a)) return "checked_sqrt";
  if (x >= 0) {
    const auto root = reference::in_range<N>(reference::root(x * one), overflow::trap);
    const auto given = checked_sqrt(a);
    if (given.has_value() != root.has_value()) return "checked_sqrt";
    if (root && reference::raw(*given) != *root) return "checked_sqrt";
  }
  // a * b / c is a quotient whose numerator is in units of 2^-F already.
  std::optional<integer> scaled = reference::quotient<N>(x * y, z * one);
  if (reference::outcome([&] { return mul_div(a, b, c); }) != scaled) return "mul_div";
  accumulator<N> sum;
  sum.add_product(a, b).subtract_product(b, c).add(a).subtract(c).add_product(a, a);
  const auto expected = reference::in_range<N>(product(x * y - y * z + (x - z) * one + x * x),
                                               N::rules.product_range());
  if (reference::outcome([&] { return sum.result(); }) != expected) return "accumulator";
  return {};
}

template <class N>
class CheckedFormats : public testing::Test {};
TYPED_TEST_SUITE(CheckedFormats, formats::wide);

TYPED_TEST(CheckedFormats, EdgesAndRandomNumbers) {
  const auto values = reference::operands<TypeParam>(25);
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      const TypeParam c = values[(i * 7 + k * 3) % values.size()];
      ASSERT_EQ(first_wrong(values[i], values[k], c), "")
          << values[i] << ", " << values[k] << ", " << c;
    }
  }
}

TYPED_TEST(CheckedFormats, RatiosAndRemaindersOfIntegers) {
  const auto integers = reference::operands<fixproof::number<std::int64_t, 0>>(20);
  for (const auto n : integers) {
    for (const auto d : integers) {
      const auto expected = reference::quotient<TypeParam>(reference::raw(n), reference::raw(d));
      ASSERT_EQ(reference::outcome([&] { return fixproof::ratio<TypeParam>(n.raw(), d.raw()); }),
                expected)
          << n << " / " << d;
    }
    if (n.raw() == 0) continue;
    for (const TypeParam x : reference::operands<TypeParam>(10)) {
      const integer expected =
          reference::raw(x) % (reference::raw(n) * reference::one<TypeParam>());
      ASSERT_EQ(reference::raw(x % n.raw()), expected) << x << " % " << n;
    }
  }
}

TEST(StickyStatus, RemembersUntilItIsCleared) {
  using fixproof::q16_16;
  fixproof::sticky_status status;
  EXPECT_EQ(status.add(q16_16(1), q16_16(2)), 3);
  EXPECT_FALSE(status.overflow());
  EXPECT_EQ(status.subtract(q16_16(-32768), q16_16(1)), 32767);
  EXPECT_TRUE(status.overflow());
  EXPECT_EQ(status.multiply(q16_16(2), q16_16(3)), 6);
  EXPECT_TRUE(status.overflow());
  status.clear();
  EXPECT_FALSE(status.overflow());
  EXPECT_EQ(status.divide(q16_16(1), q16_16()), std::numeric_limits<q16_16>::max());
  EXPECT_TRUE(status.overflow());
}

// Only the zero divisor of a processor's divide is an error there.
TEST(MulDivAndRatio, HaveNoQuotientFault) {
  using fixproof::q16_16_i386_unrounded;
  using N = q16_16_i386_unrounded;
  EXPECT_THROW(static_cast<void>(N(30000) / N(0.25)), fixproof::divide_error);
  EXPECT_EQ(mul_div(N(30000), N(1), N(0.25)), N(120000 - 131072));
  EXPECT_EQ(fixproof::ratio<N>(120000, 1), N(120000 - 131072));
  EXPECT_THROW(static_cast<void>(mul_div(N(1), N(1), N(0))), fixproof::divide_error);
}

/// Expects the results of 5 / 2 and of -5 / 2.
template <fixproof::rounding R, class Raw = std::int32_t>
void expect_halves(std::int32_t positive, std::int32_t negative) {
  using N = fixproof::number<Raw, 0, fixproof::policy{.divide = R}>;
  EXPECT_EQ(mul_div(N(5), N(3), N(6)).raw(), positive);
  EXPECT_EQ(mul_div(N(-5), N(-3), N(6)).raw(), positive);
  EXPECT_EQ(mul_div(N(-5), N(3), N(6)).raw(), negative);
  EXPECT_EQ(mul_div(N(5), N(3), N(-6)).raw(), negative);
}

TEST(MulDivAndRatio, TiesFollowThePolicy) {
  using fixproof::rounding;
  expect_halves<rounding::half_up>(3, -2);
  expect_halves<rounding::half_away>(3, -3);
  expect_halves<rounding::half_even>(2, -2);
  expect_halves<rounding::truncate>(2, -2);
  expect_halves<rounding::floor>(2, -3);
  expect_halves<rounding::half_away, std::int8_t>(3, -3);
}

TEST(MulDivAndRatio, HoldsTheLargestProducts) {
  const auto lowest = fixproof::q32_0::from_raw(std::numeric_limits<std::int32_t>::min());
  EXPECT_EQ(mul_div(lowest, lowest, lowest), lowest);
  const auto highest =
      fixproof::number<std::uint32_t, 0>::from_raw(std::numeric_limits<std::uint32_t>::max());
  EXPECT_EQ(mul_div(highest, highest, highest), highest);
}

TEST(Literals, AreExactOrRounded) {
  using namespace fixproof::literals;  // NOLINT(google-build-using-namespace)
  using namespace fixproof;            // NOLINT(google-build-using-namespace)
  static_assert(1.5_q16_16 == q16_16(1.5) && -0.25_q2_30 == q2_30(-0.25));
  static_assert((0.1_q16_16_rounded).raw() == 6554);
  static_assert(1'000_q24_8 == 1000 && 0_q16_16 == 0 && 10.50_q8_8 == q8_8(10.5));
  static_assert(.5_q8_8 == q8_8(0.5) && 2._q8_8 == 2 && 007_q8_8 == 7);
  static_assert((0.00001_q1_7_rounded).raw() == 0);
  // 1/512 is half an ulp of 8.8, and 3/512 three halves: ties go to the even neighbour.
  static_assert((0.001953125_q8_8_rounded).raw() == 0 && (0.005859375_q8_8_rounded).raw() == 2);
  static_assert((1.5_q32_0_rounded).raw() == 2 && (2.5_q8_0_rounded).raw() == 2);
  static_assert((-3.5_q8_0_rounded).raw() == -4);
  static_assert(0.0000000000000000000542101086242752217003726400434970855712890625_u0_64 ==
                fixproof::u0_64::from_raw(1));
  SUCCEED();
}

}  // namespace
